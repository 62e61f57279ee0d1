#include "comparisons/results/kept_results.hpp"

namespace springcheck {

KeptResults::KeptResults(const std::filesystem::path& file, MeshStore& meshes)
    : path_(file), file_(file), meshes_(meshes) {
  check_xdmf_writable(file);
}

void KeptResults::keep(const CaseResult& result) {
  if (kept_.insert(result.key).second) file_.put({&result, 1}, true, meshes_);
}

void KeptResults::finish(std::span<const CaseResult> results) {
  for (const CaseResult& result : results) keep(result);
  write_xdmf_beside(path_);
}

}  // namespace springcheck
