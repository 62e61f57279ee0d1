#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/cases/case.hpp"

namespace springcheck {

/// Whether a reference is one simulation, or what it converges to on three grids.
enum class ReferenceGrid { one, converged };

/// A simulation that was asked for, with what its deviations are measured against.
struct Request {
  CaseSettings settings;
  // The case that deviations are measured against, on the same mesh or a refinement of
  // it; on the same mesh when `converged`:
  std::optional<CaseSettings> reference{};
  ReferenceGrid reference_grid = ReferenceGrid::one;
  std::string no_reference{};  // why there is none, where one was wanted
};

/// The simulations that a request's reference is made of: none, one, or three from coarse
/// to fine.
std::vector<CaseSettings> reference_cases(const Request& request);

/// The reference in short: "fem-stvk:q1-sri"; "mss-cf:static" for a method with several
/// solvers, where it is not by its own or the case is by another; with "@20,20,20" on
/// cells other than the case's, "@converged" when extrapolated. Empty without a
/// reference.
std::string reference_label(const Request& request);

}  // namespace springcheck
