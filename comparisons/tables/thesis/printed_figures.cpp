#include "comparisons/tables/thesis/printed_figures.hpp"

#include <array>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "comparisons/settings/given.hpp"
#include "comparisons/shipped/shipped.hpp"

namespace springcheck {
namespace {

Test test_named(const std::string& name) {
  for (const Test test :
       {Test::compression, Test::tension, Test::shearing, Test::torsion})
    if (name_of(test) == name) return test;
  throw std::logic_error("printed.csv: unknown test " + name);
}

std::vector<std::string> words_in(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

}  // namespace

std::vector<PrintedFigure> printed_figures(const std::string& table) {
  std::vector<PrintedFigure> figures;
  std::istringstream lines{std::string(shipped_figures())};
  bool in_header = true;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    if (in_header) {  // the column names
      in_header = false;
      continue;
    }
    std::array<std::string, 9> fields;
    std::istringstream row(line);
    for (std::string& field : fields) std::getline(row, field, ',');
    const auto& [name, test, method, nu, deformation, value, verdict, notes,
                 e_form_note] = fields;
    const Given amount = Given::from_text("printed.csv", deformation);
    if (name == table)
      figures.push_back({.test = test_named(test),
                         .method = method,
                         .nu = Given::from_text("printed.csv", nu).finite_number(),
                         .deformation = amount.in(
                             test == "torsion" ? Dimension::angle : Dimension::fraction),
                         .value = Given::from_text("printed.csv", value).finite_number(),
                         .text = value,
                         .verdict = verdict,
                         .notes = words_in(notes),
                         .e_form_note = e_form_note});
  }
  return figures;
}

}  // namespace springcheck
