#include "comparisons/advice/advise.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "comparisons/advice/left_out.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/running/progress.hpp"

namespace springcheck {
namespace {

constexpr double still_falls = 0.9;  // error over that of the next coarser cells
constexpr double spread_of_forecasts = 2;

class Search {
 public:
  Search(const Wish& wish, const ChartPlan& plan, Measurements& measurements)
      : wish_(wish),
        plan_(plan),
        measurements_(measurements),
        shape_(chart_body(plan.scene, plan.options).shape),
        examiner_(wish, shape_, measurements, advice_.chart) {
    for (const ChartModel& model : chart_models(shape_)) {
      if (model.kind != wish.kind()) continue;
      const CaseSettings settings =
          model_case(plan.scene, plan.options, model, sizes_across.front());
      duration_ = settings.dynamics.duration;
      if (has_poisson_ratio(settings.method, settings.material.poisson_ratio))
        candidates_.push_back(&model);
    }
    alive_ = candidates_;
  }

  Advice found() {
    {
      Progress progress("sizes");
      for (std::size_t i = 0; i < sizes_across.size() && !alive_.empty(); ++i) {
        progress.show(i, sizes_across.size());
        climb(sizes_across[i]);
      }
    }
    choose();
    find_not_shown();
    find_alternatives();
    if (advice_.chosen) advice_.left_out = left_out(advice_, wish_.measures, plan_);
    return std::move(advice_);
  }

 private:
  [[nodiscard]] Judge judge() const { return {wish_, advice_.chart}; }
  [[nodiscard]] const ChartPoint& point(std::size_t i) const {
    return advice_.chart.points[i];
  }

  /// Reads the chart as it is now. Indices of points stay valid: points are only
  /// appended.
  void update_chart() {
    advice_.chart = measurements_.chart();
    const std::string& law = advice_.chart.stored.law;
    advice_.truth = advice_.chart.truth_of(law).value();
  }

  /// Runs every model that may still win on one size.
  void climb(int across) {
    std::vector<const ChartModel*> tried;
    for (const ChartModel* model : alive_)
      if (examiner_.measure_if_within(*model, across, most_seconds()))
        tried.push_back(model);
    update_chart();
    for (const std::size_t i : cheapest_first())
      if (*judge().cost(i) < best_ && examiner_.of(i).is_sound())
        best_ = *judge().cost(i);
    std::erase_if(tried, [&](const ChartModel* model) {
      return !can_be_shown() || !is_worth_refining(*model, across);
    });
    alive_ = std::move(tried);
  }

  /// Whether the truth is known well enough for any point to be within the tolerance.
  [[nodiscard]] bool can_be_shown() const {
    const ChartErrors& error_bounds = advice_.chart.truths[advice_.truth].error_bounds;
    return std::ranges::all_of(wish_.measures, [&](ChartMeasure measure) {
      return measure == ChartMeasure::deviation ||  // its bound differs by mesh
             error_bounds.of(measure).value_or(0) < wish_.tolerance;
    });
  }

  /// Whether a point is cheaper than what is sound so far, and might be chosen if the
  /// truth were known better.
  [[nodiscard]] bool is_open(std::size_t i) const {
    return is_candidate(i) && judge().is_affordable(i) && *judge().cost(i) < best_ &&
           judge().proof(i) == Proof::open;
  }

  /// The longest time of a solution that is worth trying [s].
  [[nodiscard]] double most_seconds() const {
    const double of_best = wish_.frame ? best_ * duration_ : best_;
    return std::min(wish_.budget, spread_of_forecasts * of_best);
  }

  /// Whether the model's next size may win: not once a sound point met the tolerance, it
  /// failed twice, or its error stopped falling.
  [[nodiscard]] bool is_worth_refining(const ChartModel& model, int across) {
    const auto place = examiner_.point_of(model.model, across);
    if (!place) return false;
    if (!judge().is_candidate(*place)) return ++failures_[&model] < 2;
    // A sound point has set best_; another one that is cheaper was not sound.
    if (judge().meets_tolerance(*place) && *judge().cost(*place) >= best_) return false;
    const double off = judge().off(*place);
    const auto before = last_off_.find(&model);
    const bool is_stuck = before != last_off_.end() && off > still_falls * before->second;
    stuck_[&model] = is_stuck ? stuck_[&model] + 1 : 0;
    last_off_[&model] = off;
    return stuck_[&model] < 2;
  }

  /// All points that meet the wish, the cheapest first.
  [[nodiscard]] std::vector<std::size_t> cheapest_first() const {
    std::vector<std::size_t> meeting;
    for (std::size_t i = 0; i < advice_.chart.points.size(); ++i)
      if (is_candidate(i) && judge().meets(i)) meeting.push_back(i);
    std::ranges::stable_sort(meeting, {},
                             [&](std::size_t i) { return *judge().cost(i); });
    return meeting;
  }

  /// Whether a point is a candidate of the wish, and of a model that is tried: a file may
  /// hold points of others.
  [[nodiscard]] bool is_candidate(std::size_t i) const {
    return judge().is_candidate(i) &&
           std::ranges::any_of(candidates_, [&](const ChartModel* model) {
             return model->model == point(i).place.model;
           });
  }

  /// Times again the points that meet the wish, as far as they cost no more than 10 times
  /// the cheapest: a restless time may be too long by that factor.
  void time_contenders() {
    constexpr double restless = 10;
    const std::vector<std::size_t> meeting = cheapest_first();
    Progress progress("times");
    for (std::size_t n = 0; n < meeting.size(); ++n) {
      if (*judge().cost(meeting[n]) > restless * *judge().cost(meeting.front())) break;
      progress.show(n, meeting.size());
      const StoredChart::Point& place = point(meeting[n]).place;
      measurements_.time_again(chart_model(place.model, shape_), place.across);
    }
    update_chart();
  }

  void choose() {
    time_contenders();
    std::vector<std::size_t> sound;  // that cannot be told from the first
    for (const std::size_t i : cheapest_first()) {
      if (!sound.empty() && judge().is_cheaper(sound.front(), i)) continue;
      const Soundness& reasons = examiner_.of(i);
      if (!reasons.unstable.empty())
        advice_.cautions.push_back(fmt::format(
            "{} on {} across would do, but not by a stable path to the full load: {}.",
            name_of(point(i).place.model), point(i).place.across, reasons.unstable));
      else if (reasons.is_sound())
        sound.push_back(i);
      else
        advice_.crossings.emplace_back(i, reasons.crossing);
    }
    if (sound.empty()) return find_nearest();
    advice_.chosen = smallest_of_equals(sound);
    std::erase(sound, *advice_.chosen);
    advice_.equals = std::move(sound);

    say_what_was_not_seen(examiner_.of(*advice_.chosen));
  }

  void say_what_was_not_seen(const Soundness& reasons) {
    if (advice_.chart.tells_truth(*advice_.chosen, advice_.truth))
      advice_.cautions.emplace_back(
          "It is one of the grids that the converged solution is told from: its errors "
          "are known to the bound of that, and no further.");
    advice_.is_path_known = reasons.is_path_known;
    if (!reasons.is_path_known)
      advice_.cautions.emplace_back(
          "Whether its path to the full load is stable was not looked at: that would "
          "take more than the budget or the memory that is left.");
    if (reasons.is_finest)
      advice_.cautions.emplace_back(
          "Whether its errors only cancel was not looked at on finer cells: advice tries "
          "none.");
    else if (!reasons.were_finer_cells_seen)
      advice_.cautions.emplace_back(
          "Whether its errors only cancel was not looked at on finer cells: they would "
          "take more than ten times as long, or the memory that is left.");
    if (!reasons.without_truth.empty())
      advice_.cautions.push_back(fmt::format(
          "Whether it holds {} was not looked at: there is no equilibrium of q2.",
          fmt::join(reasons.without_truth, " and ")));
  }

  /// The point that takes the least memory, of those that cannot be told from each other
  /// by their times.
  [[nodiscard]] std::size_t smallest_of_equals(const std::vector<std::size_t>& sound) {
    const auto& models = chart_models(shape_);
    const auto size = [&](std::size_t i) {
      const auto rank =
          std::ranges::find(models, point(i).place.model, &ChartModel::model);
      return std::pair(estimated_memory(settings_of(plan_, point(i).place)),
                       rank - models.begin());
    };
    std::size_t smallest = sound.front();
    for (const std::size_t i : sound)
      if (size(i) < size(smallest)) smallest = i;
    return smallest;
  }

  void find_nearest() {
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < advice_.chart.points.size(); ++i)
      if (is_candidate(i) && !judge().meets(i)) candidates.push_back(i);
    std::ranges::stable_sort(candidates, {},
                             [&](std::size_t i) { return judge().distance(i); });
    const auto nearest = std::ranges::find_if(candidates, [&](std::size_t i) {
      const StoredChart::Point& place = point(i).place;
      return measurements_.static_path(chart_model(place.model, shape_), place.across)
          .against.empty();
    });
    if (nearest != candidates.end()) advice_.nearest = *nearest;
  }

  /// Finds the cheapest point that is not chosen for the truth's error bound alone.
  void find_not_shown() {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < advice_.chart.points.size(); ++i)
      if (is_open(i)) open.push_back(i);
    std::ranges::stable_sort(open, {}, [&](std::size_t i) { return *judge().cost(i); });
    const auto sound = std::ranges::find_if(
        open, [&](std::size_t i) { return examiner_.of(i).is_sound(); });
    if (sound != open.end()) advice_.not_shown = *sound;
  }

  /// Finds the points that the advice names beside the chosen one.
  void find_alternatives() {
    if (!advice_.chosen) return;
    const Judge judged = judge();
    const double cost = *judged.cost(*advice_.chosen);
    const auto costs_less = [&](std::size_t i, const std::optional<std::size_t>& other) {
      return !other || *judged.cost(i) < *judged.cost(*other);
    };
    for (std::size_t i = 0; i < advice_.chart.points.size(); ++i) {
      if (!is_candidate(i)) continue;
      if (*judged.cost(i) < cost && judged.is_affordable(i) &&
          judged.proof(i) == Proof::beyond &&
          (!advice_.cheaper || judged.error(i) < judged.error(*advice_.cheaper)))
        advice_.cheaper = i;
      if (*judged.cost(i) > cost && judged.error(i) < judged.error(*advice_.chosen) &&
          costs_less(i, advice_.dearer) && examiner_.against_law(i).empty())
        advice_.dearer = i;
    }
  }

  const Wish& wish_;
  const ChartPlan& plan_;
  Measurements& measurements_;
  BodyShape shape_;
  double duration_ = 0;
  Advice advice_{};
  Examiner examiner_;
  std::vector<const ChartModel*> candidates_, alive_;
  std::map<const ChartModel*, int> failures_, stuck_;
  std::map<const ChartModel*, double> last_off_;
  double best_ = INFINITY;  // cost of what meets the wish and is sound
};

}  // namespace

Advice advise(const Wish& wish, const ChartPlan& plan, Measurements& measurements) {
  return Search(wish, plan, measurements).found();
}

}  // namespace springcheck
