#include "comparisons/tables/thesis/printed_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/tables/thesis/table_notes.hpp"

namespace springcheck {
namespace {

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

/// Whether the figures print another load after the i-th; those of one follow each other.
bool is_last_of_load(const std::vector<PrintedFigure>& figures, std::size_t i) {
  return i + 1 == figures.size() || figures[i + 1].test != figures[i].test ||
         figures[i + 1].nu != figures[i].nu ||
         figures[i + 1].deformation != figures[i].deformation;
}

}  // namespace

Request printed_request(const std::string& scene, const std::string& method,
                        const GivenSettings& changes, const Reference& reference) {
  RunSettings run = read_run(scene, GivenSettings{{"method", method}} + changes);
  if (reference) run.reference = reference;
  return requests(run).front();
}

PlannedRow row_of(const PrintedFigure& figure, const std::string& method,
                  const GivenSettings& further, const Reference& reference) {
  const std::string scene(name_of(figure.test));
  PlannedRow row{
      .labels = {fmt::format("{:g}", figure.nu),
                 deformation_text(figure.test, figure.deformation), method},
      .request = printed_request(
          scene, method,
          GivenSettings{{"nu", figure.nu}, {"deformation", figure.deformation}} + further,
          reference),
      .printed = figure.value,
      .printed_text = figure.text,
      .verdict = figure.verdict};
  row.labels.back() = variant_label(row.request.settings);
  return row;
}

void add_unprinted(std::vector<PlannedRow>& rows, const std::string& table,
                   const std::vector<PrintedFigure>& figures, std::size_t i,
                   const Reference& asked) {
  if (!is_last_of_load(figures, i)) return;
  const PrintedFigure& figure = figures[i];
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

std::vector<PlannedRow> printed_rows(const std::string& table,
                                     const Reference& reference) {
  std::vector<PlannedRow> rows;
  const std::vector<PrintedFigure> figures = printed_figures(table);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const PrintedFigure& figure = figures[i];
    if (figure.method == "fem")
      for (const std::string_view law : printed_laws)
        add_rows(rows, table, figure, std::string(law), reference);
    else
      add_rows(rows, table, figure, figure.method, reference);
    add_unprinted(rows, table, figures, i, reference);
  }
  return rows;
}

}  // namespace springcheck
