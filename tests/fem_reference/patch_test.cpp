#define BOOST_TEST_MODULE fem_reference_patch
#include <boost/test/unit_test.hpp>

#include "bodies.hpp"
#include "fem_reference/solve.hpp"
#include "laws.hpp"

// The patch test: an affine displacement of the whole boundary is the solution, for every
// law and element, on cells of any shape.

using namespace springcheck;
using namespace springcheck::fem_reference;

// Warped boundary and interior. Newton ends at 1e-10 of the reactions, its last step
// being quadratic at round-off.
BOOST_AUTO_TEST_CASE(affine_fields_are_reproduced_on_distorted_hexahedra) {
  const Mesh mesh = distorted_cube(3, 0.2, Moved::all_nodes);
  Matrix3 H;
  H << 0.05, -0.03, 0.02, 0.04, -0.06, 0.01, -0.02, 0.05, 0.03;
  for (const double nu : {0.3, 0.499})
    for (const Law law : laws)
      for (const Element element : elements)
        BOOST_TEST_CONTEXT(words(law) << ' ' << words(element) << ", nu " << nu) {
          const Settings settings{.law = law, .element = element};
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
                     (element == Element::q2 ? mesh.cells().size() : 0));
          for (std::size_t c = 0; c < solution.cell_volumes.size(); ++c)
            BOOST_TEST(solution.cell_volumes[c] == J * mesh.cell_volumes()[c],
                       boost::test_tools::tolerance(1e-12));
        }
}

// And so for every lattice's continuum, with the element that mirrors the springs.
BOOST_AUTO_TEST_CASE(affine_fields_are_reproduced_by_every_lattice) {
  const Mesh mesh = distorted_cube(2, 0.2, Moved::interior_nodes);
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
