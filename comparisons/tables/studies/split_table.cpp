#include "comparisons/tables/studies/study_tables.hpp"

#include <fmt/format.h>

#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/tables/studies/split_output.hpp"

namespace springcheck {
namespace {

/// The five tests of mss-cf at nu = 1/4, small and large.
std::vector<CaseSettings> springs_of_the_table() {
  std::vector<CaseSettings> all;
  const auto add = [&](const std::string& scene, const Change& load) {
    all.push_back(case_of_scene(scene, {{"method", "mss-cf"}, {"nu", 0.25}, load}));
  };
  for (const char* scene : {"compression", "tension", "shearing"})
    for (const char* strain : {"5%", "20%"}) add(scene, {"deformation", strain});
  for (const char* angle : {"1deg", "45deg"}) add("torsion", {"deformation", angle});
  add("bending", {"young", 10e6});
  return all;
}

std::string load_of(const CaseSettings& settings) {
  if (settings.deformation) return deformation_text(settings.test, *settings.deformation);
  return fmt::format("{:g} MPa", settings.material.young_modulus / 1e6);
}

std::optional<double> scaled(const std::optional<double>& value, double factor) {
  return value ? std::optional(factor * *value) : std::nullopt;
}

/// A part in percent of the converged reference, where that is not a difference itself.
std::optional<double> percent(const ErrorPart& part, const SplitQuantity& quantity) {
  const bool is_force =
      quantity.name != "volume_change" && quantity.name != "mean_deviation";
  const auto& whole = quantity.reference.converged.value;
  if (!is_force || !whole) return std::nullopt;
  return scaled(part.value, 100 / *whole);
}

std::vector<std::string> keys_of(const SplitQuantity& quantity,
                                 const CaseResult& springs) {
  std::vector<std::string> keys{springs.key};
  for (const ContinuumValue* both : {&quantity.cauchy_born, &quantity.reference})
    for (const ConvergedValue* converged : {&both->converged, &both->check})
      for (const GridValue& grid : converged->grids) keys.push_back(grid.key);
  return keys;
}

SheetRow row_of(const SplitQuantity& quantity, const Split& split,
                const CaseResult& springs) {
  const CaseSettings& settings = split.plan.springs;
  const auto [name, unit, factor] = shown_measure(quantity.name);
  const auto& lattice = quantity.cauchy_born.converged;
  const auto& law = quantity.reference.converged;
  return {
      .cells = {settings.scene, load_of(settings), name, unit,
                value_or_status(scaled(quantity.springs, factor), springs),
                scaled(lattice.value, factor), scaled(lattice.bar, factor), lattice.order,
                scaled(law.value, factor), scaled(law.bar, factor), law.order,
                scaled(quantity.law.value, factor), scaled(quantity.law.bar, factor),
                scaled(quantity.discretisation.value, factor),
                scaled(quantity.discretisation.bar, factor),
                percent(quantity.law, quantity),
                percent(quantity.discretisation, quantity),
                quantity.is_resolved() ? "resolved" : "unresolved"},
      .notes = split.reasons,
      .cases = keys_of(quantity, springs)};
}

}  // namespace

Sheet split_sheet(const std::vector<Split>& splits,
                  const std::vector<CaseResult>& springs) {
  Sheet sheet{
      .name = "split",
      .title = "Where mss-cf's error comes from, nu = 0.25: law and discretisation",
      .columns = {{"scene", "scene"},
                  {"load", "load"},
                  {"quantity", "quantity"},
                  {"unit", "unit"},
                  {"springs", "springs", "{:.5g}"},
                  {"cauchy_born", "Cauchy-Born", "{:.5g}"},
                  {"cauchy_born_bar", "Cauchy-Born +-", "{:.1g}"},
                  {"cauchy_born_order", "Cauchy-Born order", "{:.2f}"},
                  {"reference", "Hencky", "{:.5g}"},
                  {"reference_bar", "Hencky +-", "{:.1g}"},
                  {"reference_order", "Hencky order", "{:.2f}"},
                  {"law", "law part", "{:+.3g}"},
                  {"law_bar", "law part +-", "{:.1g}"},
                  {"discretisation", "discretisation part", "{:+.3g}"},
                  {"discretisation_bar", "discretisation part +-", "{:.1g}"},
                  {"law_percent", "law part [% of Hencky]", "{:+.2f}"},
                  {"discretisation_percent", "discretisation part [% of Hencky]",
                   "{:+.2f}"},
                  {"state", "converged values"}},
      .notes = {
          "Law part: converged Cauchy-Born (the continuum of the springs' lattice) minus "
          "converged Hencky. Discretisation part: the springs on this mesh minus "
          "converged Cauchy-Born. The law part is as uncertain as both bars together, "
          "the discretisation part as Cauchy-Born's; the sign of a part within its bar "
          "is not known.",
          "Volume errors e are the absolute values of the volume changes.",
          "Mean deviations are mean distances over the nodes from converged Hencky, the "
          "discretisation part from converged Cauchy-Born.",
          "Converged: extrapolated from q1-sri on the springs' mesh and on 2 and 4 times "
          "as many cells along each axis, with the order observed. Bars: 1.25 times the "
          "distance from the finest grid, or 3 times the last change where no order was "
          "observed. A second discretisation, q2 on half, once and twice as many cells, "
          "is extrapolated likewise; where the two differ by more than their bars "
          "together, the row is unresolved."}};
  for (std::size_t i = 0; i < splits.size(); ++i)
    for (const SplitQuantity& quantity : splits[i].quantities)
      sheet.rows.push_back(row_of(quantity, splits[i], springs[i]));
  return sheet;
}

SheetPlan plan_split_table() {
  std::vector<SplitPlan> splits;
  SheetPlan plan;
  for (const CaseSettings& springs : springs_of_the_table()) {
    splits.push_back(plan_split(springs, thesis_law()));
    plan.requests.push_back({.settings = springs});
    const std::vector<Request> grids = split_requests(splits.back());
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
    return split_sheet(computed, springs);
  };
  return plan;
}

}  // namespace springcheck
