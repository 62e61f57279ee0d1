#include "comparisons/running/simulate.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <utility>

#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/measures/hourglassing.hpp"
#include "comparisons/measures/wrinkles.hpp"
#include "comparisons/running/checkpoint_file.hpp"
#include "comparisons/running/progress.hpp"
#include "comparisons/settings/case_json.hpp"
#include "comparisons/store/lock_file.hpp"
#include "meshing/basics/breakdown.hpp"
#include "meshing/basics/output_file.hpp"
#include "meshing/basics/stopwatch.hpp"
#include "meshing/loads/scene.hpp"
#include "meshing/loads/turn.hpp"

namespace springcheck {
namespace {

/// A breakdown is a result. What else is thrown says nothing about the case, and must not
/// be stored as if it did.
Solution solve_or_break_down(const CaseSettings& settings, const Mesh& mesh, int threads,
                             const dynamics::Observers& observers) {
  try {
    return settings.method.solve(settings, mesh, mechanical_scene(settings, mesh),
                                 threads, observers);
  } catch (const Breakdown& error) {
    Solution none{};
    none.status = SolveStatus::not_converged;
    none.reason = std::string("the solver broke down: ") + error.what();
    return none;
  }
}

/// Whether the solution is an equilibrium at the full load.
bool has_equilibrium(const Solution& solution) {
  if (solution.critical_wavelength) return false;
  return solution.status == SolveStatus::ok || solution.status == SolveStatus::indefinite;
}

double transit_count(const CaseSettings& settings, const Mesh& mesh) {
  const auto [lambda, mu] = lame_constants(settings.material);
  const auto [low, high] =
      std::ranges::minmax(mesh.nodes(), {}, [](const Vector3& x) { return x.z(); });
  const double wave_speed = std::sqrt((lambda + 2 * mu) / settings.material.density);
  return settings.dynamics.duration * wave_speed / (high.z() - low.z());
}

/// How a motion lost the turn of its plates, which solvers of equilibria let no path do;
/// empty where it did not.
std::string lost_turn(const CaseSettings& settings, const Mesh& mesh,
                      const Solution& solution) {
  if (!goes_through_time(settings)) return {};
  constexpr double degree = std::numbers::pi / 180;
  std::vector<Vector3> positions = mesh.nodes();
  for (std::size_t n = 0; n < positions.size(); ++n)
    positions[n] += solution.displacements[n];
  const Scene scene = mechanical_scene(settings, mesh);
  if (shows_imposed_turn(mesh, scene, positions, solution.load_fraction)) return {};
  return fmt::format(
      "the body went through itself: it is turned by {:.4g} degrees, its plates by "
      "{:.4g}",
      *shown_turn(mesh, scene, positions, solution.load_fraction) / degree,
      scene.plates.back().motion.angle * solution.load_fraction / degree);
}

/// Writes checkpoints as long as they can be written: what was computed is worth more.
void try_checkpoint(const std::filesystem::path& file, const CheckpointOwner& owner,
                    const CaseCheckpoint& checkpoint) {
  try {
    write_checkpoint(file, owner, checkpoint);
  } catch (const std::exception& error) {
    spdlog::error("no checkpoint at {:.4g} s; an earlier one, if any, stays: {}",
                  checkpoint.march.time, error.what());
  }
}

/// What is recorded of a case on its way.
struct Record {
  History history{};
  HistoryFrames frames{};
  std::string revision{};  // of what it goes on from
};

dynamics::Observers observers_of(const CaseSettings& settings, const Mesh& mesh,
                                 const Watch& watch, Record& record) {
  dynamics::Observers observers;
  observers.samples = settings.dynamics.history;
  if (observers.samples > 0)
    observers.sample = [&](const dynamics::Moment& moment) {
      keep_frame(record.frames, record.history.size(), moment.displacements);
      record.history.push_back(history_sample(settings, mesh, moment));
    };
  if (watch.shows_progress) {
    const auto progress = std::make_shared<MarchProgress>(settings.dynamics.duration);
    observers.progress = [progress](const dynamics::Checkpoint& now) {
      progress->show(now.time, now.step, now.dt, now.limit);
    };
  }
  if (!watch.checkpoint || !goes_through_time(settings)) return observers;
  const CheckpointOwner owner{.identity = case_identity({.settings = settings}, mesh),
                              .settings = settings_json(settings)};
  if (auto from = read_checkpoint(*watch.checkpoint, owner, mesh.nodes().size(),
                                  watch.revisions)) {
    fmt::print(stderr, "going on from {} at t = {:.4g} s, step {}\n",
               watch.checkpoint->string(), from->march.time, from->march.step);
    record = {.history = std::move(from->history),
              .frames = std::move(from->frames),
              .revision = from->revision};
    observers.from = std::move(from->march);
  }
  observers.seconds_between_checkpoints = watch.seconds_between_checkpoints;
  observers.checkpoint = [&, owner](const dynamics::Checkpoint& now) {
    try_checkpoint(*watch.checkpoint, owner,
                   {.march = now,
                    .history = record.history,
                    .frames = record.frames,
                    .revision = record.revision});
  };
  return observers;
}

}  // namespace

CaseResult judged(const CaseSettings& settings, const Mesh& mesh, Solution found) {
  CaseResult result{.request = {.settings = settings},
                    .status = Status::ok,
                    .solution = std::move(found)};
  const Solution& solution = result.solution;
  result.reason = solution.reason;
  result.measures.definite_up_to_deformation =
      definite_up_to_deformation(settings, solution);
  result.measures.critical_wavelength = solution.critical_wavelength;
  bool inverted = false, is_folded = false, wrinkled = false;
  SolveStatus solved = solution.status;
  if (has_equilibrium(solution)) {
    Measures& measures = result.measures;
    measures = measure(settings, mesh, solution);
    measures.kinetic_energy = solution.kinetic_energy;
    if (solution.kinetic_energy && settings.method.is_elastic)
      measures.transit_count = transit_count(settings, mesh);
    if (const auto seen = measure_wrinkling(mesh, mechanical_scene(settings, mesh),
                                            solution.displacements)) {
      measures.wrinkle_alternation = seen->alternation;
      measures.wrinkle_amplitude = seen->amplitude;
      wrinkled = is_wrinkled(*seen);
    }
    if (const auto seen = measure_hourglassing(mesh, solution.displacements)) {
      measures.hourglass_alternation = seen->alternation;
      measures.hourglass_amplitude = seen->amplitude;
    }
    const std::string lost = lost_turn(settings, mesh, solution);
    add_reason(result.reason, lost);
    is_folded = *measures.corner_jacobian_ratio_min < 0;
    inverted = is_folded || !lost.empty();
    // Springs that take the logarithm of a cell's volume have no finite energy there.
    if (is_folded && measures.strain_energy && !std::isfinite(*measures.strain_energy))
      measures.strain_energy.reset();
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
    if (flag == Status::inverted && is_folded)
      add_reason(result.reason, "a cell is turned inside out at a corner");
    if (flag == Status::wrinkled)
      add_reason(result.reason, "a free face zigzags from cell to cell");
  }
  if (!solution.extrapolation.empty()) result.flags.push_back(Status::extrapolated);
  add_reason(result.reason, solution.extrapolation);
  return result;
}

CaseResult simulate(const CaseSettings& settings, const Mesh& mesh, int threads,
                    const Watch& watch) {
  std::optional<LockFile> lock;  // two runs must not write one checkpoint
  if (watch.checkpoint && goes_through_time(settings))
    lock.emplace(link_target(*watch.checkpoint));
  const Stopwatch stopwatch;
  Record record;
  const dynamics::Observers observers = observers_of(settings, mesh, watch, record);
  Solution solution = solve_or_break_down(settings, mesh, threads, observers);
  const double solve_wall_s = stopwatch.seconds();
  CaseResult result = judged(settings, mesh, std::move(solution));
  result.history = std::move(record.history);
  result.frames = std::move(record.frames);
  result.revision = std::move(record.revision);
  result.measures.solve_wall_s = solve_wall_s;
  result.measures.wall_s = stopwatch.seconds();
  return result;
}

}  // namespace springcheck
