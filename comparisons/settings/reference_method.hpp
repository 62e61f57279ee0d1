#pragma once

#include <string>
#include <vector>

#include "comparisons/cases/request.hpp"
#include "comparisons/settings/given.hpp"

namespace springcheck {

/// A method with the element and the grid it runs on, as the user names it:
///
///     METHOD[:ELEMENT]              the element is q1-sri when none is named; the
///                                   case's own mesh
///     METHOD[:ELEMENT]@NX,NY,NZ     this many cells: whole multiples of the case's
///     METHOD[:ELEMENT]@N            N along x, the others in proportion
///     METHOD[:ELEMENT]@converged    extrapolated, see converged.hpp
struct ReferenceMethod {
  Method method;
  ElementName element;
  std::vector<int> cells{};  // none, N, or three
  ReferenceGrid grid = ReferenceGrid::one;
  std::string place{}, text{};  // where and how it was given, for messages
};

/// Reads a reference; whether its cells fit the case's is seen in requests().
ReferenceMethod reference_named(const Given& given);

}  // namespace springcheck
