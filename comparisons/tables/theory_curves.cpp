#include "comparisons/tables/theory_curves.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "comparisons/cases/case.hpp"
#include "comparisons/cases/status.hpp"
#include "comparisons/measures/beam_measures.hpp"
#include "comparisons/methods/methods.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

/// So many equal steps, both ends included.
std::vector<double> evenly(double from, double to, int steps) {
  std::vector<double> values;
  for (int i = 0; i <= steps; ++i) values.push_back(from + (to - from) * i / steps);
  return values;
}

double kappa_over_young(double nu) {
  return mss::volume_correction_modulus(
      {.young_modulus = 1, .poisson_ratio = nu, .density = 1});
}

/// Poisson's ratios finer and finer towards 1/2, where kappa has its pole.
Json volume_modulus(const Columns& cases) {
  std::vector<double> ratios = evenly(-0.9, 0.4, 100);
  for (double distance = 0.095; distance > 5e-4; distance *= 0.95)
    ratios.push_back(0.5 - distance);
  std::vector<double> moduli;
  for (const double nu : ratios) moduli.push_back(kappa_over_young(nu));
  std::set<double> used;
  if (const auto column = cases.numbers.find("nu"); column != cases.numbers.end())
    used.insert(column->second.values.begin(), column->second.values.end());
  Json of_cases = Json::array();
  for (const double nu : used)
    of_cases.push_back({{"nu", nu}, {"kappa_over_young", kappa_over_young(nu)}});
  return {{"nu", ratios},
          {"kappa_over_young", moduli},
          {"cases", of_cases},
          {"source", "Golec 2018, Eq. 5.36"}};
}

Json method_descriptions() {
  Json descriptions = Json::object();
  for (const Method& method : methods())
    descriptions[method.name] = std::string(method.description);
  return descriptions;
}

std::vector<double> numbers(const Row& row, const char* name, std::size_t width) {
  const auto found = row.find(name);
  const auto* values =
      found == row.end() ? nullptr : std::get_if<std::vector<double>>(&found->second);
  return values != nullptr && values->size() == width ? *values : std::vector<double>{};
}

bool has_text(const Row& row, const char* name, std::string_view text) {
  const auto found = row.find(name);
  const auto* value =
      found == row.end() ? nullptr : std::get_if<std::string>(&found->second);
  return value != nullptr && *value == text;
}

/// The part of the load that acts on what a case tells: the one that a path ended with;
/// of a case that failed on its way the whole, which was asked for.
double load_reached(const Row& row) {
  const std::vector<double> fraction = numbers(row, "load_fraction", 1);
  const bool has_failed = std::ranges::none_of(
      std::array{Status::ok, Status::wrinkled, Status::inverted, Status::indefinite},
      [&](Status status) { return has_text(row, "status", name_of(status)); });
  return fraction.empty() || has_failed ? 1 : fraction.front();
}

/// A beam with all that tells it from others, for JSON.
struct Beam {
  Cantilever theory;
  Json json;
};

std::optional<Beam> beam_of(const Row& row) {
  if (!has_text(row, "test", name_of(Test::bending)) ||
      !has_text(row, "body", name_of(BodyShape::block)))
    return std::nullopt;
  const auto size = numbers(row, "size", 3), gravity = numbers(row, "gravity", 3),
             young = numbers(row, "young", 1), nu = numbers(row, "nu", 1),
             density = numbers(row, "density", 1);
  if (size.empty() || gravity.empty() || young.empty() || nu.empty() || density.empty())
    return std::nullopt;
  const Vector3 g = load_reached(row) * Vector3(gravity[0], gravity[1], gravity[2]);
  const auto theory = cantilever(
      {size[0], size[1], size[2]},
      {.young_modulus = young[0], .poisson_ratio = nu[0], .density = density[0]}, g);
  if (!theory) return std::nullopt;
  return Beam{.theory = *theory,
              .json = {{"length", theory->length},
                       {"width", theory->width},
                       {"height", theory->height},
                       {"young", young[0]},
                       {"nu", nu[0]},
                       {"density", density[0]},
                       {"gravity", g.norm()}}};
}

Json curve(const std::vector<BeamPoint>& points) {
  std::vector<double> drop, axial;
  for (const BeamPoint& point : points) {
    drop.push_back(point.drop);
    axial.push_back(point.axial);
  }
  return {{"drop", drop}, {"axial", axial}};
}

void add_curves(Json& json, const Cantilever& beam) {
  const std::vector<double> s = evenly(0, beam.length, 40);
  std::vector<BeamPoint> bent, sheared;
  for (const double at : s) {
    bent.push_back(euler_bernoulli(beam, at));
    sheared.push_back(timoshenko(beam, at));
  }
  json["arc_length"] = s;
  json["euler_bernoulli"] = curve(bent);
  json["timoshenko"] = curve(sheared);
  json["elastica"] = curve(elastica(beam, s));
}

}  // namespace

Json theory_curves(const Columns& cases) {
  std::vector<std::pair<Beam, std::vector<std::string>>> beams;  // with their cases
  for (std::size_t i = 0; i < cases.rows; ++i) {
    const auto beam = beam_of(row_at(cases, i));
    if (!beam) continue;
    auto known = std::ranges::find_if(
        beams, [&](const auto& entry) { return entry.first.json == beam->json; });
    if (known == beams.end()) known = beams.insert(known, {*beam, {}});
    known->second.push_back(cases.texts.at("key")[i]);
  }
  Json list = Json::array();
  for (const auto& [beam, keys] : beams) {
    Json json{{"cases", keys}};
    json.update(beam.json);
    add_curves(json, beam.theory);
    list.push_back(std::move(json));
  }
  return {{"methods", method_descriptions()},
          {"volume_modulus", volume_modulus(cases)},
          {"beams", list}};
}

}  // namespace springcheck
