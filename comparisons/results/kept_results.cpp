#include "comparisons/results/kept_results.hpp"

#include <spdlog/spdlog.h>

namespace springcheck {

KeptResults::KeptResults(const std::filesystem::path& file, MeshStore& meshes)
    : path_(file), file_(file), meshes_(meshes) {
  check_xdmf_writable(file);
}

void KeptResults::keep(const CaseResult& result) {
  if (kept_.insert(result.key).second) file_.put({&result, 1}, true, meshes_);
}

void KeptResults::finish(std::span<const CaseResult> results,
                         std::span<const std::filesystem::path> from) {
  std::set<std::string> taken;
  for (const CaseResult& result : results)
    if (!kept_.contains(result.key)) taken.insert(result.key);
  for (const std::filesystem::path& file : from)
    for (const std::string& conflict : file_.absorb(file, &taken).conflicts)
      spdlog::warn("kept as {} had it: {}", path_.string(), conflict);
  write_xdmf_beside(path_);
}

}  // namespace springcheck
