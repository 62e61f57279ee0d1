#pragma once

#include <string>
#include <vector>

#include "comparisons/cases/case.hpp"
#include "comparisons/cases/method.hpp"
#include "fem_reference/laws/settings.hpp"
#include "tissue/maxwell_fit.hpp"

namespace springcheck {

/// Elastic springs; constants, networks and what they cover: mss/networks.
std::vector<Method> spring_methods();

/// Living tissue: branches fitted to the case's law (fit_maxwell_model, its range by
/// default), the bulk ratio of its Poisson ratio (bulk_ratio_of); and the thesis's
/// springs, which have no branches. Where strains or their rates leave the range of the
/// fit, the solution's extrapolation says so.
std::vector<Method> tissue_methods();

/// What of a load that shears the body by `largest_strain` at most is outside the range;
/// empty where nothing is. Rates are means over the ways between the load's turning
/// points, in proportion to it and to a tenth, and count where strains are within the
/// range's. Smaller ones are linear: they have the range of angular frequencies, and
/// where nothing swings a way may take no less than the inverse of the largest. A way on
/// which the load stays is a hold, of the range's times.
std::string extrapolation(const tissue::FitRange& range, const Dynamics& dynamics,
                          double largest_strain);

/// Elements and laws of the static solver.
std::vector<ElementName> finite_elements();
std::vector<Method> finite_element_methods();

/// Law and element of a case of finite elements.
fem_reference::Settings elements_of(const CaseSettings& settings, fem_reference::Law law);

/// The lattice whose continuum a case of fem-cauchy-born is.
fem_reference::Lattice lattice_of(const CaseSettings& settings);

/// Finite elements that step explicitly.
std::vector<Method> explicit_element_methods();

}  // namespace springcheck
