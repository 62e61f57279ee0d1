#include "tests/comparisons/running/labelled_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <iostream>
#include <span>
#include <string_view>

#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/running/simulate.hpp"
#include "meshing/cell_geometry.hpp"
#include "meshing/wavelength.hpp"
#include "mss/statics/network_body.hpp"
#include "statics/path_limit.hpp"
#include "statics/systems/nodal_vectors.hpp"
#include "tests/comparisons/settings.hpp"

namespace springcheck {

namespace {

/// The case at a load of its scene: a deformation, or for the beam its modulus over that
/// of the scene.
CaseSettings loaded(const std::string& scene, std::vector<std::string> changes,
                    double load, double noise = 0) {
  changes.push_back(scene == "bending" ? fmt::format("young={:.12g}", 2e6 / load)
                                       : fmt::format("deformation={:.12g}", load));
  if (noise > 0) changes.push_back(fmt::format("noise={:g}", noise));
  return case_of(scene, changes);
}

State state_of(const std::string& name, bool is_wrinkled, const CaseSettings& settings,
               const Mesh& mesh, std::span<const Vector3> u) {
  const auto surface = measure_wrinkling(mesh, mechanical_scene(settings, mesh), u);
  BOOST_TEST_REQUIRE(surface.has_value(), name);
  State state{.scene = std::string(entry_of(settings.test).name),
              .method = settings.method.name,
              .name = name,
              .is_wrinkled = is_wrinkled,
              .surface = *surface,
              .inside = measure_hourglassing(mesh, u).value_or(Hourglassing{0, 0})};
  const bool is_called =
      springcheck::is_wrinkled(state.surface) || is_hourglassing(state.inside);
  BOOST_TEST((state.score() > 1) == is_called, name);
  return state;
}

struct Limit {
  statics::PathLimit path;
  std::vector<Vector3> displacements, critical_mode;  // at the limit
  double load;
  double wavelength;
  [[nodiscard]] bool is_critical() const {
    return path.end == statics::PathEnd::bifurcation &&
           path.curvature < 0.01 * path.rest_curvature;
  }
};

Limit limit_of(const Path& path) {
  const CaseSettings settings = loaded(path.scene, path.changes, path.far);
  const Mesh mesh = build_mesh(settings.body);
  const mss::Network network = settings.method.network(settings, mesh).value();
  const Eigen::VectorXd rest = statics::stacked(mesh.nodes());
  const auto is_upright = [&](const Eigen::VectorXd& u, double) {
    const std::vector<Vector3> x = statics::by_node(rest + u);
    return std::ranges::all_of(mesh.cells(), [&](const CellNodes& cell) {
      return smallest_corner_jacobian(corners(cell, x)) > 0;
    });
  };
  // A mode's curvature may fall from nine tenths of that at rest within .5 % of load.
  mss::NetworkBody body(network);
  const Scene scene = mechanical_scene(settings, mesh);
  const statics::Loading drive = mss::loading(mesh, scene, network);
  statics::PotentialEnergy potential(body, drive, statics::LinearSolver::automatic);
  const statics::PathLimit found = statics::follow_to_limit(potential, 1e-4, is_upright);
  const auto mode = statics::by_node(found.critical_mode);
  return {.path = found,
          .displacements = statics::by_node(found.state.displacements),
          .critical_mode = mode,
          .load = found.load_fraction * path.far,
          .wavelength = shortest_wavelength(mesh.cells(), mesh.nodes(), mode)};
}

}  // namespace

void add_states(std::vector<State>& states, const Path& path) {
  const Limit limit = limit_of(path);
  const std::string name = fmt::format("{} {}", path.scene, fmt::join(path.changes, " "));
  const bool is_short = limit.wavelength < 3;
  for (const double part : {0.5, 0.9, 1.05, 1.25, 1.5}) {
    const bool is_beyond = part > 1;
    const auto leave_out = [&](std::string_view why) {
      std::cout << fmt::format("  {}, {} of its limit: {}\n", name, part, why);
    };
    if (is_beyond && !limit.is_critical()) {
      leave_out("no mode of zero curvature there");
      continue;
    }
    if (is_beyond && !is_short && limit.wavelength < 4) {
      leave_out(fmt::format("a mode of {:.2f} cells", limit.wavelength));
      continue;
    }
    const CaseSettings settings =
        loaded(path.scene, path.changes, part * limit.load, is_beyond ? 0.01 : 0);
    const Mesh mesh = build_mesh(settings.body);
    const CaseResult result = simulate(settings, mesh);
    if (!result.measures.volume_change || result.status == Status::inverted) {
      leave_out(name_of(result.status));
      continue;
    }
    states.push_back(state_of(
        fmt::format("{}, {} of its limit, mode {:.2f}", name, part, limit.wavelength),
        is_beyond && is_short, settings, mesh, result.solution.displacements));
  }
}

void add_states(std::vector<State>& states, const Smooth& smooth) {
  for (const double load : smooth.loads) {
    const CaseSettings settings = loaded(smooth.scene, smooth.changes, load);
    const Mesh mesh = build_mesh(settings.body);
    const CaseResult result = simulate(settings, mesh);
    const std::string name =
        fmt::format("{} {}, load {}", smooth.scene, fmt::join(smooth.changes, " "), load);
    BOOST_TEST_REQUIRE((result.measures.volume_change.has_value() &&
                        !result.measures.definite_up_to_deformation),
                       name << ": " << result.reason);
    if (result.status == Status::inverted) continue;
    states.push_back(
        state_of(name, false, settings, mesh, result.solution.displacements));
  }
}

std::optional<double> height_called(std::vector<State>& states, const Moded& moded) {
  const Limit limit = limit_of(moded.lattice);
  const std::string name = fmt::format("{} {}, mode {:.2f}", moded.lattice.scene,
                                       fmt::join(moded.changes, " "), limit.wavelength);
  BOOST_TEST_REQUIRE((limit.is_critical() && limit.wavelength < 3), name);
  const CaseSettings settings = loaded(moded.lattice.scene, moded.changes, limit.load);
  const Mesh mesh = build_mesh(settings.body);
  const CaseResult result = simulate(settings, mesh);
  BOOST_TEST_REQUIRE((result.status == Status::ok), name << ": " << result.reason);
  const std::vector<Vector3>& rest = result.solution.displacements;
  states.push_back(state_of(name + ", without", false, settings, mesh, rest));
  double largest = 0;
  for (const Vector3& v : limit.critical_mode) largest = std::max(largest, v.norm());
  const Block& block = settings.body.block;
  std::optional<double> called;
  for (double height = 0.64; height > 0.009; height /= 2) {
    std::vector<Vector3> u = rest;
    const double factor = height * block.size[0] / block.cells[0] / largest;
    for (std::size_t n = 0; n < u.size(); ++n) u[n] += factor * limit.critical_mode[n];
    if (state_of(name, true, settings, mesh, u).score() <= 1) break;
    called = height;
  }
  std::cout << fmt::format("  {:5} {}\n", called ? fmt::format("{:g}", *called) : "none",
                           name);
  return called;
}

}  // namespace springcheck
