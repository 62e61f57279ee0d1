#include "mss/statics/path_limit_solution.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "meshing/cell_geometry.hpp"
#include "meshing/turn.hpp"
#include "meshing/wavelength.hpp"
#include "mss/statics/path_limit.hpp"
#include "mss/statics/static_solution.hpp"

namespace springcheck::mss {
namespace {

constexpr double resolution = 0.002;  // of the load reached

SolveStatus status_of(PathEnd end) {
  switch (end) {
    case PathEnd::full_load:
      return SolveStatus::ok;
    case PathEnd::bifurcation:
      return SolveStatus::indefinite;
    case PathEnd::limit_point:
      return SolveStatus::no_equilibrium;
    case PathEnd::rejected:
      return SolveStatus::inverted;
    case PathEnd::solver:
      break;
  }
  return SolveStatus::not_converged;
}

std::string reason_of(const PathLimit& limit, double wavelength) {
  const std::string where =
      fmt::format("between {:.4g} % and {:.4g} % of the load", 100 * limit.load_fraction,
                  100 * limit.next_load_fraction);
  switch (limit.end) {
    case PathEnd::full_load:
      return {};
    case PathEnd::bifurcation:
      return fmt::format(
          "the tangent loses positive definiteness {}, by a mode {:.3g} cells long: {}",
          where, wavelength, wavelength < 4 ? "it wrinkles" : "it buckles");
    case PathEnd::limit_point:
      return fmt::format("the path turns back {}: no equilibrium nearby beyond", where);
    case PathEnd::rejected:
      return fmt::format("a cell is turned inside out {}", where);
    case PathEnd::solver:
      break;
  }
  return fmt::format(
      "Newton's method fails {}, where the least curvature is still {:.2g} of what the "
      "same mode has at rest",
      where, limit.curvature / limit.mode_rest_curvature);
}

}  // namespace

Solution path_limit_solution(const Mesh& mesh, const Scene& scene,
                             const Network& network) {
  bool lost_turn = false;  // what was tried last
  const auto is_whole = [&](std::span<const Vector3> x, double load_fraction) {
    lost_turn = !shows_imposed_turn(mesh, scene, x, load_fraction);
    return !lost_turn && !has_inverted_cell(mesh.cells(), x);
  };
  const PathLimit limit = follow_to_limit(mesh, scene, network, resolution, is_whole);
  Solution solution =
      static_solution(mesh, scene, network, limit.positions, limit.load_fraction);
  solution.status = status_of(limit.end);
  solution.steps = limit.steps;
  solution.force_evaluations = limit.force_evaluations;
  if (limit.end == PathEnd::full_load) return solution;
  solution.critical_wavelength = shortest_wavelength(mesh, limit.critical_mode);
  solution.reason = reason_of(limit, *solution.critical_wavelength);
  if (limit.end == PathEnd::rejected && lost_turn) {
    solution.status = SolveStatus::no_equilibrium;
    solution.reason = fmt::format(
        "beyond {:.4g} % of the load the body is not turned as its plates are",
        100 * limit.load_fraction);
  }
  if (limit.end != PathEnd::solver) solution.definite_up_to = limit.load_fraction;
  return solution;
}

}  // namespace springcheck::mss
