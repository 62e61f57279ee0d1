#include <boost/test/unit_test.hpp>
#include <random>

#include "fem_reference/cells/discretisation.hpp"
#include "fem_reference/tissue/solve_tissue.hpp"
#include "fem_reference/tissue/tissue_cell.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tissue/maxwell_fit.hpp"

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(tissue_test)

namespace {

constexpr double h = 0.005;  // [m]

tissue::Solid solid_of(const std::string& organ, double nu) {
  return {.shear = tissue::fit_maxwell_model(tissue::law_of_organ(organ)).model,
          .bulk_ratio = tissue::bulk_ratio_of(nu)};
}

Mesh cube(int n, CellPattern pattern = CellPattern::hexahedron) {
  return generate_block(
      {.size = {n * h, n * h, n * h}, .cells = {n, n, n}, .pattern = pattern});
}

Scene in_simple_shear(double strain) {
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
  gradient(0, 2) = strain;
  return {.material = {.young_modulus = 1, .poisson_ratio = 0.499, .density = 1000},
          .plates = {},
          .boundary_gradient = gradient,
          .gravity = Vector3::Zero()};
}

double mean_shear_stress(const Mesh& mesh, const std::vector<Vector3>& reactions) {
  double sum = 0;
  for (std::size_t n = 0; n < reactions.size(); ++n)
    sum += reactions[n].x() * mesh.nodes()[n].z();
  return sum / mesh.volume();
}

/// A single cell that has been deformed once, to be deformed further.
struct DeformedCell {
  Discretisation body;
  tissue::Solid solid;
  tissue::MemoryStep step;
  std::vector<double> states;
  CellVectors u;

  explicit DeformedCell(CellPattern pattern)
      : body(discretise(cube(1, pattern), Element::q1_sri)),
        solid(solid_of("kidney", 0.45)),
        step(tissue::memory_step(solid, 0.3)) {
    const Shape& shape = *body.cells[0].shape;
    states.resize(static_cast<std::size_t>(shape.weights.size()) *
                  tissue::state_size(solid.shear.branches.size()));
    tissue::set_to_rest(states);
    u = random(1);
    advance(solid, step, shape, states, u);
    u += random(2);
  }

  [[nodiscard]] CellVectors random(unsigned seed) const {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> anywhere(-0.1 * h, 0.1 * h);
    CellVectors by(3, static_cast<Eigen::Index>(body.cells[0].nodes.size()));
    for (double& x : by.reshaped()) x = anywhere(generator);
    return by;
  }

  [[nodiscard]] TissueCell cell() const {
    return {
        .solid = solid, .step = step, .shape = *body.cells[0].shape, .states = states};
  }
};

}  // namespace

// The derivative is by central differences of 1e-6 cell edges: of second order, and with
// a round-off of 1e-10.
BOOST_AUTO_TEST_CASE(the_tangent_is_the_forces_derivative) {
  for (const CellPattern pattern : {CellPattern::hexahedron, CellPattern::tetrahedron}) {
    const DeformedCell at(pattern);
    const CellMatrix K = tangent_after(at.cell(), at.u);
    const double step = 1e-6 * h;
    double largest = 0;
    for (Eigen::Index i = 0; i < at.u.size(); ++i) {
      CellVectors more = at.u, less = at.u;
      more.reshaped()[i] += step;
      less.reshaped()[i] -= step;
      const CellVectors difference =
          (forces_after(at.cell(), more).forces - forces_after(at.cell(), less).forces) /
          (2 * step);
      largest =
          std::max(largest, (K.col(i) - difference.reshaped()).norm() / K.col(i).norm());
    }
    BOOST_TEST(largest < 1e-6);
  }
}

// Without branches and dashpot, whose memories would follow, forces are those of the free
// energy.
BOOST_AUTO_TEST_CASE(elastic_forces_are_the_energys_derivative) {
  DeformedCell at(CellPattern::hexahedron);
  at.solid.shear.branches.clear();
  at.solid.shear.viscosity = 0;
  at.states.resize(8 * tissue::state_size(0));
  tissue::set_to_rest(at.states);
  at.step = tissue::memory_step(at.solid, 1);
  const Shape& shape = *at.body.cells[0].shape;
  const CellVectors forces = forces_after(at.cell(), at.u).forces;
  const double step = 1e-5 * h;
  for (Eigen::Index i = 0; i < at.u.size(); ++i) {
    CellVectors more = at.u, less = at.u;
    more.reshaped()[i] += step;
    less.reshaped()[i] -= step;
    const double slope = (free_energy(at.solid, shape, at.states, more) -
                          free_energy(at.solid, shape, at.states, less)) /
                         (2 * step);
    BOOST_TEST(std::abs(forces.reshaped()[i] - slope) < 1e-6 * forces.norm());
  }
}

// The bodies are pressed by 20 %, as springs are in mss/tissue.
BOOST_AUTO_TEST_CASE(a_column_is_not_stable_as_far_as_a_short_block) {
  const auto pressed = [](int height) {
    const Mesh mesh =
        generate_block({.size = {h, h, height * h}, .cells = {1, 1, height}});
    const auto plate = [&](const std::string& region, double way) {
      return Plate{region,
                   {.translation = {0, 0, way},
                    .axis = Vector3::UnitZ(),
                    .centre = Vector3::Zero(),
                    .angle = 0},
                   all_components};
    };
    const Scene scene{
        .material = {.young_modulus = 1, .poisson_ratio = 0.49, .density = 1000},
        .plates = {plate("bottom", 0), plate("top", -0.2 * height * h)},
        .gravity = Vector3::Zero()};
    return solve_tissue(mesh, scene, solid_of("liver", 0.49),
                        {.load = dynamics::ramp(1.5), .steps = 20});
  };
  const Solution column = pressed(10), block = pressed(2);
  BOOST_TEST((column.status == SolveStatus::ok), column.reason);
  BOOST_TEST(column.definite_up_to.value_or(1) < 0.5);
  BOOST_TEST(!block.definite_up_to);
}

// The body is homogeneous: the closed form of the branches holds, to second order in the
// step.
BOOST_AUTO_TEST_CASE(bodies_in_simple_shear_have_the_branches_stress) {
  const tissue::Solid solid = solid_of("spleen", 0.499);
  for (const CellPattern pattern : {CellPattern::hexahedron, CellPattern::tetrahedron})
    for (const double rate : {0.0151, 0.67}) {
      const Mesh mesh = cube(2, pattern);
      const Solution solution =
          solve_tissue(mesh, in_simple_shear(1), solid,
                       {.load = dynamics::ramp(1 / rate), .steps = 100});
      BOOST_TEST((solution.status == SolveStatus::ok), solution.reason);
      BOOST_TEST(mean_shear_stress(mesh, solution.reactions) ==
                     tissue::constant_rate_stress(solid.shear, 1, rate),
                 boost::test_tools::tolerance(5e-4));
      BOOST_TEST(solution.largest_shear_strain.value() == 1,
                 boost::test_tools::tolerance(1e-9));
    }
}

BOOST_AUTO_TEST_SUITE_END()
