#include "comparisons/tables/studies/split_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <utility>

#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/tables/studies/split_output.hpp"

namespace springcheck {
namespace {

/// The five tests of mss-cf at nu = 1/4, small and large, on the scenes' own cells.
std::vector<SplitPlan> five_tests() {
  std::vector<SplitPlan> splits;
  const auto add = [&](const std::string& scene, const GivenSetting& load) {
    splits.push_back(plan_split(
        case_of_scene(scene, {{"method", "mss-cf"}, {"nu", 0.25}, load}), thesis_law()));
  };
  for (const char* scene : {"compression", "tension", "shearing"})
    for (const char* strain : {"5%", "20%"}) add(scene, {"deformation", strain});
  for (const char* angle : {"1deg", "45deg"}) add("torsion", {"deformation", angle});
  add("bending", {"young", 10e6});
  return splits;
}

struct Springs {
  GivenSettings changes;
  std::vector<const Method*> laws{&thesis_law()};  // to split their error against
};

/// The thesis's springs, those in logarithms, and springs that follow a law of finite
/// elements, these against their own law too.
std::vector<Springs> springs_of_all_laws() {
  std::vector<Springs> all{
      {.changes = {{"method", "mss-cf"}}},
      {.changes = {{"method", "mss-cf"}, {"spring-strain", "logarithmic"}}}};
  for (const Method& method : methods()) {
    if (method.same_law_as.empty() || !method.lattice) continue;
    all.push_back({.changes = {{"method", method.name}}});
    const Method& own = *find_method(method.same_law_as);
    if (own.name != thesis_law().name)
      all.back().laws.insert(all.back().laws.begin(), &own);
  }
  return all;
}

/// Large deformation of a cube of 5 x 5 x 5 cells by springs of all laws.
std::vector<SplitPlan> large_deformation() {
  std::vector<SplitPlan> splits;
  const std::array<std::pair<const char*, GivenSetting>, 4> tests{
      {{"compression", {"deformation", "20%"}},
       {"tension", {"deformation", "20%"}},
       {"shearing", {"deformation", "20%"}},
       {"torsion", {"deformation", "45deg"}}}};
  const GivenSettings cube{{"size", std::array{0.05, 0.05, 0.05}},
                           {"cells", std::array{5, 5, 5}}};
  for (const auto& [scene, load] : tests)
    for (const double nu : {0.0, 0.25, 0.4})
      for (const Springs& springs : springs_of_all_laws())
        for (const Method* law : springs.laws)
          splits.push_back(plan_split(
              case_of_scene(scene,
                            cube + springs.changes + GivenSettings{{"nu", nu}, load}),
              *law));
  return splits;
}

std::string load_of(const CaseSettings& settings) {
  if (settings.deformation) return deformation_text(settings.test, *settings.deformation);
  return fmt::format("{:g} MPa", settings.material.young_modulus / 1e6);
}

std::optional<double> scaled(const std::optional<double>& value, double factor) {
  return value ? std::optional(factor * *value) : std::nullopt;
}

/// A part in percent of the converged reference, where that is not a difference itself.
std::optional<double> percent(const std::optional<double>& part,
                              const SplitQuantity& quantity) {
  const bool is_force =
      quantity.name != "volume_change" && quantity.name != "mean_deviation";
  const auto& whole = quantity.reference.converged.value;
  if (!is_force || !whole) return std::nullopt;
  return scaled(part, 100 / *whole);
}

std::vector<std::string> keys_of(const SplitQuantity& quantity,
                                 const CaseResult& springs) {
  std::vector<std::string> keys{springs.key};
  for (const ContinuumValue* both : {&quantity.cauchy_born, &quantity.reference})
    for (const ConvergedValue* converged : {&both->converged, &both->check})
      for (const GridValue& grid : converged->grids) keys.push_back(grid.key);
  return keys;
}

TableRow row_of(const SplitQuantity& quantity, const Split& split,
                const CaseResult& springs) {
  const CaseSettings& settings = split.plan.springs;
  const Measure& measure = *find_measure(quantity.name);
  const double factor = shown_factor(measure);
  const auto& lattice = quantity.cauchy_born.converged;
  const auto& law = quantity.reference.converged;
  return {.cells = {settings.scene,
                    load_of(settings),
                    fmt::format("{}", fmt::join(settings.body.block.cells, "x")),
                    settings.material.poisson_ratio,
                    variant_label(settings),
                    split.plan.reference[0].method.name,
                    measure.label,
                    shown_unit(measure),
                    value_or_status(scaled(quantity.springs, factor), springs),
                    scaled(lattice.value, factor),
                    scaled(lattice.error_bound, factor),
                    lattice.order,
                    scaled(law.value, factor),
                    scaled(law.error_bound, factor),
                    law.order,
                    scaled(quantity.law.value, factor),
                    scaled(quantity.law.error_bound, factor),
                    scaled(quantity.discretisation.value, factor),
                    scaled(quantity.discretisation.error_bound, factor),
                    percent(quantity.law.value, quantity),
                    percent(quantity.law.error_bound, quantity),
                    percent(quantity.discretisation.value, quantity),
                    quantity.is_resolved() ? "resolved" : "unresolved"},
          .notes = split.reasons,
          .cases = keys_of(quantity, springs),
          .in_json = {{"measure", quantity.name}}};
}

}  // namespace

Table split_table(const std::vector<Split>& splits,
                  const std::vector<CaseResult>& springs) {
  Table table{
      .columns = {{"scene", "scene"},
                  {"load", "load"},
                  {"cells", "cells"},
                  {"nu", "nu", "{}"},
                  {"method", "method"},
                  {"reference_law", "reference"},
                  {"quantity", "quantity"},
                  {"unit", "unit"},
                  {"springs", "springs", "{:.5g}"},
                  {"cauchy_born", "Cauchy-Born", "{:.5g}"},
                  {"cauchy_born_bar", "Cauchy-Born +-", "{:.1g}"},
                  {"cauchy_born_order", "Cauchy-Born order", "{:.2f}"},
                  {"reference", "converged reference", "{:.5g}"},
                  {"reference_bar", "reference +-", "{:.1g}"},
                  {"reference_order", "reference order", "{:.2f}"},
                  {"law", "law part", "{:+.3g}"},
                  {"law_bar", "law part +-", "{:.1g}"},
                  {"discretisation", "discretisation part", "{:+.3g}"},
                  {"discretisation_bar", "discretisation part +-", "{:.1g}"},
                  {"law_percent", "law part [% of reference]", "{:+.3g}"},
                  {"law_percent_bar", "law part +- [% of reference]", "{:.1g}"},
                  {"discretisation_percent", "discretisation part [% of reference]",
                   "{:+.2f}"},
                  {"state", "converged values"}},
      .notes = {
          "Law part: converged Cauchy-Born (the continuum of the springs' lattice) minus "
          "the converged reference. Discretisation part: the springs on this mesh minus "
          "converged Cauchy-Born. The bound of a law part is that of the difference of "
          "both continua, extrapolated grid by grid with a safety factor of 3, where the "
          "last change counts for no less than what the one before it leaves, and the "
          "distance of that limit from the part; it is at least the distance from the "
          "part by q2. Of mean deviations it is both bounds together. The bound of the "
          "discretisation part is Cauchy-Born's. The sign of a part within its bound is "
          "not known.",
          "e is the volume change without its sign.",
          "Mean deviations are mean distances over the nodes from the converged "
          "reference, the discretisation part from converged Cauchy-Born.",
          "Converged: extrapolated from q1-sri on the springs' mesh and on 2 and 4 times "
          "as many cells along each axis, by the order observed where it is near the "
          "formal one or below; bounds have a safety factor of 1.25 or 3 (Oberkampf and "
          "Roy). A second discretisation, q2 on half, once and twice as many cells, "
          "is extrapolated likewise, and bounds are at least the disagreement; where "
          "that is more than the bounds that both sets of grids tell together, the row "
          "is unresolved."}};
  for (std::size_t i = 0; i < splits.size(); ++i)
    for (const SplitQuantity& quantity : splits[i].quantities)
      table.rows.push_back(row_of(quantity, splits[i], springs[i]));
  return table;
}

namespace {

TablePlan plan_of(const std::vector<SplitPlan>& splits) {
  TablePlan plan;
  for (const SplitPlan& split : splits) {
    plan.requests.push_back({.settings = split.springs});
    const std::vector<Request> grids = split_requests(split);
    plan.requests.insert(plan.requests.end(), grids.begin(), grids.end());
  }
  plan.make = [splits](std::span<const CaseResult> results, MeshStore& meshes) {
    std::vector<Split> computed;
    std::vector<CaseResult> springs;
    for (const SplitPlan& split : splits) {
      const std::size_t grids = split_requests(split).size();
      springs.push_back(results.front());
      computed.push_back(
          split_error(split, results.front(), results.subspan(1, grids), meshes));
      results = results.subspan(1 + grids);
    }
    return split_table(computed, springs);
  };
  return plan;
}

}  // namespace

TablePlan plan_split_table() {
  return plan_of(five_tests());
}

TablePlan plan_laws_table() {
  return plan_of(large_deformation());
}

}  // namespace springcheck
