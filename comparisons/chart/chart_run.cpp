#include "comparisons/chart/chart_run.hpp"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/running/progress.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

/// A case timed on so many threads, in one round.
struct TimedCase {
  CaseResult result;
  std::vector<double> times;  // [s]
  double setup;               // [s] median
};

TimedCase timed_case(const CaseSettings& settings, const Mesh& mesh, int threads,
                     double budget) {
  tbb::task_arena arena(threads);
  CaseResult result;
  std::vector<double> setups;
  std::vector<double> times = timed(
      [&] {
        result = arena.execute([&] { return simulate(settings, mesh, threads); });
        setups.push_back(result.solution.setup_wall_s);
        return result.measures.solve_wall_s.value();
      },
      budget);
  if (setups.size() > 1) setups.erase(setups.begin());  // the warm-up's
  return {.result = std::move(result),
          .times = std::move(times),
          .setup = timing_of({std::move(setups)}).median};
}

/// Errors by one revision of the numerics and times by another are not of one chart.
void refuse_other_revisions(const std::filesystem::path& file,
                            const OtherRevisions& others) {
  if (others.empty()) return;
  throw InputError(
      file.string(), "",
      fmt::format("a file of cases of revision {} of the numerics, which is this "
                  "program's, or a new one",
                  build_info::revision),
      fmt::format("{} of {}", others.begin()->second, others.begin()->first));
}

}  // namespace

ChartRun::ChartRun(const ChartPlan& plan, const std::filesystem::path& file)
    : plan_(plan), path_(file), file_(file) {
  refuse_other_revisions(file, file_.stored().others);
  if (std::filesystem::exists(file)) stored_ = stored_cases({file}, Revisions::own);
  for (const auto& [key, place] : stored_) know(key, place.second);
  begin_chart();
  if (plan.truths_file) kept_.emplace(*plan.truths_file);
  find_truths();
}

Chart ChartRun::chart() const {
  std::map<std::string, StoredCase> cases;
  for (auto& [key, stored] : read_results(path_, Revisions::own))
    cases.emplace(key, std::move(stored));
  return evaluated(chart_, cases);
}

void ChartRun::measure(const ChartModel& model, int across, double seconds) {
  measure(model, across, plan_.threads, seconds);
}

void ChartRun::measure(const ChartModel& model, int across,
                       std::span<const int> on_threads, double budget) {
  const CaseSettings settings = settings_of(model, across);
  check_mesh_memory(plan_.scene, settings.body);
  const Mesh& mesh = meshes_.mesh(settings.body);
  const std::string key = key_of(settings);
  std::optional<CaseResult> result;
  bool is_new = false;
  for (const int threads : on_threads) {
    const StoredChart::Point* const known = find_point(chart_, model.model, key, threads);
    // New times are for the points that have one: which ones a chart has is not left to
    // how long smaller ones take this time.
    if (plan_.retime != (known != nullptr && known->timing)) continue;
    const bool fits_now = fits_in_memory(settings);
    if (plan_.retime && !fits_now) continue;
    is_new = true;
    StoredChart::Point& point = point_of(model, settings, across, key, threads);
    point.left_out.reset();
    if (!fits_now)
      point.left_out = "over memory";
    else if (!plan_.retime && expected_seconds(model, point.nodes, threads) > budget)
      point.left_out = "over budget";
    if (point.left_out) continue;
    point.times.clear();
    TimedCase timed = timed_case(settings, mesh, threads, seconds_of_round());
    if (timed.result.status == Status::refused) {
      point.left_out = "not applicable";
      continue;
    }
    point.times.push_back(std::move(timed.times));
    point.timing = timing_of(point.times);
    point.setup = timed.setup;
    result = std::move(timed.result);
  }
  if (result) result->key = key;
  const std::size_t comparisons = chart_.comparisons.size();
  if (result || is_known(key)) compare(settings, key, result);
  if (is_new || chart_.comparisons.size() > comparisons) file_.put_chart(chart_);
}

void ChartRun::time_again(const ChartModel& model, int across, int round) {
  const CaseSettings settings = settings_of(model, across);
  const Mesh& mesh = meshes_.mesh(settings.body);
  const std::string key = key_of(settings);
  if (!fits_in_memory(settings)) return;
  bool is_new = false;
  for (const int threads : plan_.threads) {
    StoredChart::Point* const point = find_point(chart_, model.model, key, threads);
    if (point == nullptr || !point->timing || point->timing->rounds >= round ||
        point->timing->median > plan_.repeat_for)
      continue;
    point->times.push_back(timed_case(settings, mesh, threads, seconds_of_round()).times);
    point->timing = timing_of(point->times);
    is_new = true;
  }
  if (is_new) file_.put_chart(chart_);
}

void ChartRun::begin_chart() {
  truths_planned_ = planned_truths(plan_);
  chart_ = planned_chart(plan_, truths_planned_, meshes_);
  if (!std::filesystem::exists(path_)) return;
  for (const StoredChart& earlier : read_charts(path_, Revisions::own))
    if (identity_of(earlier) == identity_of(chart_)) chart_ = merged(chart_, earlier);
}

void ChartRun::find_truths() {
  std::vector<CaseSettings> all;
  for (const TruthGrids& truth : truths_planned_)
    for (const ThreeCases& grids : {truth.grids, truth.check})
      all.insert(all.end(), grids.begin(), grids.end());
  find_references(all);
  const auto runs_of = [&](const StoredChart::Grids& grids) {
    std::vector<const CaseResult*> runs;
    for (const std::string& key : grids.keys) runs.push_back(&references_.at(key));
    return runs;
  };
  if (!is_nested(own_truth().front().body)) return;
  // Truths that an earlier chart has beyond the planned ones come after these.
  for (std::size_t i = 0; i < truths_planned_.size(); ++i) {
    StoredChart::Truth& truth = chart_.truths[i];
    truth.places_apart =
        apart_in_places(runs_of(truth.grids), runs_of(truth.check.value()), meshes_);
  }
}

std::string ChartRun::key_of(const CaseSettings& settings) {
  return case_key({.settings = settings}, meshes_.mesh(settings.body));
}

void ChartRun::put(std::span<const CaseResult> results, bool with_fields) {
  file_.put(results, with_fields, meshes_);
  for (const CaseResult& result : results) know(result.key, result);
}

void ChartRun::know(const std::string& key, const auto& result) {
  outcomes_[key] = {.has_state = result.measures.volume_error.has_value(),
                    .is_ok = result.status == Status::ok};
}

bool ChartRun::is_known(const std::string& key) const {
  return outcomes_.contains(key);
}

bool ChartRun::has_failed(const std::string& key) const {
  const auto found = outcomes_.find(key);
  return found != outcomes_.end() && !found->second.has_state;
}

void ChartRun::find_references(const std::vector<CaseSettings>& cases) {
  std::vector<Request> all;
  for (const CaseSettings& one : cases) all.push_back({.settings = one});
  check_memory(plan_.scene, all);
  Progress progress(plan_.scene + ": converged solutions");
  const KnownResult in_file = only_with_fields(known_from(stored_, meshes_));
  const KnownResult known = [&](const Request& request,
                                const std::string& key) -> std::optional<CaseResult> {
    if (auto result = in_file(request, key)) return result;
    return kept_ ? kept_->known(request, key, meshes_) : std::nullopt;
  };
  run_study(
      all, meshes_, plan_.jobs,
      [&](std::size_t done, std::size_t of) { progress.show(done, of); }, known,
      [&](std::size_t, CaseResult&& result) {
        if (!stored_.contains(result.key) ||
            !file_.stored().with_fields.contains(result.key))
          put({&result, 1}, true);
        if (kept_) kept_->keep(result, meshes_);
        references_.insert_or_assign(result.key, std::move(result));
      });
}

CaseResult ChartRun::result_of(const Request& request) {
  const KnownResult in_file = known_figures(stored_);
  const KnownResult known = [&](const Request& asked,
                                const std::string& key) -> std::optional<CaseResult> {
    if (const auto found = references_.find(key); found != references_.end())
      return found->second;
    return in_file(asked, key);
  };
  CaseResult result = run_study(
                          {request}, meshes_, 1, [](std::size_t, std::size_t) {}, known)
                          .front();
  if (!is_known(result.key)) put({&result, 1}, false);
  return result;
}

StoredChart::Point& ChartRun::point_of(const ChartModel& model,
                                       const CaseSettings& settings, int across,
                                       const std::string& key, int threads) {
  if (auto* point = find_point(chart_, model.model, key, threads)) return *point;
  const Mesh& mesh = meshes_.mesh(settings.body);
  chart_.points.push_back({.model = model.model,
                           .kind = model.kind,
                           .across = across,
                           .cells = static_cast<double>(mesh.cells().size()),
                           .nodes = static_cast<double>(mesh.nodes().size()),
                           .threads = threads,
                           .key = key,
                           .simulated = model.kind == ChartKind::motion
                                            ? std::optional(settings.dynamics.duration)
                                            : std::nullopt,
                           .family = std::string(name_of(settings.method.family))});
  return chart_.points.back();
}

double ChartRun::seconds_of_round() const {
  return plan_.repeat_for / most_rounds;
}

CaseSettings ChartRun::settings_of(const ChartModel& model, int across) const {
  return model_case(plan_.scene, plan_.options, model, across);
}

bool ChartRun::is_compared(const std::string& compared) const {
  return std::ranges::count(chart_.comparisons, compared,
                            &StoredChart::Comparison::compared) > 0;
}

void ChartRun::compare(const CaseSettings& settings, const std::string& key,
                       const std::optional<CaseResult>& result) {
  std::vector<Request> missing;
  if (!is_known(key)) missing.push_back({.settings = settings});
  const bool is_state =
      result ? result->measures.volume_error.has_value() : !has_failed(key);
  for (const TruthGrids& planned : truths_planned_) {
    const CaseSettings& truth = planned.grids.front();
    const Request request{.settings = settings,
                          .reference = truth,
                          .reference_grid = ReferenceGrid::converged};
    const std::string compared = case_key(request, meshes_.mesh(settings.body));
    if (!is_state || !is_nested(settings.body)) continue;
    if (!is_known(compared)) missing.push_back(request);
    if (!is_compared(compared))
      chart_.comparisons.push_back(
          {.key = key, .law = truth.method.name, .compared = compared});
  }
  const KnownResult known = [&](const Request& request,
                                const std::string& asked) -> std::optional<CaseResult> {
    if (const auto truth = references_.find(asked); truth != references_.end())
      return truth->second;
    if (request.reference || asked != key) return std::nullopt;
    return result;
  };
  put(run_study(
          missing, meshes_, 1, [](std::size_t, std::size_t) {}, known),
      false);
}

Chart make_chart(const ChartPlan& plan, const std::filesystem::path& file) {
  check_plan(plan);
  ChartRun run(plan, file);
  const std::vector<ChartModel> models =
      chosen_models(plan.models, chart_body(plan.scene, plan.options).shape);
  std::size_t done = 0;
  Progress progress(plan.scene + ": points");
  for (int round = 1; round <= most_rounds; ++round) {
    for (const ChartModel& model : models)
      for (const int across : plan.across) {
        progress.show(done++, most_rounds * models.size() * plan.across.size());
        if (round == 1)
          run.measure(model, across, plan.budget);
        else
          run.time_again(model, across, round);
      }
    if (round == 1) run.measure_beyond_budget(models);
  }
  return run.chart();
}

}  // namespace springcheck
