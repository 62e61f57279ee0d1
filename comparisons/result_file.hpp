#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "comparisons/study.hpp"

namespace springcheck {

/// HDF5 layout 1, documented in the README's reference part:
///
///     /                    attributes: layout, springcheck version, provenance
///     /meshes/SHA256       nodes, hexahedra, regions/NAME
///     /cases/KEY           attributes: settings, status, measures, times;
///                          displacement, reaction (or partial_ of both, when the case
///                          ended without an equilibrium), cell_volume_ratio
///
/// Writes the results and beside it FILE.xdmf for ParaView. Both are written under
/// another name and renamed, so that an unfinished file never replaces a good one.
void write_results(const std::filesystem::path& file,
                   const std::vector<CaseResult>& results, MeshStore& meshes);

/// What a result file knows about a case, by its key.
struct StoredCase {
  Status status;
  std::vector<Status> flags;
  std::string reason;
  Measures measures;
  double wrinkle_alternation, wrinkle_amplitude;
  double load_fraction;
  int steps, force_evaluations;
  std::optional<double> dt, dt_limit;
  double wall_s, solve_wall_s;
};

/// The cases of a result file by key, without fields. Throws InputError for a file that
/// is not HDF5, not ours, damaged, or of another layout.
std::map<std::string, StoredCase> read_results(const std::filesystem::path& file);

/// The stored case as a CaseResult of this request, without fields.
CaseResult with_stored(const Request& request, const std::string& key,
                       const StoredCase& stored);

}  // namespace springcheck
