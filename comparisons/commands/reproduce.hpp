#pragma once

#include <filesystem>

#include "comparisons/commands/commands.hpp"

namespace springcheck {

/// Whether the tables that take many minutes (long_sheet_names) are among the tables.
enum class Extent { without_long_tables, all };

/// `springcheck reproduce`: regenerates everything into `directory`, created if need be:
///
///     index.html          the report of results.h5, with tables/ and data/, see
///                         make_report
///     summary.md          what was computed, what agrees with the thesis, what fails
///     results.h5 .xdmf    every case of the tables, with its fields, and those of the
///                         shipped sweeps nu, refinement, deformation, diagonal-ratio and
///                         beam-diagonal-ratio, with settings and provenance
///
/// Cases go into results.h5 as they come; those that are there already are taken, if this
/// very program computed them, so that an interrupted run goes on where it was.
/// Throws InputError before computing when the directory cannot be written.
ExitStatus reproduce_command(const std::filesystem::path& directory, Extent extent,
                             int parallel);

}  // namespace springcheck
