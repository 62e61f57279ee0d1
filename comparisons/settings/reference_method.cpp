#include "comparisons/settings/reference_method.hpp"

#include <charconv>
#include <sstream>

#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/setting_values.hpp"

namespace springcheck {
namespace {

/// "N" or "NX,NY,NZ" behind a reference's '@'.
std::vector<int> reference_cells_of(const Given& given, const std::string& text) {
  const std::string expected =
      "METHOD[:ELEMENT] and behind it @NX,NY,NZ, @N or @converged, counts of at least 1";
  std::vector<int> cells;
  std::istringstream counts(text);
  for (std::string count; std::getline(counts, count, ',');) {
    int value = 0;
    const auto [end, error] =
        std::from_chars(count.data(), count.data() + count.size(), value);
    if (error != std::errc{} || end != count.data() + count.size() || value < 1)
      given.refuse(expected);
    cells.push_back(value);
  }
  if ((cells.size() != 1 && cells.size() != 3) || text.back() == ',')
    given.refuse(expected);
  return cells;
}

}  // namespace

ReferenceMethod reference_named(const Given& given) {
  const std::string text = given.joined();
  const std::size_t at = text.find('@');
  const std::string what = text.substr(0, at);
  const std::size_t colon = what.find(':');
  ReferenceMethod reference{.method = value_named<Method>(given, what.substr(0, colon)),
                            .element = *find_element("q1-sri"),
                            .place = given.place(),
                            .text = text};
  if (colon != std::string::npos) {
    if (!reads(reference.method, "element"))
      given.refuse("an element for " + names_of(laws()) + " only");
    reference.element = value_named<ElementName>(given, what.substr(colon + 1));
  }
  if (at == std::string::npos) return reference;
  if (reference.method.belongs_to_cells)
    given.refuse(reference.method.name +
                 " on the case's own mesh: its constants belong to those cells");
  const std::string grid = text.substr(at + 1);
  if (grid == "converged")
    reference.grid = ReferenceGrid::converged;
  else
    reference.cells = reference_cells_of(given, grid);
  return reference;
}

}  // namespace springcheck
