#pragma once

#include <string>

#include "comparisons/cases/case.hpp"
#include "tissue/maxwell_fit.hpp"

namespace springcheck {

/// Runs a case of tissue: branches fitted to its law
/// (fit_maxwell_model, its range by default), the bulk ratio of its Poisson ratio
/// (bulk_ratio_of); or of the thesis's springs, which have no branches. Where strains or
/// their rates leave the range of the fit, the solution's reason says that it is an
/// extrapolation. Threads: of steps through time.
Solution solve_tissue(const CaseSettings& settings, const Mesh& mesh, const Scene& scene,
                      const dynamics::Protocol& protocol, int threads,
                      const dynamics::Observers& observers);

/// What of a load that shears the body by `largest_strain` at most is outside the range;
/// empty where nothing is. Rates are means over the ways between the load's turning
/// points, in proportion to it and to a tenth, and count where strains are within the
/// range's: smaller ones are linear, and have the range of angular frequencies.
std::string extrapolation(const tissue::FitRange& range, const Dynamics& dynamics,
                          double largest_strain);

}  // namespace springcheck
