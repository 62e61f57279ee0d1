#include "comparisons/chart/kept_truths.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "comparisons/build_info/build_info.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

constexpr std::uintmax_t most_bytes = 500'000'000;

bool is_finite(const CaseResult& result) {
  const Solution& solution = result.solution;
  return std::ranges::all_of(solution.displacements,
                             [](const Vector3& one) { return one.allFinite(); }) &&
         std::ranges::all_of(solution.cell_volumes,
                             [](double one) { return std::isfinite(one); });
}

}  // namespace

KeptTruths::KeptTruths(std::filesystem::path file) : file_(std::move(file)) {
  try {
    if (!std::filesystem::exists(file_)) return;
    if (std::filesystem::file_size(file_) > most_bytes)
      std::filesystem::remove(file_);
    else
      stored_ = stored_cases({file_}, Revisions::own);
  } catch (const std::exception& error) {
    leave_alone(error);
  }
}

std::optional<CaseResult> KeptTruths::known(const Request& request,
                                            const std::string& key, MeshStore& meshes) {
  if (is_left_alone_) return std::nullopt;
  try {
    auto result = only_with_fields(known_from(stored_, meshes))(request, key);
    if (!result || is_finite(*result)) return result;
    throw InputError(file_.string(), "fields of case " + key, "finite numbers", "others");
  } catch (const std::exception& error) {
    leave_alone(error);
    return std::nullopt;
  }
}

void KeptTruths::keep(const CaseResult& result, MeshStore& meshes) {
  if (is_left_alone_ || stored_.contains(result.key) || result.status != Status::ok)
    return;
  try {
    std::filesystem::create_directories(file_.parent_path());
    ResultFile(file_).put({&result, 1}, true, meshes);
  } catch (const std::exception& error) {
    leave_alone(error);
  }
}

void KeptTruths::leave_alone(const std::exception& why) {
  is_left_alone_ = true;
  spdlog::warn(
      "converged solutions are not kept for other scenes: {}. {} may be removed.",
      why.what(), file_.string());
}

std::optional<std::filesystem::path> users_truths_file() {
  const auto folder_in = [](const char* variable) -> std::filesystem::path {
    const char* value = std::getenv(variable);
    return value == nullptr ? "" : value;
  };
  std::filesystem::path cache = folder_in("XDG_CACHE_HOME");
  if (cache.empty() && !folder_in("HOME").empty()) cache = folder_in("HOME") / ".cache";
  if (!cache.is_absolute()) return std::nullopt;
  return cache / "springcheck" / fmt::format("converged-{}.h5", build_info::revision);
}

}  // namespace springcheck
