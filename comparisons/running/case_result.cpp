#include "comparisons/running/case_result.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/settings/case_json.hpp"
#include "meshing/basics/sha256.hpp"

namespace springcheck {

std::string case_identity(const Request& request, const Mesh& mesh) {
  return case_identity(request, mesh.sha256());
}

std::string case_identity(const Request& request, const std::string& mesh_sha256) {
  nlohmann::json all{{"settings", settings_json(request.settings)},
                     {"mesh", mesh_sha256}};
  if (request.reference) all["reference"] = settings_json(*request.reference);
  if (request.reference_grid == ReferenceGrid::converged)
    all["reference-grid"] = "converged";
  return sha256(all.dump());
}

std::string key_of_identity(const std::string& identity, const std::string& revision) {
  return sha256(identity + ' ' + (revision.empty() ? build_info::revision : revision));
}

std::string case_key(const Request& request, const Mesh& mesh) {
  return key_of_identity(case_identity(request, mesh));
}

Verdict judge(SolveStatus solved, bool inverted, bool wrinkled) {
  Verdict verdict{.status = Status::ok};
  switch (solved) {
    case SolveStatus::no_equilibrium:
      verdict.status = Status::no_equilibrium;
      break;
    case SolveStatus::inverted:
      verdict.status = Status::inverted;
      break;
    case SolveStatus::diverged:
      verdict.status = Status::diverged;
      break;
    case SolveStatus::not_converged:
      verdict.status = Status::not_converged;
      break;
    case SolveStatus::refused:
      verdict.status = Status::refused;
      break;
    case SolveStatus::ok:
    case SolveStatus::indefinite:
      if (inverted) verdict.flags.push_back(Status::inverted);
      if (wrinkled) verdict.flags.push_back(Status::wrinkled);
      if (solved == SolveStatus::indefinite) verdict.flags.push_back(Status::indefinite);
      if (!verdict.flags.empty()) verdict.status = verdict.flags.front();
  }
  return verdict;
}

std::string status_words(const CaseResult& result) {
  std::vector<std::string_view> names;
  if (std::ranges::count(result.flags, result.status) == 0)
    names.push_back(name_of(result.status));
  for (const Status flag : result.flags) names.push_back(name_of(flag));
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace springcheck
