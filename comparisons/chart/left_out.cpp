#include "comparisons/chart/left_out.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/running/simulate.hpp"

namespace springcheck {
namespace {

/// A model's name in parts: "fem-stvk:q1 on tetrahedra" is method fem-stvk, rest ":q1 on
/// tetrahedra"; "mss-cf, float" is mss-cf and ", float".
struct Name {
  std::string method, rest;
};

Name parts_of(const std::string& model) {
  const std::size_t end = std::min(model.find_first_of(":, "), model.size());
  return {.method = model.substr(0, end), .rest = model.substr(end)};
}

class Words {
 public:
  Words(const Advice& advice, ChartMeasure measure, const ChartPlan& plan)
      : advice_(advice),
        measure_(measure),
        plan_(plan),
        chosen_(advice.chart.points[advice.chosen.value()]),
        name_(parts_of(chosen_.place.model)) {}

  std::vector<std::string> all() {
    corrections();
    face_diagonals();
    laws();
    elements();
    other_cells();
    precision();
    finer_cells();
    return std::move(words_);
  }

 private:
  /// The measured point of a model on cells as near to the chosen one's as there are.
  [[nodiscard]] const ChartPoint* beside(const std::string& model) const {
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

  /// "2.1 % off in 0.12 s", or its failure.
  [[nodiscard]] std::string figures(const ChartPoint& point) const {
    const auto& error = point.errors[advice_.truth].of(measure_);
    if (!point.is_ok() || !error) return fmt::format("{}", name_of(point.found->status));
    return fmt::format("{:.3g} % off in {}", 100 * *error, time_text(point));
  }

  void say(const std::string& what, const ChartPoint& point) {
    words_.push_back(fmt::format("{}: {} on {} across is {}.", what, point.place.model,
                                 point.place.across, figures(point)));
  }

  void say_if_measured(const std::string& what, const std::string& model) {
    if (const ChartPoint* point = beside(model)) say(what, *point);
  }

  void corrections() {
    if (name_.method != "mss-fd" && name_.method != "mss-baudet") return;
    const double nu = settings_of(plan_, chosen_.place).material.poisson_ratio;
    if (name_.method == "mss-fd" && nu == 0.25) {
      words_.emplace_back(
          "No volume correction: at nu = 1/4 its modulus is zero, and springs alone have "
          "the Poisson ratio.");
      return;
    }
    say_if_measured("No volume correction",
                    (name_.method == "mss-fd" ? "mss-cf" : "mss-nfd") + name_.rest);
  }

  void face_diagonals() {
    if (name_.method != "mss-nfd" && name_.method != "mss-baudet") return;
    if (!advice_.is_path_known) return;
    words_.emplace_back(
        "No face diagonals: without them the path to the full load stays stable on these "
        "cells (its tangent positive definite).");
  }

  void laws() {
    if (name_.method == "fem-hooke") {
      say_if_measured("Hooke's law does here, beside it St-Venant's",
                      "fem-stvk" + name_.rest);
    } else if (name_.method == "fem-stvk") {
      say_if_measured("Not Hooke's law", "fem-hooke" + name_.rest);
      say_if_measured("No logarithmic strain", "fem-hencky" + name_.rest);
    } else if (name_.method == "fem-hencky") {
      say_if_measured("Not Hooke's law", "fem-hooke" + name_.rest);
    }
  }

  void elements() {
    if (name_.rest.starts_with(":q1-sri")) {
      say_if_measured("No quadratic elements", name_.method + ":q2");
    } else if (name_.rest == ":q1") {
      say_if_measured("No reduced integration", name_.method + ":q1-sri");
      say_if_measured("No quadratic elements", name_.method + ":q2");
    } else if (name_.method == "fem-explicit-1p") {
      say_if_measured("No further points of integration", "fem-explicit-8p" + name_.rest);
    } else if (name_.method.starts_with("mss-") &&
               chosen_.place.kind == ChartKind::equilibrium) {
      say_if_measured("No finite elements", advice_.chart.stored.law + ":q1-sri");
    } else if (name_.method.starts_with("mss-")) {
      say_if_measured("No finite elements", "fem-explicit-8p" + name_.rest);
    }
  }

  void other_cells() {
    if (const std::size_t on = chosen_.place.model.find(" on ");
        on != std::string::npos) {
      const std::size_t end = chosen_.place.model.find(',', on);
      std::string on_hexahedra = chosen_.place.model;
      on_hexahedra.erase(on, end == std::string::npos ? end : end - on);
      say_if_measured("No hexahedra", on_hexahedra);
      return;
    }
    for (const char* cells : {" on tetrahedra", " on prisms"})
      say_if_measured(fmt::format("No cells{}", cells),
                      chosen_.place.model + std::string(cells));
  }

  void precision() {
    const std::size_t single = chosen_.place.model.find(", float");
    if (single == std::string::npos) return;
    say_if_measured("No double precision",
                    chosen_.place.model.substr(0, single) + ", double");
  }

  void finer_cells() {
    const ChartPoint* finer = nullptr;
    for (const ChartPoint& point : advice_.chart.points)
      if (point.place.model == chosen_.place.model && is_comparable(point) &&
          point.place.across > chosen_.place.across &&
          (finer == nullptr || point.place.across < finer->place.across))
        finer = &point;
    if (finer != nullptr) say("No finer cells", *finer);
  }

  const Advice& advice_;
  ChartMeasure measure_;
  const ChartPlan& plan_;
  const ChartPoint& chosen_;
  Name name_;
  std::vector<std::string> words_;
};

}  // namespace

std::vector<std::string> left_out(const Advice& advice, ChartMeasure measure,
                                  const ChartPlan& plan) {
  return Words(advice, measure, plan).all();
}

}  // namespace springcheck
