#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "fem_reference/solve.hpp"
#include "fem_reference/statics/elements_body.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"

// The patch test: an affine displacement of the whole boundary is the solution, for every
// law and element, on cells of any shape.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(patch_test)

namespace {

Matrix3 random_gradient(double size, unsigned seed) {
  RandomVectors random(size, seed);
  const Vector3 x = random(), y = random(), z = random();
  return (Matrix3() << x, y, z).finished();
}

void for_all_elements(CellPattern pattern,
                      const std::function<void(double nu, const Settings&)>& test) {
  for (const double nu : {0., 0.25, 0.45, 0.499})
    for (const Law law : laws)
      for (const Element element : elements_on(pattern))
        BOOST_TEST_CONTEXT(words(pattern) << ", " << words(law) << ' ' << words(element)
                                          << ", nu " << nu)
  test(nu, {.law = law, .element = element});
}

}  // namespace

// The forces on inner nodes cancel to the rounding of the cells' parts, which are of the
// size of the reactions; pyramids have points and weights of 14 digits.
BOOST_AUTO_TEST_CASE(affine_states_are_in_equilibrium_on_cells_of_every_type) {
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = renumbered(warped_cube(3, pattern));
    const std::vector<NodeIndex>& outer = mesh.boundary().nodes;
    for_all_elements(pattern, [&](double nu, const Settings& settings) {
      const Discretisation body = discretise(mesh, settings.element);
      ElementsBody elements(body,
                            {.constitution = constitution(of_poisson_ratio(nu), settings),
                             .dilatation = dilatation_taken(settings)});
      const Matrix3 H = random_gradient(0.1, 23);
      const Eigen::VectorXd forces =
          elements.state(nodal(body, [&](const Vector3& X) -> Vector3 { return H * X; }))
              .forces;
      double inside = 0;
      for (std::size_t n = 0; n < mesh.nodes().size(); ++n)
        if (!std::ranges::binary_search(outer, n))
          inside = std::max(inside,
                            forces.segment<3>(static_cast<Eigen::Index>(3 * n)).norm());
      BOOST_TEST(inside < 1e-12 * largest(forces));
    });
  }
}

// Newton ends at 1e-10 of the reactions, its last step being quadratic at round-off.
BOOST_AUTO_TEST_CASE(affine_fields_are_reproduced_on_cells_of_every_type) {
  const Matrix3 H = random_gradient(0.06, 29);
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = warped_cube(3, pattern);
    for_all_elements(pattern, [&](double nu, const Settings& settings) {
      const Constitution psi = constitution(of_poisson_ratio(nu), settings);
      const Solution solution = solve(mesh,
                                      {.material = of_poisson_ratio(nu),
                                       .plates = {},
                                       .boundary_gradient = H,
                                       .gravity = Vector3::Zero()},
                                      settings);
      BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok), solution.reason);
      Matrix3 virial = Matrix3::Zero();  // sum r_a (x) X_a = V P
      double furthest = 0;
      for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
        const Vector3& X = mesh.nodes()[n];
        virial += solution.reactions[n] * X.transpose();
        furthest = std::max(furthest, (solution.displacements[n] - H * X).norm());
      }
      BOOST_TEST(furthest < 1e-12 * edge);
      BOOST_TEST(solution.strain_energy == mesh.volume() * energy(psi, H),
                 boost::test_tools::tolerance(1e-11));
      BOOST_TEST(largest(virial - mesh.volume() * stress(psi, H)) <
                 1e-11 * mesh.volume() * largest(stress(psi, H)));
      BOOST_TEST(total(solution.reactions).norm() <
                 1e-12 * largest(stress(psi, H)) * edge * edge);
      const double J = (Matrix3::Identity() + H).determinant();
      BOOST_TEST(solution.cell_volumes.size() ==
                 (settings.element == Element::q2 ? mesh.cells().size() : 0));
      for (std::size_t c = 0; c < solution.cell_volumes.size(); ++c)
        BOOST_TEST(solution.cell_volumes[c] == J * mesh.cell_volumes()[c],
                   boost::test_tools::tolerance(1e-12));
    });
  }
}

// Every lattice's continuum reproduces them too, with the element that mirrors the
// springs.
BOOST_AUTO_TEST_CASE(affine_fields_are_reproduced_by_every_lattice) {
  const Mesh mesh = warped_cube(2, CellPattern::mixed);
  const Matrix3 H = 0.2 * general_gradient();
  for (NamedLaw& law : laws_at(0.4)) {
    law.settings.element = Element::q1_sri;
    const Solution solution = solve(mesh,
                                    {.material = law.material,
                                     .plates = {},
                                     .boundary_gradient = H,
                                     .gravity = Vector3::Zero()},
                                    law.settings);
    BOOST_TEST_CONTEXT(law.name) {
      BOOST_TEST((solution.status == SolveStatus::ok), solution.reason);
      for (std::size_t n = 0; n < mesh.nodes().size(); ++n)
        BOOST_TEST((solution.displacements[n] - H * mesh.nodes()[n]).norm() <
                   1e-12 * edge);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
