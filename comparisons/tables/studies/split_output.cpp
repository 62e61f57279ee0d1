#include "comparisons/tables/studies/split_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <ranges>

#include "comparisons/formats/text_table.hpp"
#include "comparisons/measures/measure_list.hpp"
#include "comparisons/settings/setting.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

Json json(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json json(const ConvergedValue& converged) {
  Json grids = Json::array();
  for (const auto& [cells, key, value] : converged.grids)
    grids.push_back({{"cells", cells}, {"value", json(value)}, {"key", key}});
  return {{"value", json(converged.value)},
          {"order", json(converged.order)},
          {"bar", json(converged.error_bound)},
          {"grids", grids}};
}

Json json(const ContinuumValue& both) {
  Json out = json(both.converged);
  out["check"] = json(both.check);
  out["disagreement"] = json(both.disagreement);
  out["resolved"] = both.is_resolved;
  return out;
}

Json json(const ErrorPart& part) {
  return {{"value", json(part.value)}, {"bar", json(part.error_bound)}};
}

std::string cells_of(const ThreeCases& cases) {
  const auto of_grid = [](const CaseSettings& grid) {
    return fmt::format("{}", fmt::join(grid.body.block.cells, " x "));
  };
  return fmt::format("{}", fmt::join(cases | std::views::transform(of_grid), ", "));
}

std::string with_error_bound(const std::optional<double>& value,
                             const std::optional<double>& error_bound, double factor) {
  if (!value || !error_bound) return "-";
  return fmt::format("{:.5g} +- {:.2g}", factor * *value, factor * *error_bound);
}

std::string with_order(const ConvergedValue& converged, double factor) {
  return fmt::format("{}{}",
                     with_error_bound(converged.value, converged.error_bound, factor),
                     converged.order ? fmt::format(" ({:.2f})", *converged.order) : "");
}

}  // namespace

Json split_json(const Split& split) {
  Json quantities;
  for (const SplitQuantity& quantity : split.quantities)
    quantities[quantity.name] = {{"springs", json(quantity.springs)},
                                 {"cauchy_born", json(quantity.cauchy_born)},
                                 {"reference", json(quantity.reference)},
                                 {"law", json(quantity.law)},
                                 {"discretisation", json(quantity.discretisation)},
                                 {"resolved", quantity.is_resolved()}};
  return {{"cauchy_born", label(split.plan.cauchy_born[0])},
          {"reference", label(split.plan.reference[0])},
          {"check_element", split.plan.reference_check[0].elements.element.name},
          {"quantities", quantities},
          {"reasons", split.reasons}};
}

std::string split_text(const Split& split) {
  const SplitPlan& plan = split.plan;
  std::vector<std::vector<std::string>> rows{
      {"", variant_label(plan.springs), "Cauchy-Born",
       std::string(plan.reference[0].method.name), "law", "discretisation",
       "converged values"}};
  for (const SplitQuantity& quantity : split.quantities) {
    const Measure& measure = *find_measure(quantity.name);
    const double factor = shown_factor(measure);
    rows.push_back(
        {heading_of(measure),
         quantity.springs ? fmt::format("{:.5g}", factor * *quantity.springs) : "-",
         with_order(quantity.cauchy_born.converged, factor),
         with_order(quantity.reference.converged, factor),
         with_error_bound(quantity.law.value, quantity.law.error_bound, factor),
         with_error_bound(quantity.discretisation.value,
                          quantity.discretisation.error_bound, factor),
         quantity.is_resolved() ? "resolved" : "unresolved"});
  }
  std::string text = fmt::format(
      "Error of {} split: law = Cauchy-Born - {}, discretisation = springs - "
      "Cauchy-Born.\n{}",
      variant_label(plan.springs), plan.reference[0].method.name, in_columns(rows));
  text += fmt::format(
      "Converged from {} on {} cells, +- error bound (order observed, believed up to the "
      "formal one); checked with {} on {}.\nDeviations are mean distances from the "
      "converged {}; the springs' from "
      "Cauchy-Born is their discretisation part.\n",
      plan.reference[0].elements.element.name, cells_of(plan.reference),
      plan.reference_check[0].elements.element.name, cells_of(plan.reference_check),
      plan.reference[0].method.name);
  for (const std::string& reason : split.reasons) text += reason + "\n";
  return text;
}

}  // namespace springcheck
