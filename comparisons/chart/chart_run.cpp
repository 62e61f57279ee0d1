#include "comparisons/chart/chart_run.hpp"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "comparisons/build_info.hpp"
#include "comparisons/displacement_norms.hpp"
#include "comparisons/known_results.hpp"
#include "comparisons/mechanical_scene.hpp"
#include "comparisons/memory.hpp"
#include "comparisons/progress.hpp"
#include "comparisons/provenance.hpp"
#include "comparisons/scene_file.hpp"
#include "meshing/input_error.hpp"
#include "meshing/sha256.hpp"

namespace springcheck {
namespace {

/// The measure that answers a test's load.
std::string answer_of(Test test, const std::string& scene) {
  switch (test) {
    case Test::torsion:
      return "plate_torque";
    case Test::bending:
      return "tip_deflection";
    case Test::traction:
    case Test::affine:
      throw InputError(scene, "test", "one that a plate or a weight answers",
                       std::string(name_of(test)));
    default:
      return "plate_force";
  }
}

/// A case timed on so many threads.
struct TimedCase {
  CaseResult result;
  Timing timing;
  double setup;  // [s] median
};

TimedCase timed_case(const CaseSettings& settings, const Mesh& mesh, int threads,
                     double budget) {
  tbb::task_arena arena(threads);
  CaseResult result;
  std::vector<double> setups;
  const Timing timing = timed(
      [&] {
        result = arena.execute([&] { return simulate(settings, mesh, threads); });
        setups.push_back(result.solution.setup_wall_s);
        return result.solve_wall_s;
      },
      budget);
  return {.result = std::move(result),
          .timing = timing,
          .setup = timing_of(std::move(setups)).median};
}

}  // namespace

class ChartRun::State {
 public:
  State(const ChartPlan& plan, const std::filesystem::path& file)
      : plan_(plan), path_(file), file_(file) {
    if (std::filesystem::exists(file)) stored_ = stored_cases({file});
    warn_of_other_commits(stored_);
    plan_chart();
    find_truths();
  }

  [[nodiscard]] Chart chart() const {
    std::map<std::string, StoredCase> cases;
    for (auto& [key, stored] : read_results(path_)) cases.emplace(key, std::move(stored));
    return evaluated(chart_, cases);
  }

  [[nodiscard]] double expected_seconds(const ChartModel& model, int across) {
    const CaseSettings settings = settings_of(model, across);
    const Mesh& mesh = meshes_.mesh(settings.body);
    return expected_seconds(model.name, across, static_cast<double>(mesh.nodes().size()),
                            plan_.threads.front());
  }

  void measure(const ChartModel& model, int across) {
    const CaseSettings settings = settings_of(model, across);
    const Mesh& mesh = meshes_.mesh(settings.body);
    const std::string key = key_of(settings);
    check_memory(plan_.scene, {{.settings = settings, .reference = std::nullopt}});
    std::optional<CaseResult> result;
    bool is_new = false;
    for (const int threads : plan_.threads) {
      StoredChart::Point& point = point_of(model, settings, across, key, threads);
      if (point.timing && !plan_.retime) continue;
      is_new = true;
      if (expected_seconds(model.name, across, point.nodes, threads) > plan_.budget)
        continue;
      TimedCase timed = timed_case(settings, mesh, threads, plan_.repeat_for);
      point.timing = timed.timing;
      point.setup = timed.setup;
      result = std::move(timed.result);
    }
    if (result) result->key = key;
    const std::size_t comparisons = chart_.comparisons.size();
    if (result || is_known(key)) compare(settings, key, result);
    if (is_new || chart_.comparisons.size() > comparisons) file_.put_chart(chart_);
  }

 private:
  void plan_chart() {
    const RunSettings scene =
        read_run(plan_.scene, options_for(ChartKind::equilibrium, plan_.options));
    chart_.answer = answer_of(scene.common.test, plan_.scene);
    chart_.scene = scene.common.scene;
    chart_.machine = fmt::format("{}, {}, commit {}", processor_name(),
                                 build_info::compiler, build_info::commit);
    chart_.law = law_of_scene();
    chart_.settings = settings_of_models();
    std::vector<std::string> laws{chart_.law};
    for (const std::string& law : plan_.laws)
      if (law != chart_.law) laws.push_back(law);
    for (const std::string& law : laws)
      truths_planned_.push_back(
          truth_grids(plan_.scene, plan_.options, law, plan_.truth_across));
    const CaseSettings& first = truths_planned_.front().front();
    chart_.height = first.body.block.size[2];
    const Mesh& mesh = meshes_.mesh(first.body);
    if (first.test != Test::bending)
      chart_.imposed = largest_imposed_displacement(mesh, mechanical_scene(first, mesh));
    for (const ThreeCases& grids : truths_planned_) {
      StoredChart::Truth truth{
          .law = grids.front().method.name, .cell_sizes = grid_sizes(grids), .keys = {}};
      std::ranges::transform(grids, truth.keys.begin(),
                             [&](const CaseSettings& grid) { return key_of(grid); });
      chart_.truths.push_back(std::move(truth));
    }
    for (const StoredChart& earlier : read_charts_of_file())
      if (identity_of(earlier) == identity_of(chart_)) {
        chart_.points = earlier.points;
        chart_.comparisons = earlier.comparisons;
        for (const StoredChart::Truth& truth : earlier.truths)
          if (std::ranges::count(chart_.truths, truth.law, &StoredChart::Truth::law) == 0)
            chart_.truths.push_back(truth);
      }
  }

  [[nodiscard]] std::vector<StoredChart> read_charts_of_file() const {
    if (!std::filesystem::exists(path_)) return {};
    return read_charts(path_);
  }

  /// The law that `run` measures deviations from, by default or as the scene says;
  /// St-Venant-Kirchhoff's where that is none.
  [[nodiscard]] std::string law_of_scene() const {
    const Request first =
        requests(
            read_run(plan_.scene, options_for(ChartKind::equilibrium, plan_.options)))
            .front();
    const Method& method = (first.reference ? *first.reference : first.settings).method;
    return is_finite_element(method) ? method.name : "fem-stvk";
  }

  /// What determines all models of the chart, whichever they are.
  [[nodiscard]] std::string settings_of_models() const {
    std::string all;
    for (const ChartModel& model :
         chart_models(chart_body(plan_.scene, plan_.options).shape))
      all += settings_json(model_case(plan_.scene, plan_.options, model, 2)).dump();
    return sha256(all);
  }

  std::string key_of(const CaseSettings& settings) {
    return case_key({.settings = settings, .reference = std::nullopt},
                    meshes_.mesh(settings.body));
  }

  void put(CaseResult&& result, bool with_fields) {
    const std::vector one{std::move(result)};
    file_.put(one, with_fields, meshes_);
    known_.insert(one.front().key);
  }

  [[nodiscard]] bool is_known(const std::string& key) const {
    return known_.contains(key) || stored_.contains(key);
  }

  /// The truths' runs are kept with their fields, which every comparison needs.
  void find_truths() {
    std::vector<Request> all;
    for (const ThreeCases& grids : truths_planned_)
      for (const CaseSettings& grid : grids)
        all.push_back({.settings = grid, .reference = std::nullopt});
    check_memory(plan_.scene, all);
    Progress progress(plan_.scene + ": truths");
    const KnownResult known = only_with_fields(known_from(stored_, meshes_));
    run_study(
        all, meshes_, plan_.jobs,
        [&](std::size_t done, std::size_t of) { progress.show(done, of); }, known,
        [&](std::size_t, CaseResult&& result) {
          if (!stored_.contains(result.key) ||
              !file_.stored().with_fields.contains(result.key))
            put(CaseResult(result), true);
          truths_.insert_or_assign(result.key, std::move(result));
        });
  }

  StoredChart::Point& point_of(const ChartModel& model, const CaseSettings& settings,
                               int across, const std::string& key, int threads) {
    const auto found = std::ranges::find_if(chart_.points, [&](const auto& point) {
      return point.model == model.name && point.key == key && point.threads == threads;
    });
    if (found != chart_.points.end()) return *found;
    const Mesh& mesh = meshes_.mesh(settings.body);
    chart_.points.push_back({.model = model.name,
                             .kind = model.kind,
                             .across = across,
                             .cells = static_cast<double>(mesh.cells().size()),
                             .nodes = static_cast<double>(mesh.nodes().size()),
                             .threads = threads,
                             .key = key,
                             .timing = std::nullopt,
                             .setup = std::nullopt,
                             .simulated = model.kind == ChartKind::motion
                                              ? std::optional(settings.dynamics.duration)
                                              : std::nullopt});
    return chart_.points.back();
  }

  [[nodiscard]] CaseSettings settings_of(const ChartModel& model, int across) const {
    return model_case(plan_.scene, plan_.options, model, across);
  }

  /// By the largest of the model's smaller points.
  [[nodiscard]] double expected_seconds(const std::string& model, int across,
                                        double nodes, int threads) const {
    const StoredChart::Point* smaller = nullptr;
    for (const StoredChart::Point& other : chart_.points)
      if (other.model == model && other.threads == threads && other.across < across &&
          (smaller == nullptr || other.across > smaller->across))
        smaller = &other;
    if (smaller == nullptr) return 0;
    const double seconds =
        smaller->timing ? smaller->timing->median : plan_.budget;  // too dear itself
    return seconds * std::pow(nodes / smaller->nodes, 1.5);
  }

  [[nodiscard]] bool is_compared(const std::string& compared) const {
    return std::ranges::count(chart_.comparisons, compared,
                              &StoredChart::Comparison::compared) > 0;
  }

  /// Adds the case and its deviations from every truth to the file.
  void compare(const CaseSettings& settings, const std::string& key,
               const std::optional<CaseResult>& result) {
    std::vector<Request> missing;
    if (!is_known(key)) missing.push_back({.settings = settings, .reference = {}});
    const bool has_failed = result && !result->measures.volume_error;
    const bool is_nested = settings.body.shape == BodyShape::block;
    for (const ThreeCases& grids : truths_planned_) {
      const CaseSettings& truth = grids.front();
      const Request request{.settings = settings,
                            .reference = truth,
                            .reference_grid = ReferenceGrid::converged};
      const std::string compared = case_key(request, meshes_.mesh(settings.body));
      if (has_failed || !is_nested) continue;
      if (!is_known(compared)) missing.push_back(request);
      if (!is_compared(compared))
        chart_.comparisons.push_back(
            {.key = key, .law = truth.method.name, .compared = compared});
    }
    const KnownResult known = [&](const Request& request,
                                  const std::string& asked) -> std::optional<CaseResult> {
      if (const auto truth = truths_.find(asked); truth != truths_.end())
        return truth->second;
      if (request.reference || asked != key) return std::nullopt;
      return result;
    };
    run_study(
        missing, meshes_, 1, [](std::size_t, std::size_t) {}, known,
        [&](std::size_t, CaseResult&& one) { put(std::move(one), false); });
  }

  ChartPlan plan_;
  std::filesystem::path path_;
  ResultFile file_;
  StoredCases stored_;           // of the file, before
  std::set<std::string> known_;  // keys added since
  MeshStore meshes_;
  std::vector<ThreeCases> truths_planned_;  // of each law
  std::map<std::string, CaseResult> truths_;
  StoredChart chart_{};
};

ChartRun::ChartRun(const ChartPlan& plan, const std::filesystem::path& file)
    : state_(std::make_unique<State>(plan, file)) {}

ChartRun::~ChartRun() = default;

void ChartRun::measure(const ChartModel& model, int across) {
  state_->measure(model, across);
}

double ChartRun::expected_seconds(const ChartModel& model, int across) {
  return state_->expected_seconds(model, across);
}

Chart ChartRun::chart() const {
  return state_->chart();
}

Chart make_chart(const ChartPlan& plan, const std::filesystem::path& file) {
  ChartRun run(plan, file);
  const std::vector<ChartModel>& models =
      chart_models(chart_body(plan.scene, plan.options).shape);
  std::size_t done = 0;
  Progress progress(plan.scene + ": points");
  for (const ChartModel& model : models)
    for (const int across : plan.across) {
      progress.show(done++, models.size() * plan.across.size());
      run.measure(model, across);
    }
  return run.chart();
}

}  // namespace springcheck
