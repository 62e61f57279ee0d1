#include "comparisons/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <omp.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>

#include "comparisons/build_info.hpp"
#include "comparisons/converged.hpp"
#include "comparisons/wrinkles.hpp"
#include "meshing/sha256.hpp"

namespace springcheck {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Solution solve(const CaseSettings& settings, const Mesh& mesh) {
  const Scene scene = mechanical_scene(settings);
  if (is_finite_element(settings.method))
    return fem_reference::solve(mesh, scene, reference_settings(settings));
  return mss::solve(mesh, scene,
                    {.network = {.method = std::get<mss::Method>(settings.method.model),
                                 .stiffness_form = settings.stiffness_form,
                                 .diagonal_ratio = settings.diagonal_ratio,
                                 .constants = settings.constants},
                     .solver = settings.solver,
                     .dynamics = settings.dynamics,
                     .seed = settings.seed});
}

bool has_equilibrium(const Solution& solution) {
  return solution.status == SolveStatus::ok || solution.status == SolveStatus::indefinite;
}

/// One simulation without its reference.
CaseResult simulate(const CaseSettings& settings, const Mesh& mesh) {
  omp_set_num_threads(1);  // this thread's: CHOLMOD's small loops only wait otherwise
  const auto start = std::chrono::steady_clock::now();
  CaseResult result{.request = {.settings = settings, .reference = std::nullopt},
                    .key = {},
                    .status = Status::ok,
                    .flags = {},
                    .reason = {},
                    .measures = {},
                    .solution = solve(settings, mesh),
                    .wall_s = 0,
                    .solve_wall_s = seconds_since(start)};
  const Solution& solution = result.solution;
  result.reason = solution.reason;
  result.measures.definite_up_to_deformation =
      definite_up_to_deformation(settings, solution);
  bool inverted = false, wrinkled = false;
  SolveStatus solved = solution.status;
  if (has_equilibrium(solution)) {
    Measures& measures = result.measures;
    measures = measure(settings, mesh, solution);
    if (const auto wrinkling =
            measure_wrinkling(mesh, mechanical_scene(settings), imposed_strain(settings),
                              solution.displacements)) {
      measures.wrinkle_alternation = wrinkling->alternation;
      measures.wrinkle_amplitude = wrinkling->amplitude;
      wrinkled = is_wrinkled(*wrinkling);
    }
    inverted = *measures.corner_jacobian_ratio_min < 0;
    if (const auto name = not_finite(measures)) {
      measures = {};
      solved = SolveStatus::not_converged;
      result.reason = *name + " overflows";
    }
  }
  const Verdict verdict = judge(solved, inverted, wrinkled);
  result.status = verdict.status;
  result.flags = verdict.flags;
  for (const Status flag : verdict.flags) {
    if (flag == Status::indefinite) continue;  // the solver gave its reason
    result.reason += result.reason.empty() ? "" : "; ";
    result.reason += flag == Status::inverted ? "a cell is turned inside out at a corner"
                                              : "a free face zigzags from cell to cell";
  }
  result.wall_s = seconds_since(start);
  return result;
}

}  // namespace

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
  const Cells& cells = request.reference->block.cells;
  if (cells == request.settings.block.cells) return name;
  return fmt::format("{}@{}", name, fmt::join(cells, ","));
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

const Mesh& MeshStore::mesh(const BlockSize& block) {
  auto& mesh = meshes_[{block.size, block.cells}];
  if (!mesh) mesh = std::make_unique<const Mesh>(generate_block(block));
  return *mesh;
}

std::vector<CaseResult> run_study(const std::vector<Request>& requests, MeshStore& meshes,
                                  int parallel, const Finished& finished,
                                  const KnownResult& known) {
  // A simulation is known by its key without a reference.
  struct Simulation {
    CaseSettings settings;
    const Mesh* mesh;
    CaseResult result;
  };
  std::vector<Simulation> simulations;
  std::vector<std::size_t> to_run;
  std::map<std::string, std::size_t> place_of;
  const auto plan = [&](const CaseSettings& settings) {
    const Mesh& mesh = meshes.mesh(settings.block);
    const Request alone{.settings = settings, .reference = std::nullopt};
    const std::string key = case_key(alone, mesh);
    const auto [place, is_new] = place_of.try_emplace(key, simulations.size());
    if (!is_new) return place->second;
    simulations.push_back({settings, &mesh, {}});
    auto result = known ? known(alone, key) : std::nullopt;
    if (result && !result->solution.displacements.empty())
      simulations.back().result = std::move(*result);
    else
      to_run.push_back(place->second);
    return place->second;
  };

  struct Answer {
    std::optional<CaseResult> known;
    std::size_t simulation;
    std::vector<std::size_t> reference;
  };
  std::vector<Answer> answers;
  for (const Request& request : requests) {
    Answer answer{std::nullopt, 0, {}};
    if (known)
      answer.known =
          known(request, case_key(request, meshes.mesh(request.settings.block)));
    if (!answer.known) {
      answer.simulation = plan(request.settings);
      for (const CaseSettings& settings : reference_cases(request))
        answer.reference.push_back(plan(settings));
    }
    answers.push_back(std::move(answer));
  }

  finished(0, to_run.size());
  std::size_t done = 0;
  std::mutex one_at_a_time;
  tbb::task_arena arena(parallel);
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, to_run.size(), 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) {
            Simulation& simulation = simulations[to_run[i]];
            // Isolated: a thread that waits for its own inner loops must not start
            // another simulation meanwhile, whose time would count twice.
            simulation.result = tbb::this_task_arena::isolate(
                [&] { return simulate(simulation.settings, *simulation.mesh); });
            const std::lock_guard lock(one_at_a_time);
            finished(++done, to_run.size());
          }
        },
        tbb::simple_partitioner());
  });

  std::vector<CaseResult> results;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (answers[i].known) {
      results.push_back(std::move(*answers[i].known));
      continue;
    }
    CaseResult result = simulations[answers[i].simulation].result;
    const Mesh& mesh = *simulations[answers[i].simulation].mesh;
    std::vector<const CaseResult*> runs;
    for (const std::size_t place : answers[i].reference)
      runs.push_back(&simulations[place].result);
    if (const auto reference = reference_field(requests[i], runs, meshes);
        reference && result.measures.volume_error) {
      measure_deviation(result.measures, requests[i].settings, mesh, result.solution,
                        reference->solution);
      result.measures.reference_order = reference->order;
      result.measures.reference_bar = reference->bar;
    }
    result.request = requests[i];
    result.key = case_key(requests[i], mesh);
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace springcheck
