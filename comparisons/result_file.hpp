#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

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
/// Writes the results and beside them FILE.xdmf for ParaView, each whole or not at all.
void write_results(const std::filesystem::path& file,
                   const std::vector<CaseResult>& results, MeshStore& meshes);

/// Throws InputError unless write_results could write both files.
void check_results_writable(const std::filesystem::path& file);

/// What a result file knows about a case, by its key.
struct StoredCase {
  Status status;
  std::vector<Status> flags;
  std::string reason;
  Measures measures;
  double load_fraction;
  int steps, force_evaluations;
  std::optional<int> linear_iterations;
  std::optional<double> dt, dt_limit;
  double wall_s, solve_wall_s;
};

/// The cases of a result file by key, without fields. Throws InputError for a file that
/// is not HDF5, not ours, damaged, or of another layout.
std::map<std::string, StoredCase> read_results(const std::filesystem::path& file);

/// The commit of the program that wrote the file. Throws InputError like read_results.
std::string commit_of(const std::filesystem::path& file);

/// The stored case as a CaseResult of this request, without fields.
CaseResult with_stored(const Request& request, const std::string& key,
                       const StoredCase& stored);

/// Gives the result, whose key is in the file, the fields that are stored for it. Throws
/// InputError when they are not those of the mesh.
void read_fields(const std::filesystem::path& file, const Mesh& mesh, CaseResult& result);

}  // namespace springcheck
