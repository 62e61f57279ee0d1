#include "comparisons/case_result.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "comparisons/build_info.hpp"
#include "comparisons/converged.hpp"
#include "meshing/sha256.hpp"

namespace springcheck {

const std::vector<Status>& all_statuses() {
  static const std::vector<Status> all{Status::ok,
                                       Status::wrinkled,
                                       Status::inverted,
                                       Status::indefinite,
                                       Status::no_equilibrium,
                                       Status::diverged,
                                       Status::not_converged,
                                       Status::refused};
  return all;
}

std::string_view name_of(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::wrinkled:
      return "wrinkled";
    case Status::inverted:
      return "inverted";
    case Status::indefinite:
      return "indefinite";
    case Status::no_equilibrium:
      return "no_equilibrium";
    case Status::diverged:
      return "diverged";
    case Status::not_converged:
      return "not_converged";
    case Status::refused:
      return "refused";
  }
  return {};
}

std::vector<CaseSettings> reference_cases(const Request& request) {
  if (!request.reference) return {};
  if (request.reference_grid == ReferenceGrid::one) return {*request.reference};
  const ThreeCases grids = convergence_grids(*request.reference);
  return {grids.begin(), grids.end()};
}

std::string reference_label(const Request& request) {
  if (!request.reference) return {};
  const std::string name = label(*request.reference);
  if (request.reference_grid == ReferenceGrid::converged) return name + "@converged";
  const Body& body = request.reference->body;
  if (body == request.settings.body) return name;
  return fmt::format("{}@{}", name, fmt::join(body.block.cells, ","));
}

std::string case_key(const Request& request, const Mesh& mesh) {
  nlohmann::json all{{"settings", settings_json(request.settings)},
                     {"mesh", mesh.sha256()},
                     {"version", build_info::version}};
  if (request.reference) all["reference"] = settings_json(*request.reference);
  if (request.reference_grid == ReferenceGrid::converged)
    all["reference-grid"] = "converged";
  return sha256(all.dump());
}

Verdict judge(SolveStatus solved, bool inverted, bool wrinkled) {
  Verdict verdict{.status = Status::ok, .flags = {}};
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

}  // namespace springcheck
