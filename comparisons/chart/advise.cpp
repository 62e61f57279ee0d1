#include "comparisons/chart/advise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "comparisons/chart/left_out.hpp"
#include "comparisons/progress.hpp"
#include "comparisons/simulate.hpp"

namespace springcheck {
namespace {

constexpr std::array sizes{2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32};
constexpr double step_ratio = 0.9;
constexpr double still_falls = 0.9;  // error over that of the next coarser cells

class Search {
 public:
  Search(const Wish& wish, const ChartPlan& plan, ChartRun& run)
      : wish_(wish), plan_(plan), run_(run) {
    shape_ = chart_body(plan.scene, plan.options).shape;
    kind_ = wish.frame ? ChartKind::motion : ChartKind::equilibrium;
    for (const ChartModel& model : chart_models(shape_))
      if (model.kind == kind_) alive_.push_back(&model);
    duration_ = model_case(plan.scene, plan.options, *alive_.front(), sizes.front())
                    .dynamics.duration;
  }

  Advice found() {
    {
      Progress progress("sizes");
      for (std::size_t i = 0; i < sizes.size() && !alive_.empty(); ++i) {
        progress.show(i, sizes.size());
        climb(sizes[i]);
      }
    }
    take_in();
    choose();
    if (advice_.chosen) compare_with_neighbours();
    return std::move(advice_);
  }

 private:
  void take_in() {
    advice_.chart = run_.chart();
    const std::string& law = advice_.chart.stored.law;
    const auto truth = advice_.chart.truth_of(law);
    if (!truth)
      throw std::runtime_error(fmt::format(
          "{}: no truth to hold a model against: {}:q2 has no equilibrium on all of the "
          "three grids that `springcheck chart` takes",
          plan_.scene, law));
    advice_.truth = *truth;
  }

  /// Runs every model that may still win on one size.
  void climb(int across) {
    std::vector<const ChartModel*> next;
    for (const ChartModel* model : alive_) {
      if (run_.expected_seconds(*model, across) > most_seconds()) continue;
      run_.measure(*model, across);
      next.push_back(model);
    }
    take_in();
    alive_.clear();
    for (const ChartModel* model : next)
      if (goes_on(*model, across)) alive_.push_back(model);
    for (std::size_t i = 0; i < advice_.chart.points.size(); ++i)
      if (meets(i) && *cost(i) < best_ && is_stable(i)) best_ = *cost(i);
  }

  /// [s] of a solution that is worth trying.
  [[nodiscard]] double most_seconds() const {
    const double of_best = wish_.frame ? best_ * duration_ : best_;
    return std::min(plan_.budget, of_best);
  }

  /// The model's point on so many cells across; none where it was not run.
  [[nodiscard]] std::optional<std::size_t> point_of(const ChartModel& model,
                                                    int across) const {
    const auto& points = advice_.chart.points;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points[i].place.model == model.name && points[i].place.across == across &&
          points[i].place.threads == plan_.threads.front() && points[i].found)
        return i;
    return std::nullopt;
  }

  [[nodiscard]] bool goes_on(const ChartModel& model, int across) {
    const auto point = point_of(model, across);
    if (!point) return false;
    const bool fails = !advice_.chart.points[*point].is_ok();
    const auto error = error_with_bar(advice_, *point, wish_.measure);
    if (fails || !error) return ++failures_[&model] < 2;
    if (meets_tolerance(*point)) return false;
    const auto before = last_error_.find(&model);
    const bool is_stuck =
        before != last_error_.end() && *error > still_falls * before->second;
    stuck_[&model] = is_stuck ? stuck_[&model] + 1 : 0;
    last_error_[&model] = *error;
    return stuck_[&model] < 2;
  }

  [[nodiscard]] bool is_candidate(std::size_t i) const {
    const ChartPoint& point = advice_.chart.points[i];
    return point.place.kind == kind_ && point.is_ok() && point.seconds() &&
           point.place.threads == plan_.threads.front() &&
           point.errors[advice_.truth].of(wish_.measure);
  }

  [[nodiscard]] bool meets_tolerance(std::size_t i) const {
    return is_candidate(i) &&
           *error_with_bar(advice_, i, wish_.measure) <= wish_.tolerance;
  }

  [[nodiscard]] bool holds_frame(std::size_t i) const {
    if (!wish_.frame) return true;
    const auto frame = frame_of(advice_.chart.points[i], *wish_.frame);
    return frame && frame->seconds <= *wish_.frame;
  }

  /// [s] of a solution, or real per simulated.
  [[nodiscard]] std::optional<double> cost(std::size_t i) const {
    const ChartPoint& point = advice_.chart.points[i];
    if (!wish_.frame) return point.seconds();
    const auto frame = frame_of(point, *wish_.frame);
    return frame ? std::optional(frame->seconds / *wish_.frame) : std::nullopt;
  }

  [[nodiscard]] bool meets(std::size_t i) const {
    return meets_tolerance(i) && holds_frame(i) &&
           advice_.chart.points[i].place.timing->median <= plan_.budget;
  }

  /// Whether springs have a stable static path to the full load.
  [[nodiscard]] bool is_stable(std::size_t i) {
    const ChartPoint& point = advice_.chart.points[i];
    if (!point.place.model.starts_with("mss-")) return true;
    const auto known = stable_.find(point.place.key);
    if (known != stable_.end()) return known->second;
    CaseSettings settings = settings_of(plan_, point, shape_);
    settings.solver = Solver::path_limit;
    const Mesh mesh = build_mesh(settings.body);
    return stable_[point.place.key] = simulate(settings, mesh).status == Status::ok;
  }

  void choose() {
    std::vector<std::size_t> meeting;
    for (std::size_t i = 0; i < advice_.chart.points.size(); ++i)
      if (meets(i)) meeting.push_back(i);
    std::ranges::stable_sort(meeting, {}, [&](std::size_t i) { return *cost(i); });
    for (const std::size_t i : meeting) {
      if (!is_stable(i)) {
        advice_.cautions.push_back(fmt::format(
            "{} on {} across would do, but its path to the full load loses its "
            "stability.",
            advice_.chart.points[i].place.model, advice_.chart.points[i].place.across));
        continue;
      }
      if (!advice_.chosen) {
        advice_.chosen = i;
        continue;
      }
      const ChartPoint &best = advice_.chart.points[*advice_.chosen],
                       &other = advice_.chart.points[i];
      if (*other.seconds_at(&Timing::lower_quartile) <=
              *best.seconds_at(&Timing::upper_quartile) &&
          other.place.nodes < best.place.nodes)
        advice_.chosen = i;
    }
    if (advice_.chosen) return;
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < advice_.chart.points.size(); ++i)
      if (is_candidate(i)) candidates.push_back(i);
    std::ranges::stable_sort(candidates, {}, [&](std::size_t i) { return distance(i); });
    const auto nearest =
        std::ranges::find_if(candidates, [&](std::size_t i) { return is_stable(i); });
    if (nearest != candidates.end()) advice_.nearest = *nearest;
  }

  /// How far a point is from the wish: by the larger of the factors that it misses
  /// tolerance and frame by.
  [[nodiscard]] double distance(std::size_t i) const {
    const double accuracy = *error_with_bar(advice_, i, wish_.measure) / wish_.tolerance;
    return wish_.frame ? std::max(accuracy, cost(i).value_or(INFINITY)) : accuracy;
  }

  void compare_with_neighbours() {
    caution_of_accidents();  // measures the next finer cells: a neighbour, perhaps
    const std::size_t chosen = *advice_.chosen;
    const auto error = [&](std::size_t i) {
      return *error_with_bar(advice_, i, wish_.measure);
    };
    for (std::size_t i = 0; i < advice_.chart.points.size(); ++i) {
      if (!is_candidate(i) || !cost(i)) continue;
      if (*cost(i) < *cost(chosen) && !meets(i) &&
          (!advice_.cheaper || error(i) < error(*advice_.cheaper)))
        advice_.cheaper = i;
      if (*cost(i) > *cost(chosen) && error(i) < error(chosen) &&
          (!advice_.dearer || *cost(i) < *cost(*advice_.dearer)))
        advice_.dearer = i;
    }
    advice_.left_out = left_out(advice_, wish_.measure, plan_);
  }

  /// An error that grows again on finer cells was small because others cancelled in it.
  void caution_of_accidents() {
    const StoredChart::Point chosen = advice_.chart.points[*advice_.chosen].place;
    const auto finer = std::ranges::upper_bound(sizes, chosen.across);
    if (finer == sizes.end()) return;
    for (const ChartModel& model : chart_models(shape_)) {
      if (model.name != chosen.model || model.kind != chosen.kind) continue;
      if (run_.expected_seconds(model, *finer) <= plan_.budget)
        run_.measure(model, *finer);
      const std::size_t place = *advice_.chosen;
      take_in();  // places stay: points are only added
      advice_.chosen = place;
      const auto next = point_of(model, *finer);
      if (!next || !is_candidate(*next) || meets_tolerance(*next)) return;
      advice_.cautions.push_back(fmt::format(
          "On {} across {} is {:.3g} % off: on {} errors cancel that another load or "
          "shape may add.",
          *finer, chosen.model,
          100 * *advice_.chart.points[*next].errors[advice_.truth].of(wish_.measure),
          chosen.across));
    }
  }

  const Wish& wish_;
  const ChartPlan& plan_;
  ChartRun& run_;
  BodyShape shape_;
  ChartKind kind_;
  double duration_;
  Advice advice_{};
  std::vector<const ChartModel*> alive_;
  std::map<const ChartModel*, int> failures_, stuck_;
  std::map<const ChartModel*, double> last_error_;
  std::map<std::string, bool> stable_;  // by the key of the motion
  double best_ = INFINITY;              // cost of what meets the wish
};

}  // namespace

std::optional<double> error_with_bar(const Advice& advice, std::size_t point,
                                     ChartMeasure measure) {
  const ChartPoint& of = advice.chart.points[point];
  const auto& error = of.errors[advice.truth].of(measure);
  if (!error) return std::nullopt;
  const auto& bar = measure == ChartMeasure::deviation
                        ? of.deviation_bars[advice.truth]
                        : advice.chart.truths[advice.truth].bars.of(measure);
  return *error + bar.value_or(0);
}

std::optional<Frame> frame_of(const ChartPoint& point, double duration) {
  if (!point.found || !point.found->dt_limit || !point.place.timing) return std::nullopt;
  const int all_steps = point.found->effort.value_or(Effort{}).steps;
  if (all_steps == 0) return std::nullopt;
  const double of_step =
      (point.place.timing->median - point.place.setup.value_or(0)) / all_steps;
  const int steps = static_cast<int>(
      std::max(1., std::ceil(duration / (step_ratio * *point.found->dt_limit))));
  return Frame{.steps = steps, .dt = duration / steps, .seconds = steps * of_step};
}

Advice advise(const Wish& wish, const ChartPlan& plan, ChartRun& run) {
  return Search(wish, plan, run).found();
}

}  // namespace springcheck
