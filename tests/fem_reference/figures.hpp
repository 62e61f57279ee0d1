#pragma once

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "fem_reference/solve.hpp"
#include "meshing/cell_geometry.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tests/fem_reference/bodies.hpp"

// What the stored figures measure: a body glued between two plates.
namespace springcheck::fem_reference {

inline constexpr double degree = std::numbers::pi / 180;

/// What is measured on a body between two plates.
struct Measured {
  double volume_change;  // (V - V0)/V0
  Vector3 force;         // of the upper plate on the body [N]
  double torque;         // of the same about the axis [N m]
};

inline double deformed_volume(const Mesh& mesh, const Solution& solution) {
  std::vector<Vector3> positions = mesh.nodes();
  for (std::size_t node = 0; node < positions.size(); ++node)
    positions[node] += solution.displacements[node];
  double volume = 0;
  for (const double v : solution.cell_volumes.empty()
                            ? cell_volumes(mesh.cells(), positions)
                            : solution.cell_volumes)
    volume += v;
  return volume;
}

inline Measured measured(const Block& block, double nu, const Settings& settings,
                         const Vector3& strain, double angle,
                         const statics::Search& search = {}) {
  const double height = block.size[2];
  const Vector3 centre(block.size[0] / 2, block.size[1] / 2, height);
  const Mesh mesh = generate_block(block);
  const Solution solution =
      solve(mesh,
            {.material = {.young_modulus = 1e4, .poisson_ratio = nu, .density = 1000},
             .plates = {fixed("bottom"), plate("top", {.translation = strain * height,
                                                       .axis = Vector3::UnitZ(),
                                                       .centre = centre,
                                                       .angle = angle})},
             .gravity = Vector3::Zero()},
            settings, search);
  BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok), solution.reason);
  Measured sum{.volume_change = deformed_volume(mesh, solution) / mesh.volume() - 1,
               .force = Vector3::Zero(),
               .torque = 0};
  for (const NodeIndex node : mesh.region("top").nodes) {
    Vector3 place = mesh.nodes()[node];
    if (solution.lever_arms == LeverArms::deformed) place += solution.displacements[node];
    sum.force += solution.reactions[node];
    sum.torque += (place - centre).cross(solution.reactions[node]).z();
  }
  return sum;
}

inline Block cube_of(int cells) {
  return {.size = {edge, edge, edge}, .cells = {cells, cells, cells}};
}

inline void check(double value, double figure, double band) {
  BOOST_TEST(std::abs(value - figure) <= band,
             "measured " << value << ", figure " << figure << ", band " << band);
}

}  // namespace springcheck::fem_reference
