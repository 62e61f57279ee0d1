#include "comparisons/chart/advise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "comparisons/chart/left_out.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/running/progress.hpp"

namespace springcheck {
namespace {

constexpr std::array sizes{2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32};
constexpr double still_falls = 0.9;  // error over that of the next coarser cells
constexpr double spread_of_forecasts = 2;
/// What the next finer cells say of a point that meets the tolerance.
struct OnFinerCells {
  bool were_seen = false;  // not beyond the budget
  std::string against{};   // empty where they meet it too
};

class Search {
 public:
  Search(const Wish& wish, const ChartPlan& plan, Measurements& measurements)
      : wish_(wish), plan_(plan), measurements_(measurements) {
    shape_ = chart_body(plan.scene, plan.options).shape;
    for (const ChartModel& model : chart_models(shape_))
      if (model.kind == wish.kind()) alive_.push_back(&model);
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
    choose();
    if (advice_.chosen) {
      find_neighbours();
      advice_.left_out = left_out(advice_, wish_.measure, plan_);
    }
    return std::move(advice_);
  }

 private:
  [[nodiscard]] Judge judge() const { return {wish_, advice_.chart}; }
  [[nodiscard]] const ChartPoint& point(std::size_t i) const {
    return advice_.chart.points[i];
  }

  /// Places stay: points are only added.
  void take_in() {
    advice_.chart = measurements_.chart();
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
    std::vector<const ChartModel*> tried;
    for (const ChartModel* model : alive_)
      if (run_if_within(*model, across, most_seconds())) tried.push_back(model);
    take_in();
    for (const std::size_t i : cheapest_first())
      if (const double cost = *judge().cost(i); cost < best_ && is_sound(i)) best_ = cost;
    std::erase_if(tried,
                  [&](const ChartModel* model) { return !goes_on(*model, across); });
    alive_ = std::move(tried);
  }

  /// Whether the model was expected to take no longer, and was run.
  bool run_if_within(const ChartModel& model, int across, double seconds) {
    if (measurements_.expected_seconds(model, across) > seconds) return false;
    measurements_.measure(model, across);
    return true;
  }

  /// [s] of a solution that is worth trying.
  [[nodiscard]] double most_seconds() const {
    const double of_best = wish_.frame ? best_ * duration_ : best_;
    return std::min(wish_.budget, spread_of_forecasts * of_best);
  }

  /// The model's point on so many cells across; none where it was not run.
  [[nodiscard]] std::optional<std::size_t> point_of(const ChartModel& model,
                                                    int across) const {
    for (std::size_t i = 0; i < advice_.chart.points.size(); ++i) {
      const StoredChart::Point& place = point(i).place;
      if (place.model == model.model && place.across == across &&
          place.threads == wish_.threads && point(i).found)
        return i;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool goes_on(const ChartModel& model, int across) {
    const auto place = point_of(model, across);
    if (!place) return false;
    const auto error = judge().error(*place);
    if (!point(*place).is_ok() || !error) return ++failures_[&model] < 2;
    // A sound point has set best_; another one that is cheaper was not sound.
    if (judge().meets_tolerance(*place))
      return *judge().cost(*place) < best_ && ++failures_[&model] < 3;
    const double off = *point(*place).errors[advice_.truth].of(wish_.measure);
    const auto before = last_error_.find(&model);
    const bool is_stuck =
        before != last_error_.end() && off > still_falls * before->second;
    stuck_[&model] = is_stuck ? stuck_[&model] + 1 : 0;
    last_error_[&model] = off;
    return stuck_[&model] < 2;
  }

  /// All points that meet the wish.
  [[nodiscard]] std::vector<std::size_t> cheapest_first() const {
    std::vector<std::size_t> meeting;
    for (std::size_t i = 0; i < advice_.chart.points.size(); ++i)
      if (judge().meets(i)) meeting.push_back(i);
    std::ranges::stable_sort(meeting, {},
                             [&](std::size_t i) { return *judge().cost(i); });
    return meeting;
  }

  /// Whether a point that meets the tolerance is to be relied on.
  [[nodiscard]] bool is_sound(std::size_t i) {
    return path_of(i).against.empty() && on_finer_cells(i).against.empty();
  }

  [[nodiscard]] StaticPath path_of(std::size_t i) {
    const StoredChart::Point& place = point(i).place;
    return measurements_.static_path(chart_model(place.model, shape_), place.across);
  }

  [[nodiscard]] const OnFinerCells& on_finer_cells(std::size_t i) {
    const std::string key = point(i).place.key;
    if (!on_finer_cells_.contains(key)) on_finer_cells_[key] = look_at_finer_cells(i);
    return on_finer_cells_[key];
  }

  /// By the error alone: what the truth may be off differs from mesh to mesh.
  [[nodiscard]] OnFinerCells look_at_finer_cells(std::size_t i) {
    const StoredChart::Point place = point(i).place;
    const auto finer = std::ranges::upper_bound(sizes, place.across);
    const ChartModel& model = chart_model(place.model, shape_);
    if (finer == sizes.end() || !run_if_within(model, *finer, wish_.budget)) return {};
    take_in();
    const auto next = point_of(model, *finer);
    if (!next) return {};
    const auto& error = point(*next).errors[advice_.truth].of(wish_.measure);
    if (!point(*next).is_ok() || !error)
      return {
          .were_seen = true,
          .against = fmt::format("On {} across {} is {}.", *finer, name_of(place.model),
                                 name_of(point(*next).found->status))};
    if (*error <= wish_.tolerance) return {.were_seen = true};
    return {
        .were_seen = true,
        .against = fmt::format(
            "On {} across {} is {:.3g} % off: on {} errors cancel that another load or "
            "shape may add.",
            *finer, name_of(place.model), 100 * *error, place.across)};
  }

  void choose() {
    std::vector<std::size_t> sound;  // that cannot be told from the first
    std::optional<std::size_t> accidental;
    for (const std::size_t i : cheapest_first()) {
      if (!sound.empty() && judge().is_cheaper(sound.front(), i)) continue;
      if (const std::string against = path_of(i).against; !against.empty())
        advice_.cautions.push_back(fmt::format(
            "{} on {} across would do, but not by a stable path to the full load: {}.",
            name_of(point(i).place.model), point(i).place.across, against));
      else if (on_finer_cells(i).against.empty())
        sound.push_back(i);
      else if (!accidental)
        accidental = i;
    }
    if (!sound.empty()) {
      advice_.chosen = smallest_of_equals(sound);
    } else if (accidental) {
      advice_.chosen = accidental;
      advice_.cautions.push_back(on_finer_cells(*accidental).against);
    } else {
      find_nearest();
    }
    if (advice_.chosen && !path_of(*advice_.chosen).was_followed) {
      advice_.is_path_known = false;
      advice_.cautions.emplace_back(
          "Whether its path to the full load is stable was not looked at: that would "
          "take more than the budget or the memory that is left.");
    }
    if (advice_.chosen && !on_finer_cells(*advice_.chosen).were_seen)
      advice_.cautions.emplace_back(
          "Whether its errors only cancel was not looked at: finer cells would take more "
          "than the budget or the memory that is left.");
  }

  /// Of points that cannot be told from each other by their times.
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
      if (judge().is_candidate(i)) candidates.push_back(i);
    std::ranges::stable_sort(candidates, {},
                             [&](std::size_t i) { return judge().distance(i); });
    const auto nearest = std::ranges::find_if(
        candidates, [&](std::size_t i) { return path_of(i).against.empty(); });
    if (nearest != candidates.end()) advice_.nearest = *nearest;
  }

  void find_neighbours() {
    const Judge judged = judge();
    const std::size_t chosen = *advice_.chosen;
    for (std::size_t i = 0; i < advice_.chart.points.size(); ++i) {
      if (!judged.is_candidate(i)) continue;
      if (*judged.cost(i) < *judged.cost(chosen) && !judged.meets(i) &&
          (!advice_.cheaper || *judged.error(i) < *judged.error(*advice_.cheaper)))
        advice_.cheaper = i;
      if (*judged.cost(i) > *judged.cost(chosen) &&
          *judged.error(i) < *judged.error(chosen) &&
          (!advice_.dearer || *judged.cost(i) < *judged.cost(*advice_.dearer)))
        advice_.dearer = i;
    }
  }

  const Wish& wish_;
  const ChartPlan& plan_;
  Measurements& measurements_;
  BodyShape shape_;
  double duration_;
  Advice advice_{};
  std::vector<const ChartModel*> alive_;
  std::map<const ChartModel*, int> failures_, stuck_;
  std::map<const ChartModel*, double> last_error_;
  std::map<std::string, OnFinerCells> on_finer_cells_;  // by the key of the point's case
  double best_ = INFINITY;  // cost of what meets the wish and is sound
};

}  // namespace

Advice advise(const Wish& wish, const ChartPlan& plan, Measurements& measurements) {
  return Search(wish, plan, measurements).found();
}

}  // namespace springcheck
