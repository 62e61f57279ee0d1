#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fem_reference/explicit/explicit_element.hpp"
#include "fem_reference/solve.hpp"
#include "mss/networks/network.hpp"

namespace springcheck {

/// In a model's place: nodal displacements that another program computed, and forces
/// where it told them, by the SHA-256 of their numbers.
struct Measured {
  std::string displacements;
  std::string forces;  // empty without
};

/// Models of living tissue, whose law has no Young's modulus.
enum class TissueModel {
  springs,
  elements,
  thesis_springs,          // Golec 2018, Eq. 4.4, as printed
  thesis_springs_relative  // the same with elongations over the rest length
};

/// A method by its name on the command line: springs, a law for finite elements, or an
/// element that steps explicitly; or by the user's name for what is measured.
struct Method {
  std::string name;
  std::variant<mss::Method, fem_reference::Law, fem_reference::ExplicitElement, Measured,
               TissueModel>
      model;
  std::string_view description;
};

struct ElementName {
  std::string_view name;
  fem_reference::Element element;
  std::string_view description;
};

/// Springs whose continuum fem-cauchy-born is, by the name of their method.
struct LatticeName {
  std::string_view name;
  fem_reference::Springs springs;
};

const std::vector<Method>& methods();
const std::vector<ElementName>& elements();
const std::vector<LatticeName>& lattices();

/// The entry of that name in the lists above; nullptr when there is none.
const Method* find_method(std::string_view name);
const ElementName* find_element(std::string_view name);
const LatticeName* find_lattice(std::string_view name);

inline bool is_springs(const Method& method) {
  return std::holds_alternative<mss::Method>(method.model);
}

/// Whether it is a law for the static solver's finite elements, which have options of
/// their own.
inline bool is_finite_element(const Method& method) {
  return std::holds_alternative<fem_reference::Law>(method.model);
}

inline bool is_explicit_element(const Method& method) {
  return std::holds_alternative<fem_reference::ExplicitElement>(method.model);
}

inline bool is_measured(const Method& method) {
  return std::holds_alternative<Measured>(method.model);
}

inline bool is_tissue(const Method& method) {
  return std::holds_alternative<TissueModel>(method.model);
}

/// Tissue that has no memory, whatever its time.
inline bool is_thesis_tissue(const Method& method) {
  const auto* model = std::get_if<TissueModel>(&method.model);
  return model != nullptr && (*model == TissueModel::thesis_springs ||
                              *model == TissueModel::thesis_springs_relative);
}

/// Whether its springs have the constants that the user gives.
inline bool is_custom(const Method& method) {
  const auto* springs = std::get_if<mss::Method>(&method.model);
  return springs != nullptr && *springs == mss::Method::custom;
}

/// "a, b, c" of the entries' names, for messages and help.
template <class Entries>
std::string names_of(const Entries& entries) {
  std::string names;
  for (const auto& entry : entries)
    names += (names.empty() ? "" : ", ") + std::string(entry.name);
  return names;
}

}  // namespace springcheck
