#include "comparisons/advice/left_out.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/methods/methods.hpp"
#include "comparisons/running/simulate.hpp"

namespace springcheck {
namespace {

class Words {
 public:
  Words(const Advice& advice, const std::vector<ChartMeasure>& measures,
        const ChartPlan& plan)
      : advice_(advice),
        measures_(measures),
        plan_(plan),
        chosen_(advice.chart.points[advice.chosen.value()]),
        model_(chosen_.place.model) {}

  std::vector<std::string> all() {
    methods();
    elements();
    finite_elements();
    other_cells();
    precision();
    finer_cells();
    return std::move(words_);
  }

 private:
  /// The measured point of a model on cells as near to the chosen one's as there are.
  [[nodiscard]] const ChartPoint* beside(const Model& model) const {
    const ChartPoint* nearest = nullptr;
    const auto distance = [&](const ChartPoint& point) {
      return std::abs(point.place.across - chosen_.place.across);
    };
    for (const ChartPoint& point : advice_.chart.points)
      if (point.place.model == model && is_comparable(point) &&
          (nearest == nullptr || distance(point) < distance(*nearest)))
        nearest = &point;
    return nearest;
  }

  [[nodiscard]] bool is_comparable(const ChartPoint& point) const {
    return point.place.kind == chosen_.place.kind &&
           point.place.threads == chosen_.place.threads && point.found && point.seconds();
  }

  /// "2.1 % off in volume, in 0.12 s", or its failure.
  [[nodiscard]] std::string figures(const ChartPoint& point) const {
    std::optional<double> largest;
    ChartMeasure of{};
    for (const ChartMeasure measure : measures_)
      if (const auto& error = point.errors[advice_.truth].of(measure);
          error && (!largest || *error > *largest)) {
        largest = error;
        of = measure;
      }
    if (!point.is_ok() || !largest)
      return fmt::format("{}", name_of(point.found->status));
    return fmt::format("{:.3g} % off in {}, in {}", 100 * *largest, name_of(of),
                       time_text(point));
  }

  void say(std::string_view what, const ChartPoint& point) {
    words_.push_back(fmt::format("{}: {} on {} across is {}.", what,
                                 name_of(point.place.model), point.place.across,
                                 figures(point)));
  }

  void say_if_measured(std::string_view what, const Model& model) {
    if (const ChartPoint* point = beside(model)) say(what, *point);
  }

  void methods() {
    const Method* method = find_method(model_.method);
    if (method == nullptr) return;
    const Material material = settings_of(plan_, chosen_.place).material;
    for (const auto& [what, by, no_loss] : method->omits) {
      const std::string_view instead = no_loss == nullptr ? "" : no_loss(material);
      if (!instead.empty()) {
        words_.emplace_back(instead);
      } else if (by.empty()) {
        if (advice_.is_path_known) words_.emplace_back(what);
      } else {
        Model other = model_;
        other.method = by;
        say_if_measured(what, other);
      }
    }
  }

  void elements() {
    const ElementName* element = find_element(model_.element);
    if (element == nullptr) return;
    for (const auto& [what, by, no_loss] : element->omits) {
      Model other = model_;
      other.element = by;
      other.linear_solver.clear();
      say_if_measured(what, other);
    }
  }

  void finite_elements() {
    const Method* method = find_method(model_.method);
    if (method == nullptr || method->family != Family::springs) return;
    Model other{.method = advice_.chart.stored.law, .element = "q1-sri"};
    if (model_.precision) {
      const auto moving = moving_elements(model_.cells, *model_.precision);
      if (moving.empty()) return;
      const auto of_law = std::ranges::find_if(moving, [&](const Model& model) {
        return at_rest(*find_method(model.method)).name == advice_.chart.stored.law;
      });
      other = of_law == moving.end() ? moving.front() : *of_law;
    }
    say_if_measured("No finite elements", other);
  }

  void other_cells() {
    const auto say_of = [&](CellType cells, std::string_view what) {
      Model other = model_;
      other.cells = cells;
      say_if_measured(fmt::format("No {}{}", what, plural_of(cells)), other);
    };
    if (model_.cells != CellType::hexahedron) return say_of(CellType::hexahedron, "");
    for (const CellType cells : {CellType::tetrahedron, CellType::prism})
      say_of(cells, "cells on ");
  }

  void precision() {
    if (model_.precision != dynamics::Precision::single_precision) return;
    Model other = model_;
    other.precision = dynamics::Precision::double_precision;
    say_if_measured("No double precision", other);
  }

  void finer_cells() {
    const ChartPoint* finer = nullptr;
    for (const ChartPoint& point : advice_.chart.points)
      if (point.place.model == model_ && is_comparable(point) &&
          point.place.across > chosen_.place.across &&
          (finer == nullptr || point.place.across < finer->place.across))
        finer = &point;
    if (finer != nullptr) say("No finer cells", *finer);
  }

  const Advice& advice_;
  const std::vector<ChartMeasure>& measures_;
  const ChartPlan& plan_;
  const ChartPoint& chosen_;
  const Model& model_;
  std::vector<std::string> words_;
};

}  // namespace

std::vector<std::string> left_out(const Advice& advice,
                                  const std::vector<ChartMeasure>& measures,
                                  const ChartPlan& plan) {
  return Words(advice, measures, plan).all();
}

}  // namespace springcheck
