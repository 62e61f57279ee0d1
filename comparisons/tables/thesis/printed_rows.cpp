#include "comparisons/tables/thesis/printed_rows.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/tables/thesis/table_notes.hpp"

namespace springcheck {
namespace {

// The laws beside the FEM column.
constexpr std::array<std::string_view, 3> printed_laws{"fem-hencky", "fem-hooke",
                                                       "fem-stvk"};

/// Footnotes of the figure for a row of the method: those that name it, and where the row
/// is the figure's own those of all methods.
std::vector<std::string> notes_of(const PrintedFigure& figure, std::string_view method,
                                  bool is_own) {
  std::vector<std::string> notes;
  for (const std::string_view note : figure.notes) {
    const std::size_t colon = note.find(':');
    if (colon == note.npos ? is_own : note.substr(0, colon) == method)
      notes.emplace_back(table_notes::text(note.substr(colon + 1)));
  }
  return notes;
}

/// The row of a method, and that of its E-form where the printed value needs it.
void add_rows(std::vector<PlannedRow>& rows, const PrintedFigure& figure,
              const std::string& method, const Reference& reference) {
  rows.push_back(row_of(figure, method, {}, reference));
  rows.back().notes = notes_of(figure, method, true);
  if (figure.e_form_note.empty()) return;
  rows.push_back(row_of(figure, method, {{"stiffness-form", "E"}}, reference));
  rows.back().notes.emplace_back(table_notes::text(figure.e_form_note));
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

void add_unprinted(std::vector<PlannedRow>& rows,
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
      row.notes = notes_of(figure, method.name, false);
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
        add_rows(rows, figure, std::string(law), reference);
    else
      add_rows(rows, figure, figure.method, reference);
    add_unprinted(rows, figures, i, reference);
  }
  return rows;
}

}  // namespace springcheck
