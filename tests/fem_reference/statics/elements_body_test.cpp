#include "fem_reference/statics/elements_body.hpp"

#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>

#include "meshing/cell_geometry.hpp"
#include "statics/potential_energy.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"

// The discrete body: sums over its cells, and its tangent.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(elements_body_test)

namespace {

const Material material = of_poisson_ratio(0.3);

CellLaw law_of(const Settings& settings) {
  return {.constitution = constitution(material, settings),
          .dilatation = dilatation_taken(settings)};
}

}  // namespace

// Errors of the differences as in laws.hpp, for forces of E edge^2.
BOOST_AUTO_TEST_CASE(forces_are_the_derivative_of_the_energy) {
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = warped_cube(2, pattern);
    for (const Element element : elements_on(pattern)) {
      const Discretisation body = discretise(mesh, element);
      const Eigen::VectorXd u = random_nodal(body, 0.02 * edge),
                            along = random_nodal(body, edge, 3);
      for (const Law law : laws) {
        ElementsBody elements(body, law_of({.law = law, .element = element}));
        const auto energies = [&](double d) {
          return scalar(elements.state(u + d * along).strain_energy);
        };
        const double slope = -elements.state(u).forces.dot(along);
        BOOST_TEST(std::abs(derivative(energies)[0] - slope) <
                   1e-8 * young * edge * edge * edge);
      }
    }
  }
}

// Errors as above, of up to 375 components.
BOOST_AUTO_TEST_CASE(parts_add_up_to_minus_the_derivative_of_the_forces) {
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = cube(2, pattern, 0.2);
    for (const Element element : elements_on(pattern))
      for (const Law law : laws)
        BOOST_TEST_CONTEXT(words(pattern)
                           << ", " << words(law) << ' ' << words(element)) {
          const Discretisation body = discretise(mesh, element);
          ElementsBody elements(body, law_of({.law = law, .element = element}));
          const Eigen::VectorXd u = random_nodal(body, 0.01 * edge),
                                along = random_nodal(body, edge, 3);
          const Eigen::VectorXd change = derivative([&](double d) -> Eigen::VectorXd {
            return elements.state(u + d * along).forces;
          });
          elements.linearise(u);
          statics::BlockMatrix tangent(elements.patches(), body.nodes.size());
          tangent.assemble([&](std::size_t patch) { return elements.part(patch); });
          Eigen::VectorXd product;
          tangent.multiply(along, product);
          BOOST_TEST((change + product).norm() < 1e-7 * young * edge * edge);
        }
  }
}

// St-Venant's cells lose their stiffness at a stretch of .577. Round-off of an
// eigendecomposition.
BOOST_AUTO_TEST_CASE(positive_parts_have_the_positive_eigenvalues_alone) {
  for (const Element element : elements) {
    const Discretisation body = discretise(cube(1), element);
    ElementsBody elements(body,
                          law_of({.law = Law::st_venant_kirchhoff, .element = element}));
    elements.linearise(nodal(body, [](const Vector3& X) -> Vector3 {
      return {0, 0, -.5 * X.z()};
    }));
    const auto spectrum = [](const Eigen::MatrixXd& K) -> Eigen::VectorXd {
      return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
    };
    const Eigen::VectorXd all = spectrum(elements.part(0));
    BOOST_TEST(all[0] < -1e-3 * all.norm());
    BOOST_TEST((spectrum(elements.positive_part(0)) - all.cwiseMax(0)).norm() <
               1e-12 * all.norm());
  }
}

// So do the nodal patches' of q1_nodal, part by part: the law's of their tetrahedra, and
// that of Hencky's volume, whose U'' is negative beyond J = e.
BOOST_AUTO_TEST_CASE(positive_parts_of_patches_have_no_negative_eigenvalues) {
  const auto least = [](const Eigen::MatrixXd& K) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues()[0];
  };
  struct Stretched {
    CellPattern pattern;
    Law law;
    double strain;
  };
  for (const auto& [pattern, law, strain] :
       {Stretched{CellPattern::tetrahedron, Law::st_venant_kirchhoff, -.5},
        Stretched{CellPattern::hexahedron, Law::hencky, 2.}}) {
    const Discretisation body = discretise(cube(1, pattern), Element::q1_nodal);
    ElementsBody elements(body, law_of({.law = law, .element = Element::q1_nodal}));
    elements.linearise(nodal(body, [&](const Vector3& X) -> Vector3 {
      return {0, 0, strain * X.z()};
    }));
    for (std::size_t nodal_patch = body.cells.size();
         nodal_patch < elements.patches().size(); ++nodal_patch) {
      const double size = elements.part(nodal_patch).norm();
      BOOST_TEST(least(elements.part(nodal_patch)) < -1e-3 * size);
      BOOST_TEST(least(elements.positive_part(nodal_patch)) > -1e-12 * size);
    }
    elements.linearise(Eigen::VectorXd::Zero(3 * std::ssize(body.nodes)));
    for (std::size_t nodal_patch = body.cells.size();
         nodal_patch < elements.patches().size(); ++nodal_patch)
      BOOST_TEST(
          (elements.part(nodal_patch) - elements.positive_part(nodal_patch)).norm() <
          1e-12 * elements.part(nodal_patch).norm());
  }
}

// Hooke's law alone has an energy where cells are inside out.
BOOST_AUTO_TEST_CASE(inverted_states_have_no_energy) {
  for (const Law law : laws)
    for (const Element element : elements) {
      const Discretisation body = discretise(cube(2), element);
      ElementsBody elements(body, law_of({.law = law, .element = element}));
      const auto energy = [&](double strain) {
        const Eigen::VectorXd u = nodal(body, [&](const Vector3& X) -> Vector3 {
          return {0, 0, strain * X.z()};
        });
        return elements.state(u).strain_energy;
      };
      BOOST_TEST(std::isfinite(energy(-.9)));
      BOOST_TEST((energy(-1.1) == INFINITY) == (law != Law::hooke));
      BOOST_TEST(elements.is_linear() == (law == Law::hooke));
    }
}

// Round-off.
BOOST_AUTO_TEST_CASE(homogeneous_body_reports_its_gradient_and_volumes,
                     *boost::unit_test::tolerance(1e-12)) {
  const Matrix3 H = general_gradient();
  const double J = (Matrix3::Identity() + H).determinant();
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = warped_cube(2, pattern);
    for (const Element element : elements_on(pattern)) {
      const Discretisation body = discretise(mesh, element);
      const ElementsBody elements(body, law_of({.law = Law::hencky, .element = element}));
      const Eigen::VectorXd u =
          nodal(body, [&](const Vector3& X) -> Vector3 { return H * X; });
      BOOST_TEST(elements.mean_gradient(u) == H.norm());
      BOOST_TEST(elements.largest_volume_ratio(u) == J);
      BOOST_TEST(elements.cell_edge() == mesh.mean_cell_edge());
      const std::vector<double> volumes = elements.cell_volumes(u);
      for (std::size_t c = 0; c < volumes.size(); ++c)
        BOOST_TEST(volumes[c] == J * mesh.cell_volumes()[c]);
    }
  }
}

// The deformed cell's exact volume. Round-off.
BOOST_AUTO_TEST_CASE(cell_volumes_are_exact_in_any_field_of_a_linear_element,
                     *boost::unit_test::tolerance(1e-12)) {
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = warped_cube(2, pattern);
    const Discretisation body = discretise(mesh, Element::q1);
    const ElementsBody elements(body,
                                law_of({.law = Law::hooke, .element = Element::q1}));
    const Eigen::VectorXd u = random_nodal(body, 0.05 * edge);
    std::vector<Vector3> moved = mesh.nodes();
    for (std::size_t n = 0; n < moved.size(); ++n)
      moved[n] += u.segment<3>(static_cast<Eigen::Index>(3 * n));
    const std::vector<double> expected = cell_volumes(mesh.cells(), moved);
    const std::vector<double> volumes = elements.cell_volumes(u);
    for (std::size_t c = 0; c < volumes.size(); ++c)
      BOOST_TEST(volumes[c] == expected[c]);
  }
}

// The rounding of the forces of a turned body, which carries none: within the estimate,
// and the estimate is not much larger (100 times).
BOOST_AUTO_TEST_CASE(rounding_estimates_that_of_the_forces) {
  const Discretisation body = discretise(cube(4), Element::q1);
  ElementsBody elements(body, law_of({.law = Law::hencky, .element = Element::q1}));
  const Matrix3 turn = rotation(1.3, {1, 2, 3}) - Matrix3::Identity();
  const Eigen::VectorXd u =
      nodal(body, [&](const Vector3& X) -> Vector3 { return turn * X; });
  const statics::Loading loading{
      .is_free = std::vector<bool>(3 * body.nodes.size(), true),
      .displacements = [&](double) { return u; },
      .forces = Eigen::VectorXd::Zero(u.size()),
      .follows_supports = [](const Eigen::VectorXd&, double) { return true; }};
  statics::PotentialEnergy potential(elements, loading, statics::LinearSolver::direct);
  potential.linearise(u);
  const double rounding = elements.state(u).forces.norm();
  BOOST_TEST(rounding < potential.force_round_off(u));
  BOOST_TEST(potential.force_round_off(u) < 1e-11 * young * edge * edge);
}

BOOST_AUTO_TEST_SUITE_END()
