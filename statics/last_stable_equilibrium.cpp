#include "statics/last_stable_equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "meshing/cell_geometry.hpp"
#include "meshing/wavelength.hpp"
#include "statics/path_limit.hpp"
#include "statics/systems/nodal_vectors.hpp"

namespace springcheck::statics {
namespace {

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
          "the tangent loses positive definiteness {}, by a mode {:.3g} edges long: {}",
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

Equilibrium last_stable_equilibrium(ElasticBody& body, const Loading& loading,
                                    const MeshCells& cells, LinearSolver linear_solver,
                                    const Stopwatch& setup) {
  bool lost_turn = false;  // what was tried last
  const Eigen::VectorXd rest = stacked(body.nodes());
  const auto is_whole = [&](const Eigen::VectorXd& u, double load_fraction) {
    lost_turn = !loading.follows_supports(u, load_fraction);
    return !lost_turn && !has_inverted_cell(cells.whole, by_node(rest + u));
  };
  PotentialEnergy potential(body, loading, linear_solver);
  const double setup_wall_s = setup.seconds();
  const PathLimit limit = follow_to_limit(potential, limit_resolution, is_whole);
  Equilibrium equilibrium{.status = status_of(limit.end),
                          .reason = "",
                          .displacements = limit.state.displacements,
                          .reactions = potential.reactions(limit.state),
                          .strain_energy = limit.state.strain_energy,
                          .load_fraction = limit.load_fraction,
                          .definite_up_to = std::nullopt,
                          .critical_wavelength = std::nullopt,
                          .steps = limit.steps,
                          .force_evaluations = potential.evaluations(),
                          .linear_iterations = potential.linear_iterations(),
                          .factorisations = potential.factorisations(),
                          .setup_wall_s = setup_wall_s};
  if (limit.end == PathEnd::full_load) return equilibrium;
  const double wavelength =
      shortest_wavelength(cells.finest, body.nodes(), by_node(limit.critical_mode));
  equilibrium.critical_wavelength = wavelength;
  equilibrium.reason = reason_of(limit, wavelength);
  if (limit.end == PathEnd::rejected && lost_turn) {
    equilibrium.status = SolveStatus::no_equilibrium;
    equilibrium.reason = fmt::format(
        "beyond {:.4g} % of the load the body is not turned as its plates are",
        100 * limit.load_fraction);
  }
  tell_truncated(equilibrium, potential.truncated());
  if (limit.end != PathEnd::solver) equilibrium.definite_up_to = limit.load_fraction;
  return equilibrium;
}

}  // namespace springcheck::statics
