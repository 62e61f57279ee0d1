#pragma once

#include <filesystem>

#include "comparisons/command_line/exit_status.hpp"

namespace springcheck {

/// How much `springcheck reproduce` computes.
enum class Extent {
  quick,                // the thesis's tables alone: the five tests
  without_long_tables,  // and ours but for long ones, sweeps, charts and a map
  all                   // and those
};

/// `springcheck reproduce`: regenerates everything into `directory`, created if need be:
///
///     index.html          the report of results.h5, with tables/ and data/, see
///                         make_report
///     summary.md          what was computed, what agrees with the thesis, what fails
///     results.h5 .xdmf    every case of the tables, with its fields, those of the
///                         shipped sweeps nu, refinement, deformation, diagonal-ratio and
///                         beam-diagonal-ratio, quick charts (quick_plan) of compression,
///                         shearing and torsion, and a map of how springs and elements
///                         fail in compression, over deformation and nu; with settings
///                         and provenance
///
/// A results.h5 with cases of other revisions of the numerics is kept under another name
/// (results-REVISION.h5), since charts are of one.
///
/// It says on stderr which stage it is in and about how long the rest takes. Cases go
/// into results.h5 as they come; those that are there already are taken, if this very
/// program computed them, so that an interrupted run goes on where it was.
/// Throws InputError before computing when the directory cannot be written.
ExitStatus reproduce(const std::filesystem::path& directory, Extent extent, int parallel);

}  // namespace springcheck
