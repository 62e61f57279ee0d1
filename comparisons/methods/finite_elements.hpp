#pragma once

#include <vector>

#include "comparisons/cases/method.hpp"
#include "fem_reference/laws/settings.hpp"

namespace springcheck {

/// Elements and laws of the static solver.
std::vector<ElementName> finite_elements();
std::vector<Method> finite_element_methods();

/// The lattice whose continuum a case of fem-cauchy-born is.
fem_reference::Lattice lattice_of(const CaseSettings& settings);

}  // namespace springcheck
