#pragma once

#include <filesystem>
#include <vector>

#include "comparisons/command_line/exit_status.hpp"
#include "comparisons/formats/table.hpp"
#include "comparisons/running/case_result.hpp"

namespace springcheck {

/// Makes the report's folder. Throws InputError where that or what the report writes into
/// it is not possible, it has a page of somebody else, or Python is lacking.
void prepare_report(const std::filesystem::path& folder);

/// Writes into a folder that is prepared
///
///     tables/NAME.md .csv .json .tex   what the file's cases fill, see stored_tables;
///                                      the further tables; of tables without cases
///                                      those in tables/ beside the file
///     data/theory.json                 see theory_curves
///     index.html, figures/, 3d/        by the program of reports/
///     3d/cases.xdmf                    for ParaView, all cases with fields
///
/// Computes no case. Says where to start, or returns fell_short where the program of
/// reports/ did.
ExitStatus make_report(const std::filesystem::path& file,
                       const std::filesystem::path& folder,
                       const std::vector<Table>& further, Revisions revisions);

}  // namespace springcheck
