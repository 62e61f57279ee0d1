#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/commands/commands.hpp"

namespace springcheck {

/// `springcheck export`: writes the cases of a result file as a table for other programs,
/// in the format of the extension, see case_table for the columns. Throws InputError for
/// another extension, an unknown column, and where there are no cases to be taken.
///
///     .csv      RFC 4180; the head has units, "plate_force_norm [N]"
///     .parquet  Apache Parquet; the same names, with nulls
///     .json     {"columns": [{"name", "unit"}], "cases": [{name: value}]}
ExitStatus export_command(const std::filesystem::path& results,
                          const std::filesystem::path& out,
                          const std::vector<std::string>& columns, Revisions revisions);

}  // namespace springcheck
