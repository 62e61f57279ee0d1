#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "comparisons/cases/method.hpp"

namespace springcheck {

/// Every method that the program has, in the order in which lists tell them; elements of
/// finite elements; lattices that fem-cauchy-born is the continuum of.
const std::vector<Method>& methods();
const std::vector<ElementName>& elements();
const std::vector<LatticeName>& lattices();

/// The entry of that name in the lists above; nullptr when there is none.
const Method* find_method(std::string_view name);
const ElementName* find_element(std::string_view name);
const LatticeName* find_lattice(std::string_view name);

/// "a, b, c" of the entries' names, for messages and help.
template <class Entries>
std::string names_of(const Entries& entries) {
  std::string names;
  for (const auto& entry : entries)
    names += (names.empty() ? "" : ", ") + std::string(entry.name);
  return names;
}

}  // namespace springcheck
