#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/stability/axis.hpp"
#include "comparisons/stability/case_runner.hpp"
#include "comparisons/stability/failure.hpp"

namespace springcheck {

/// What an atlas is of: a scene over one or two settings, for some methods.
struct AtlasPlan {
  std::string scene;
  GivenSettings options;        // that replace the scene's
  std::vector<Axis> axes{};     // one or two; limits are along the first
  bool judges_locking = false;  // of points, by a control for each
};

struct AtlasPoint {
  std::string method;               // its label
  std::vector<std::string> values;  // of the axes
  CaseResult result{};
  Failure failure;
  std::optional<std::string> control{};  // key of that by which locking was judged
};

/// The place along the first axis, in the order of its values from the first on, where a
/// method begins to fail.
struct AtlasLimit {
  std::string method;
  std::optional<std::string> other;  // value of the second axis
  // It holds at `low` and fails at `high`, which are within 1 % where that was bisected,
  // and within .2 % on paths. No low: it fails at the first value; no high: it holds at
  // the last, or what failed tells nothing of the body (solver failure, not covered).
  std::optional<double> low{}, high{};
  Failure failure;  // at `high`
  std::string reason{};
  std::optional<double> wavelength{};  // of the mode that is lost, in edges between nodes
  std::vector<std::string> cases{};    // keys: that which fails first
};

struct Atlas {
  std::vector<AtlasPoint> points;
  std::vector<AtlasLimit> limits;  // none where the first axis is no range
};

/// Runs every method at every combination of the axes' values, and finds the limits along
/// the first: that of the deformation of bodies at rest by solver limit, others by
/// bisection of cases. Locking is judged against the same law on q1-sri; for springs on
/// hexahedra against fem-cauchy-born of their lattice; for others it is not judged. The
/// runner keeps the map, at first without its limits. Throws InputError.
Atlas make_atlas(const AtlasPlan& plan, CaseRunner& runner);

}  // namespace springcheck
