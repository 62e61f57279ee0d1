#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/cases/request.hpp"
#include "comparisons/settings/given.hpp"

namespace springcheck {

/// A method with what it runs by, an element or a solver, and on, as the user names it:
///
///     METHOD[:ELEMENT]       the element is q1-sri when none is named; the case's mesh
///     METHOD[:SOLVER]        of methods without elements: the case's solver when none is
///                            named
///     ...@NX,NY,NZ           this many cells: whole multiples of the case's
///     ...@N                  N along x, the others in proportion
///     ...@converged          extrapolated, see converged.hpp
struct ReferenceMethod {
  Method method;
  ElementName element;
  std::optional<Solver> solver{};
  std::vector<int> cells{};  // none, N, or three
  ReferenceGrid grid = ReferenceGrid::one;
  std::string place{}, text{};  // where and how it was given, for messages
};

/// The case of that method, on the case's own mesh.
CaseSettings with_reference_method(CaseSettings settings,
                                   const ReferenceMethod& reference);

/// Reads a reference; whether its cells fit the case's is seen in requests().
ReferenceMethod reference_named(const Given& given);

}  // namespace springcheck
