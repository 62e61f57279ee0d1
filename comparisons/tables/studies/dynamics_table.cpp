#include "comparisons/tables/studies/dynamics_table.hpp"

#include <fmt/format.h>

#include "comparisons/settings/scene_file.hpp"
#include "comparisons/tables/thesis/printed_figures.hpp"
#include "comparisons/tables/thesis/thesis_tables.hpp"

namespace springcheck {
namespace {

constexpr std::string_view thesis_method = "mss-cf";

/// What is printed of it and computed here.
std::vector<std::pair<Quantity, PrintedFigure>> figures() {
  std::vector<std::pair<Quantity, PrintedFigure>> all;
  for (const char* table : {"5.1", "5.2", "5.3", "5.4"})
    for (const PrintedFigure& figure : printed_figures(table))
      if (figure.method == thesis_method)
        all.emplace_back(printed_quantity(table), figure);
  return all;
}

/// The same of a body in raw units: what is printed in 1e-4 N or 1e-6 N m is in N or N m
/// there, since with lengths that are a hundred times larger forces grow by E L^2 and
/// torques by E L^3.
Quantity of_raw_units(Quantity quantity) {
  if (quantity.unit != "%") quantity.factor = 1;
  return quantity;
}

/// Static, dynamic in SI units, dynamic in raw ones.
std::vector<CaseSettings> cases_of(const PrintedFigure& figure) {
  const GivenSettings common{{"method", std::string(thesis_method)},
                             {"nu", figure.nu},
                             {"deformation", figure.deformation}};
  const GivenSettings raw = common + GivenSettings{{"history", 200}};
  const GivenSettings dynamic = raw + GivenSettings{{"solver", "semi-implicit"}};
  const std::string scene(name_of(figure.test));
  return {case_of_scene(scene, common), case_of_scene(scene, dynamic),
          case_of_scene(scene + "-thesis-raw", raw)};
}

std::optional<double> energy_ratio(const Measures& m) {
  if (!m.kinetic_energy || !m.strain_energy) return std::nullopt;
  return *m.kinetic_energy / *m.strain_energy;
}

Table filled(std::span<const CaseResult> results) {
  Table table{
      .columns = {{"test", "test"},
                  {"nu", "nu", "{:g}"},
                  {"deformation", "deformation"},
                  {"measure", "measure"},
                  {"printed", "printed", "{:.6g}"},
                  {"static", "static", "{:.5g}"},
                  {"dynamic", "dynamics, SI", "{:.5g}"},
                  {"dynamic_transits", "transits", "{:.1f}"},
                  {"dynamic_damping", "damping", "{:g}"},
                  {"dynamic_kinetic", "kinetic/strain energy", "{:.1e}"},
                  {"raw", "dynamics, raw units", "{:.5g}"},
                  {"raw_transits", "transits", "{:.1f}"},
                  {"raw_damping", "damping", "{:g}"},
                  {"raw_kinetic", "kinetic/strain energy", "{:.1e}"}},
      .notes = {
          "Dynamics: 10 s with the plate at constant velocity. In SI units steps of .9 "
          "of the stability limit; in raw units, centimetres read as metres, steps of 1 "
          "ms as the thesis states. The thesis states no damping.",
          "Transits: how often a pressure wave runs through the body's height meanwhile. "
          "In raw units the body is a hundred times larger, and waves have hardly "
          "crossed it a few times before the figure is read."}};
  const auto all = figures();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [quantity, figure] = all[i];
    const CaseResult &still = results[3 * i], &moved = results[3 * i + 1],
                     &raw = results[3 * i + 2];
    const auto value = [](const CaseResult& result, const Quantity& of) {
      return value_or_status(value_of(of, result.measures), result);
    };
    TableRow row{.cells = {name_of(figure.test), figure.nu,
                           deformation_text(figure.test, figure.deformation),
                           heading(quantity), figure.value, value(still, quantity)},
                 .cases = {still.key, moved.key, raw.key},
                 .in_json = {{"unit", quantity.unit}}};
    for (const auto& [result, of] :
         {std::pair(&moved, quantity), std::pair(&raw, of_raw_units(quantity))}) {
      row.cells.push_back(value(*result, of));
      row.cells.push_back(result->measures.transit_count);
      row.cells.push_back(result->request.settings.dynamics.damping_ratio);
      row.cells.push_back(energy_ratio(result->measures));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

TablePlan plan_dynamics_table() {
  TablePlan plan{.make = [](std::span<const CaseResult> results, MeshStore&) {
    return filled(results);
  }};
  for (const auto& [quantity, figure] : figures())
    for (CaseSettings& settings : cases_of(figure))
      plan.requests.push_back({.settings = std::move(settings)});
  return plan;
}

}  // namespace springcheck
