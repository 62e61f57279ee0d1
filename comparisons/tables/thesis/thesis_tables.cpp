#include "comparisons/tables/thesis/thesis_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>
#include <utility>

#include "comparisons/settings/setting.hpp"
#include "comparisons/tables/thesis/table_notes.hpp"

namespace springcheck {
namespace {

constexpr std::pair<std::string_view, Quantity> printed_quantities[]{
    {"5.1", {"e", "%", "{:.3f}", &Measures::volume_error, 100}},
    {"5.2", {"e", "%", "{:.3f}", &Measures::volume_error, 100}},
    {"5.3", {"resultant", "1e-4 N", "{:.0f}", &Measures::plate_force_norm, 1e4}},
    {"5.4", {"torque", "1e-6 N m", "{:.0f}", &Measures::plate_torque, 1e6}}};

/// Table 5.1 or 5.2.
ComparisonPlan volume_comparison(const std::string& name, const Reference& reference) {
  return {.label_headings = {"nu", "deformation", "method"},
          .quantity = printed_quantity(name),
          .further = {{"smallest V/V0 of a cell", "-", "{:.4f}",
                       &Measures::cell_volume_ratio_min, 1},
                      {"largest V/V0 of a cell", "-", "{:.4f}",
                       &Measures::cell_volume_ratio_max, 1},
                      {"plate force", "N", "{:.6g}", &Measures::plate_force, 1}},
          .rows = printed_rows(name, reference),
          .notes = {table_notes::exact_volume, table_notes::law_of_springs}};
}

}  // namespace

Quantity printed_quantity(std::string_view table) {
  for (const auto& [name, quantity] : printed_quantities)
    if (name == table) return quantity;
  throw std::logic_error("a table of the thesis that is none");
}

ComparisonPlan plan_compression(const Reference& reference) {
  return volume_comparison("5.1", reference);
}

ComparisonPlan plan_tension(const Reference& reference) {
  return volume_comparison("5.2", reference);
}

ComparisonPlan plan_shearing(const Reference& reference) {
  return {
      .label_headings = {"nu", "deformation", "method"},
      .quantity = printed_quantity("5.3"),
      .further = {{"sideways force", "1e-4 N", "{:.0f}", &Measures::plate_force, 1e4}},
      .rows = printed_rows("5.3", reference),
      .notes = {table_notes::units, table_notes::law_of_springs}};
}

ComparisonPlan plan_torsion(const Reference& reference) {
  return {.label_headings = {"nu", "deformation", "method"},
          .quantity = printed_quantity("5.4"),
          .rows = printed_rows("5.4", reference),
          .notes = {table_notes::units, table_notes::torsion_angle,
                    table_notes::law_of_springs}};
}

ComparisonPlan plan_deviation(const Reference& reference) {
  ComparisonPlan plan{
      .label_headings = {"test", "nu", "deformation", "method"},
      .quantity = {"mean on the middle layer", "cm", "{:.4f}",
                   &Measures::middle_layer_deviation, 100},
      .further = {{"mean over all nodes", "cm", "{:.4f}", &Measures::mean_deviation, 100},
                  {"largest", "cm", "{:.4f}", &Measures::max_deviation, 100},
                  {"relative L2", "%", "{:.2f}", &Measures::deviation_l2_relative, 100},
                  {"relative largest", "%", "{:.2f}", &Measures::deviation_max_relative,
                   100},
                  {"rms difference of cells' V/V0", "-", "{:.4f}",
                   &Measures::cell_volume_ratio_rms_difference, 1}},
      .notes = {
          "The relative measures are volume-weighted over the free nodes and divided "
          "by the largest imposed displacement.",
          table_notes::layer, table_notes::torsion_angle, table_notes::law_of_springs}};
  const std::vector<PrintedFigure> figures = printed_figures("deviation");
  for (std::size_t i = 0; i < figures.size(); ++i) {
    std::vector<PlannedRow> rows{row_of(figures[i], figures[i].method, {}, reference)};
    rows.front().notes.emplace_back(table_notes::deviation);
    add_unprinted(rows, figures, i, reference);
    for (PlannedRow& row : rows)
      row.labels.insert(row.labels.begin(), std::string(name_of(figures[i].test)));
    plan.rows.insert(plan.rows.end(), rows.begin(), rows.end());
  }
  return plan;
}

ComparisonPlan plan_bending(const Reference& reference) {
  ComparisonPlan plan{
      .label_headings = {"scene", "E [MPa]", "cells", "method"},
      .quantity = {"tip deflection", "m", "{:.5g}", &Measures::tip_deflection, 1},
      .further = {{"Euler-Bernoulli", "m", "{:.5g}", &Measures::tip_euler_bernoulli, 1},
                  {"Timoshenko", "m", "{:.5g}", &Measures::tip_timoshenko, 1},
                  {"elastica", "m", "{:.5g}", &Measures::tip_elastica, 1},
                  {"centre line off Euler-Bernoulli", "m", "{:.3g}",
                   &Measures::centre_line_euler_bernoulli, 1},
                  {"off Timoshenko", "m", "{:.3g}", &Measures::centre_line_timoshenko, 1},
                  {"off the elastica", "m", "{:.3g}", &Measures::centre_line_elastica,
                   1}},
      .notes = {table_notes::figures_only,
                "The distances are the largest between a node of the centre line and the "
                "theory's point of the same arc length. The elastica is inextensible and "
                "has no shear; Timoshenko's shear factor is 5/6."}};
  const auto add = [&](const std::string& scene, double young, const Cells& cells,
                       const std::string& method, const std::string& element,
                       const std::string& verdict) {
    PlannedRow row{
        .labels = {},
        .request = printed_request(
            scene, method, {{"young", young}, {"cells", cells}, {"element", element}},
            reference),
        .verdict = verdict};
    row.labels = {
        scene, fmt::format("{:g}", young / 1e6),
        fmt::format("{}", fmt::join(row.request.settings.body.block.cells, " x ")),
        label(row.request.settings)};
    plan.rows.push_back(std::move(row));
  };
  for (const double young : {10e6, 2e6})
    for (const Cells& cells : {Cells{4, 4, 24}, Cells{8, 8, 48}}) {
      const bool shown = young == 2e6;  // figure 5.15
      add("bending", young, cells, "mss-baudet", "q1-sri", shown ? "yes" : "");
      add("bending", young, cells, "mss-nfd", "q1-sri", shown ? "yes" : "");
      add("bending", young, cells, "mss-cf", "q1-sri", shown ? "no" : "");
      add("bending", young, cells, "fem-stvk", "q1-sri", "");
    }
  for (const Cells& cells : {Cells{4, 4, 24}, Cells{8, 8, 48}}) {
    add("bending-cm", 2e6, cells, "mss-cf", "q1-sri", "");
    add("bending-cm", 2e6, cells, "fem-hooke", "q1", "");
    add("bending-cm", 2e6, cells, "fem-hooke", "q1-sri", "");
  }
  return plan;
}

}  // namespace springcheck
