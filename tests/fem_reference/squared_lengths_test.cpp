#include <boost/test/unit_test.hpp>

#include "fem_reference/solve.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"

// The continuum of a lattice in squared lengths is St-Venant-Kirchhoff's law: elements of
// the one are elements of the other, not only when converged.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(squared_lengths_test)

namespace {

constexpr double nus[] = {0, 0.25, 0.4, 0.499};

constexpr Lattice lattices[] = {{.springs = Springs::cf, .strain = SpringStrain::green},
                                {.springs = Springs::affine,
                                 .direction = LatticeDirection::d111,
                                 .strain = SpringStrain::green}};

CellLaw cell_law(double nu, const Settings& settings) {
  return {.constitution = constitution(of_poisson_ratio(nu), settings),
          .dilatation = dilatation_taken(settings)};
}

Settings of_law(Element element) {
  return {.law = Law::st_venant_kirchhoff, .element = element};
}

Settings of_lattice(Element element, const Lattice& lattice) {
  return {.law = Law::cauchy_born, .element = element, .lattice = lattice};
}

}  // namespace

// Every node moved by up to a fifth of the edge. Round-off.
BOOST_AUTO_TEST_CASE(cells_have_the_same_energy_forces_and_tangent) {
  for (const CellPattern pattern : {CellPattern::hexahedron, CellPattern::tetrahedron})
    for (const Element element : elements_on(pattern)) {
      const Discretisation body = discretise(cube(1, pattern), element);
      const Eigen::VectorXd u = random_nodal(body, 0.2 * edge);
      for (const double nu : nus)
        for (const Lattice& lattice : lattices)
          for (const Cell& cell : body.cells) {
            const CellLaw law = cell_law(nu, of_law(element)),
                          own = cell_law(nu, of_lattice(element, lattice));
            const CellVectors at = of_cell(u, cell);
            const CellState by_law = cell_state(law, *cell.shape, at),
                            by_lattice = cell_state(own, *cell.shape, at);
            BOOST_TEST(by_lattice.energy == by_law.energy,
                       boost::test_tools::tolerance(1e-12));
            BOOST_TEST((by_lattice.forces - by_law.forces).norm() <
                       1e-12 * by_law.forces.norm());
            const CellMatrix tangent = cell_tangent(law, *cell.shape, at);
            BOOST_TEST((cell_tangent(own, *cell.shape, at) - tangent).norm() <
                       1e-12 * tangent.norm());
          }
    }
}

// Compression, tension, shearing, torsion and bending; forces at nodes where the plates
// hold it, places of the others. Newton's method ends below 1e-12 of the forces.
BOOST_AUTO_TEST_CASE(bodies_have_the_same_equilibria) {
  for (const CellPattern pattern : {CellPattern::hexahedron, CellPattern::tetrahedron}) {
    const Mesh mesh = cube(3, pattern);
    for (const double nu : nus) {
      const Material material = of_poisson_ratio(nu);
      Scene bending{.material = material,
                    .plates = {fixed("bottom")},
                    .gravity = Vector3(-20, 0, 0)};
      for (const Scene& scene :
           {between_plates(material, {0, 0, -0.2 * edge}),
            between_plates(material, {0, 0, 0.2 * edge}),
            between_plates(material, {0.2 * edge, 0, 0}),
            between_plates(material, Vector3::Zero(), 0.7), bending}) {
        const Solution law = solve(mesh, scene, of_law(Element::q1_sri));
        BOOST_TEST_REQUIRE((law.status == SolveStatus::ok), law.reason);
        for (const Lattice& lattice : lattices) {
          const Solution own = solve(mesh, scene, of_lattice(Element::q1_sri, lattice));
          BOOST_TEST_REQUIRE((own.status == SolveStatus::ok), own.reason);
          double moved = 0, pushed = 0, largest_force = 0;
          for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
            moved = std::max(moved, (own.displacements[n] - law.displacements[n]).norm());
            pushed = std::max(pushed, (own.reactions[n] - law.reactions[n]).norm());
            largest_force = std::max(largest_force, law.reactions[n].norm());
          }
          BOOST_TEST(moved < 1e-12 * edge);
          BOOST_TEST(pushed < 1e-12 * largest_force);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
