#include "comparisons/cases/model.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace springcheck {
namespace {

constexpr std::string_view on = " on ", then = ", ";

/// What stands before `mark`, which is taken away with it; all where there is none.
std::string taken_until(std::string& text, std::string_view mark) {
  const std::size_t place = text.find(mark);
  std::string before = text.substr(0, place);
  text.erase(0, place == std::string::npos ? place : place + mark.size());
  return before;
}

}  // namespace

std::string name_of(const Model& model) {
  std::string name = model.method;
  if (!model.element.empty()) name += ":" + model.element;
  if (model.cells != CellType::hexahedron)
    name += fmt::format("{}{}", on, plural_of(model.cells));
  if (!model.linear_solver.empty())
    name += fmt::format("{}{}", then, model.linear_solver);
  if (model.precision) name += fmt::format("{}{}", then, name_of(*model.precision));
  return name;
}

Model model_in(const std::string& name) {
  std::string variants = name;
  std::string cells = taken_until(variants, then);
  std::string element = taken_until(cells, on);
  Model model{.method = taken_until(element, ":"), .element = element};
  for (const CellType type : all_cell_types)
    if (plural_of(type) == cells) model.cells = type;
  if (const auto* precision = find_value<dynamics::Precision>(variants))
    model.precision = precision->value;
  else
    model.linear_solver = variants;
  return model;
}

}  // namespace springcheck
