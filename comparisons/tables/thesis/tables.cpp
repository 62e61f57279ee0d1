#include "comparisons/tables/thesis/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string_view>

#include "comparisons/cases/grids.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/studies/converged_number.hpp"
#include "comparisons/tables/thesis/printed_figures.hpp"
#include "comparisons/tables/thesis/table_notes.hpp"

namespace springcheck {
namespace {

using Reference = std::optional<ReferenceMethod>;

Quantity volume_error() {
  return {"e", "%", "{:.3f}", [](const Measures& m) -> std::optional<double> {
            if (!m.volume_error) return std::nullopt;
            return 100 * *m.volume_error;
          }};
}

/// A measure times a factor.
Quantity scaled(std::string name, std::string unit, std::string format,
                Measures::Value Measures::*measure, double factor) {
  return {std::move(name), std::move(unit), std::move(format),
          [measure, factor](const Measures& m) -> std::optional<double> {
            if (!(m.*measure)) return std::nullopt;
            return factor * *(m.*measure);
          }};
}

Request request_of(const std::string& scene, const std::string& method,
                   const Changes& overrides, const Reference& reference) {
  SceneFile file = read_scene(scene);
  for (const auto& [key, value] : Changes{{"method", method}} + overrides)
    file.settings.push_back({key, value});
  RunSettings run = make_run_settings(file.name, file.file, file.settings);
  if (reference) run.reference = reference;
  return requests(run).front();
}

/// A row of our method beside a printed figure.
PlannedRow row_of(const PrintedFigure& figure, const std::string& method,
                  const Changes& further, const Reference& reference) {
  const std::string scene(name_of(figure.test));
  Changes overrides{{"nu", figure.nu}, {"deformation", figure.deformation}};
  overrides.insert(overrides.end(), further.begin(), further.end());
  PlannedRow row{.labels = {fmt::format("{:g}", figure.nu),
                            deformation_text(figure.test, figure.deformation), method},
                 .request = request_of(scene, method, overrides, reference),
                 .printed = figure.value,
                 .printed_text = figure.text,
                 .verdict = figure.verdict};
  row.labels.back() = variant_label(row.request.settings);
  return row;
}

bool has(const std::vector<std::string_view>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

/// A footnote of tables 5.1 to 5.4, and the rows that have it.
struct NoteRule {
  const char* note;
  std::vector<std::string_view> methods;
  std::vector<std::string_view> tables{};  // empty: all four
  std::optional<double> nu{};
  std::optional<bool> is_large{};   // of deformations above 10 %
  bool has_young_form_too = false;  // which gets a row of its own

  [[nodiscard]] bool holds(const std::string& table, const PrintedFigure& figure,
                           const std::string& method) const {
    return has(methods, method) && (tables.empty() || has(tables, table)) &&
           (!nu || *nu == figure.nu) &&
           (!is_large || *is_large == (figure.deformation > 0.1));
  }
};

// The laws beside the FEM column.
const std::vector<std::string_view> printed_laws{"fem-hencky", "fem-hooke", "fem-stvk"};
const std::vector<std::string_view> of_st_venants_law{"fem-stvk", "mss-stvk",
                                                      "mss-affine-stvk"};

const std::vector<NoteRule>& note_rules() {
  using namespace table_notes;
  static const std::vector<NoteRule> all{
      {fem_column, printed_laws},
      {tension_mesh, printed_laws, {"5.2"}},
      {small_strain, {"fem-hooke"}, {"5.4"}, {}, true},
      {st_venants_volume, of_st_venants_law, {"5.1", "5.2"}, 0.499},
      {table_notes::dynamics, {"mss-baudet", "mss-nfd", "mss-cf"}, {"5.3", "5.4"}},
      {baudet, {"mss-baudet"}, {"5.3", "5.4"}},
      {same_network, {"mss-baudet", "mss-nfd"}, {"5.1", "5.2"}, 0.25},
      {no_compression, {"mss-nfd"}, {"5.1"}, 0, true},
      {tension_nu_0, {"mss-cf", "mss-nfd"}, {"5.2"}, 0, false},
      {no_tension, {"mss-cf", "mss-nfd"}, {"5.2"}, 0, true},
      {young_form, {"mss-cf"}, {"5.1"}, 0, {}, true},
      {young_form_wrinkles, {"mss-nfd"}, {"5.1"}, 0, {}, true}};
  return all;
}

std::vector<std::string> notes_of(const std::string& table, const PrintedFigure& figure,
                                  const std::string& method) {
  std::vector<std::string> notes;
  for (const NoteRule& rule : note_rules())
    if (rule.holds(table, figure, method)) notes.emplace_back(rule.note);
  return notes;
}

/// The row of a method, and that of its E-form where the printed value needs it.
void add_rows(std::vector<PlannedRow>& rows, const std::string& table,
              const PrintedFigure& figure, const std::string& method,
              const Reference& reference) {
  rows.push_back(row_of(figure, method, {}, reference));
  rows.back().notes = notes_of(table, figure, method);
  for (const NoteRule& rule : note_rules()) {
    if (!rule.has_young_form_too || !rule.holds(table, figure, method)) continue;
    rows.push_back(row_of(figure, method, {{"stiffness-form", "E"}}, reference));
    rows.back().notes.emplace_back(rule.note);
  }
}

/// What rows of a method that is not in the thesis are compared with: what was asked for,
/// or the law that it follows and, where that is another, the thesis's.
std::vector<Reference> references_of(const Method& method, const Reference& asked) {
  if (asked || method.same_law_as.empty()) return {asked};
  const auto elements_of = [](const Method& law) {
    return ReferenceMethod{law, *find_element("q1-sri")};
  };
  std::vector<Reference> all{elements_of(*find_method(method.same_law_as))};
  if (method.same_law_as != thesis_law().name) all.push_back(elements_of(thesis_law()));
  return all;
}

/// Of methods that are not in the thesis, under the load of a printed figure.
void add_unprinted(std::vector<PlannedRow>& rows, const std::string& table,
                   const PrintedFigure& figure, const Reference& asked) {
  for (const Method& method : methods()) {
    if (!method.beside_printed) continue;
    for (const Reference& reference : references_of(method, asked)) {
      PlannedRow row = row_of(figure, method.name, {}, reference);
      row.printed.reset();
      row.printed_text.clear();
      row.verdict.clear();
      row.notes = notes_of(table, figure, method.name);
      rows.push_back(std::move(row));
    }
  }
}

/// Whether the figures print another load after the i-th; those of one follow each other.
bool is_last_of_load(const std::vector<PrintedFigure>& figures, std::size_t i) {
  return i + 1 == figures.size() || figures[i + 1].test != figures[i].test ||
         figures[i + 1].nu != figures[i].nu ||
         figures[i + 1].deformation != figures[i].deformation;
}

/// Rows of tables 5.1 to 5.4: one per printed figure, but three laws for the FEM column
/// and the E-form beside the mu-form where the printed value needs it; and of each load
/// methods that are not in the thesis.
std::vector<PlannedRow> rows_of(const std::string& table, const Reference& reference) {
  std::vector<PlannedRow> rows;
  const std::vector<PrintedFigure> figures = printed_figures(table);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const PrintedFigure& figure = figures[i];
    if (figure.method == "fem")
      for (const std::string_view law : printed_laws)
        add_rows(rows, table, figure, std::string(law), reference);
    else
      add_rows(rows, table, figure, figure.method, reference);
    if (is_last_of_load(figures, i)) add_unprinted(rows, table, figure, reference);
  }
  return rows;
}

TablePlan volume_table(const std::string& name, const std::string& title,
                       const Reference& reference) {
  return {.name = name,
          .title = title,
          .label_headings = {"nu", "deformation", "method"},
          .quantity = volume_error(),
          .further = {scaled("smallest V/V0 of a cell", "-", "{:.4f}",
                             &Measures::cell_volume_ratio_min, 1),
                      scaled("largest V/V0 of a cell", "-", "{:.4f}",
                             &Measures::cell_volume_ratio_max, 1),
                      scaled("plate force", "N", "{:.6g}", &Measures::plate_force, 1)},
          .rows = rows_of(name, reference),
          .notes = {table_notes::exact_volume, table_notes::law_of_springs}};
}

TablePlan shear_table(const Reference& reference) {
  return {.name = "5.3",
          .title = "Force on the plate in shearing (thesis, table 5.3)",
          .label_headings = {"nu", "deformation", "method"},
          .quantity =
              scaled("resultant", "1e-4 N", "{:.0f}", &Measures::plate_force_norm, 1e4),
          .further = {scaled("sideways force", "1e-4 N", "{:.0f}", &Measures::plate_force,
                             1e4)},
          .rows = rows_of("5.3", reference),
          .notes = {table_notes::units, table_notes::law_of_springs}};
}

TablePlan torsion_table(const Reference& reference) {
  return {
      .name = "5.4",
      .title = "Torque on the plate in torsion (thesis, table 5.4)",
      .label_headings = {"nu", "deformation", "method"},
      .quantity = scaled("torque", "1e-6 N m", "{:.0f}", &Measures::plate_torque, 1e6),
      .rows = rows_of("5.4", reference),
      .notes = {table_notes::units, table_notes::torsion_angle,
                table_notes::law_of_springs}};
}

TablePlan deviation_table(const Reference& reference) {
  TablePlan plan{
      .name = "deviation",
      .title = "Distance of springs' points from the reference's, section 5.6.2",
      .label_headings = {"test", "nu", "deformation", "method"},
      .quantity = scaled("mean on the middle layer", "cm", "{:.4f}",
                         &Measures::middle_layer_deviation, 100),
      .further = {scaled("mean over all nodes", "cm", "{:.4f}", &Measures::mean_deviation,
                         100),
                  scaled("largest", "cm", "{:.4f}", &Measures::max_deviation, 100),
                  scaled("relative L2", "%", "{:.2f}", &Measures::deviation_l2_relative,
                         100),
                  scaled("relative largest", "%", "{:.2f}",
                         &Measures::deviation_max_relative, 100),
                  scaled("rms difference of cells' V/V0", "-", "{:.4f}",
                         &Measures::cell_volume_ratio_rms_difference, 1)},
      .notes = {
          "The relative measures are volume-weighted over the free nodes and divided "
          "by the largest imposed displacement.",
          table_notes::layer, table_notes::torsion_angle, table_notes::law_of_springs}};
  const std::vector<PrintedFigure> figures = printed_figures(plan.name);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    std::vector<PlannedRow> rows{row_of(figures[i], figures[i].method, {}, reference)};
    rows.front().notes.emplace_back(table_notes::deviation);
    if (is_last_of_load(figures, i))
      add_unprinted(rows, plan.name, figures[i], reference);
    for (PlannedRow& row : rows)
      row.labels.insert(row.labels.begin(), std::string(name_of(figures[i].test)));
    plan.rows.insert(plan.rows.end(), rows.begin(), rows.end());
  }
  return plan;
}

TablePlan bending_table(const Reference& reference) {
  TablePlan plan{
      .name = "bending",
      .title = "Beams under gravity, figures 5.15 to 5.19: drop of the tip",
      .label_headings = {"scene", "E [MPa]", "cells", "method"},
      .quantity = scaled("tip drop", "m", "{:.5g}", &Measures::tip_deflection, 1),
      .further =
          {scaled("Euler-Bernoulli", "m", "{:.5g}", &Measures::tip_euler_bernoulli, 1),
           scaled("Timoshenko", "m", "{:.5g}", &Measures::tip_timoshenko, 1),
           scaled("elastica", "m", "{:.5g}", &Measures::tip_elastica, 1),
           scaled("centre line off Euler-Bernoulli", "m", "{:.3g}",
                  &Measures::centre_line_euler_bernoulli, 1),
           scaled("off Timoshenko", "m", "{:.3g}", &Measures::centre_line_timoshenko, 1),
           scaled("off the elastica", "m", "{:.3g}", &Measures::centre_line_elastica, 1)},
      .notes = {table_notes::figures_only,
                "The distances are the largest between a node of the centre line and the "
                "theory's point of the same arc length. The elastica is inextensible and "
                "has no shear; Timoshenko's shear factor is 5/6."}};
  const auto add = [&](const std::string& scene, double young, const Cells& cells,
                       const std::string& method, const std::string& element,
                       const std::string& verdict) {
    PlannedRow row{
        .labels = {},
        .request = request_of(scene, method,
                              {{"young", young}, {"cells", cells}, {"element", element}},
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

/// Puts in the quantity of the reference, extrapolated where it ran on three grids. None
/// for deviations, which are from it.
void set_reference_value(TableRow& row, const Quantity& quantity,
                         std::span<const CaseResult> runs) {
  if (runs.size() == 1) row.reference_value = quantity.of(runs.front().measures);
  if (runs.size() != 3) return;
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<double> value = quantity.of(runs[i].measures);
    if (!value) return;
    values[i] = *value;
  }
  const ConvergedNumber limit = converged_number(
      {runs[0].request.settings, runs[1].request.settings, runs[2].request.settings},
      values);
  row.reference_value = limit.value;
  row.reference_order = limit.order;
  row.reference_bar = limit.bar;
}

struct ThesisTable {
  std::string_view name, description;
  TablePlan (*plan)(const Reference&);
};

constexpr std::array thesis_tables{
    ThesisTable{"5.1", "volume change in compression, printed in the thesis and ours",
                [](const Reference& reference) {
                  return volume_table("5.1",
                                      "Volume change in compression (thesis, table 5.1)",
                                      reference);
                }},
    ThesisTable{"5.2", "volume change in tension, printed and ours",
                [](const Reference& reference) {
                  return volume_table(
                      "5.2", "Volume change in tension (thesis, table 5.2)", reference);
                }},
    ThesisTable{"5.3", "force on the plate in shearing, printed and ours", shear_table},
    ThesisTable{"5.4", "torque on the plate in torsion, printed and ours", torsion_table},
    ThesisTable{"deviation", "deviation from the reference's points, printed and ours",
                deviation_table},
    ThesisTable{"bending", "a beam's tip, printed and ours, beside beam theory",
                bending_table}};

}  // namespace

const std::vector<std::string>& table_names() {
  static const auto names = [] {
    std::vector<std::string> all;
    for (const ThesisTable& table : thesis_tables) all.emplace_back(table.name);
    return all;
  }();
  return names;
}

std::vector<Described> described_thesis_tables() {
  std::vector<Described> all;
  for (const ThesisTable& table : thesis_tables)
    all.push_back({table.name, table.description});
  return all;
}

TablePlan plan_table(const std::string& name, const Reference& reference) {
  const auto* table = std::ranges::find(thesis_tables, name, &ThesisTable::name);
  if (table == thesis_tables.end()) throw std::logic_error("no table '" + name + "'");
  return table->plan(reference);
}

std::vector<Request> table_requests(const TablePlan& plan) {
  std::vector<Request> all;
  for (const PlannedRow& row : plan.rows) {
    all.push_back(row.request);
    for (const CaseSettings& reference : reference_cases(row.request))
      all.push_back({.settings = reference});
  }
  return all;
}

Table fill_table(TablePlan plan, const std::vector<CaseResult>& results) {
  Table table{.plan = std::move(plan)};
  std::size_t next = 0;
  for (const PlannedRow& planned : table.plan.rows) {
    TableRow row{.plan = planned, .result = results.at(next++)};
    const std::size_t references = reference_cases(planned.request).size();
    set_reference_value(row, table.plan.quantity,
                        std::span(results).subspan(next, references));
    next += references;
    row.ours = table.plan.quantity.of(row.result.measures);
    if (row.ours && planned.printed) row.difference = *row.ours - *planned.printed;
    for (const Quantity& quantity : table.plan.further)
      row.further.push_back(quantity.of(row.result.measures));
    if (std::ranges::count(row.result.flags, Status::wrinkled) > 0)
      row.plan.notes.emplace_back(table_notes::wrinkled);
    if (!row.result.revision.empty())
      row.plan.notes.push_back(
          fmt::format("Of revision {} of the numerics.", row.result.revision));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace springcheck
