#pragma once

#include <string>
#include <string_view>
#include <type_traits>
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

/// The methods of a family that have a place in it, in that order (Method::foremost).
std::vector<const Method*> foremost(Family family);

/// The method that a method is at rest; itself where it is not another's motion.
const Method& at_rest(const Method& method);

/// Finite elements that charts step through time on such cells: those that have a place,
/// then the others.
std::vector<Model> moving_elements(CellType cells, dynamics::Precision precision);

/// The finite elements of a law at rest, to which bodies converge by finer cells; and
/// whether one of them has that name.
std::vector<const Method*> laws();
bool is_law(std::string_view name);

/// The law that deviations are measured from where a case names none: Hooke's up to small
/// deformations, St-Venant-Kirchhoff's beyond.
const Method& usual_law(bool is_small);

/// Deformations up to which Hooke's law is the usual one.
inline constexpr double small_deformation = 0.02;

/// A caution, as a sentence: that the law lets volume change where the material hardly
/// does, from nu = .45 on and beyond small deformations; empty elsewhere, and where
/// another law is no better.
std::string caution_near_half(const Method& law, const CaseSettings& settings);

/// The law that the thesis compares springs with, as errors that are split do.
const Method& thesis_law();

/// Finite elements of the law that a method's springs follow; `otherwise` of a method
/// that is not known to follow any.
const Method& followed_law(const Method& method, const Method& otherwise);

/// Finite elements of the law that a case's springs follow, where a setting may make a
/// method's springs those of another one; `otherwise` where none is known.
const Method& followed_law(const CaseSettings& settings, const Method& otherwise);

/// The continuum of a lattice of springs, by the Cauchy-Born rule.
const Method& continuum_of_lattices();

/// The entries' names as "a, b, c", for messages and help.
template <class Entries>
std::string names_of(const Entries& entries) {
  std::string names;
  for (const auto& entry : entries) {
    if (!names.empty()) names += ", ";
    if constexpr (std::is_pointer_v<typename Entries::value_type>)
      names += entry->name;
    else
      names += entry.name;
  }
  return names;
}

}  // namespace springcheck
