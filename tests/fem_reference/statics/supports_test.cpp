#include "fem_reference/statics/supports.hpp"

#include <boost/test/unit_test.hpp>

#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"

// What plates, pins and a boundary gradient hold of the nodes, q2's intermediate nodes
// among them.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(supports_test)

namespace {

/// What should be prescribed of the node at X [m], and where to at the load fraction s.
using Expected = std::function<Held(const Vector3& X)>;
using Motion = std::function<Vector3(const Vector3& X, double s)>;

void check_numbered(const Mesh& mesh, const Scene& scene, const Expected& held,
                    const Motion& motion) {
  for (const Element element : elements) {
    const Discretisation body = discretise(mesh, element);
    const Supports supports(mesh, scene, body);
    BOOST_TEST_REQUIRE(supports.is_free().size() == 3 * body.nodes.size());
    for (const double s : {0., 0.4, 1.}) {
      const Eigen::VectorXd u = supports.displacements(s);
      for (std::size_t n = 0; n < body.nodes.size(); ++n)
        for (std::size_t i = 0; i < 3; ++i) {
          const Vector3& X = body.nodes[n];
          const auto component = static_cast<Eigen::Index>(i);
          const auto dof = static_cast<Eigen::Index>(3 * n + i);
          BOOST_TEST_CONTEXT(words(element)
                             << ", node at " << X.transpose() << ", component " << i) {
            BOOST_TEST(supports.is_free()[3 * n + i] != held(X)[i]);
            BOOST_TEST(std::abs(u[dof] - (held(X)[i] ? motion(X, s)[component] : 0)) <
                       1e-15);
          }
        }
    }
  }
}

/// Checks the supports on the mesh as it is and with its nodes in disorder.
void check(const Mesh& mesh, const Scene& scene, const Expected& held,
           const Motion& motion) {
  check_numbered(mesh, scene, held, motion);
  check_numbered(renumbered(mesh), scene, held, motion);
}

bool at(double coordinate, double value) {
  return std::abs(coordinate - value) < 1e-9;
}

constexpr Held nothing{false, false, false};
constexpr Held x_only{true, false, false}, z_only{false, false, true};

}  // namespace

// One cell between the plates: the nodes in the middle of its upright edges have both
// ends held and are free.
BOOST_AUTO_TEST_CASE(glued_plates_hold_their_nodes_and_no_others) {
  const RigidMotion turn{.translation = Vector3(0.01, 0, -0.02),
                         .axis = Vector3(1, 0, 2).normalized(),
                         .centre = Vector3(0.02, 0.03, 0.05),
                         .angle = 1.1};
  const Scene scene{.material = of_poisson_ratio(0.3),
                    .plates = {fixed("bottom"), plate("top", turn)},
                    .gravity = Vector3::Zero()};
  for (const int cells : {1, 2})
    check(
        cube(cells), scene,
        [](const Vector3& X) {
          return at(X.z(), 0) || at(X.z(), edge) ? all_components : nothing;
        },
        [&](const Vector3& X, double s) -> Vector3 {
          return at(X.z(), 0) ? Vector3::Zero() : displacement(turn, X, s);
        });
}

BOOST_AUTO_TEST_CASE(warped_plates_carry_their_intermediate_nodes_along) {
  const Mesh mesh = distorted_cube(2, 0.2, Moved::all_nodes);
  const RigidMotion turn{.translation = Vector3(0.01, 0, -0.02),
                         .axis = Vector3::UnitZ(),
                         .centre = Vector3(0.02, 0.03, 0.05),
                         .angle = 0.8};
  const Scene scene{.material = of_poisson_ratio(0.3),
                    .plates = {plate("top", turn)},
                    .gravity = Vector3::Zero()};
  const Discretisation body = discretise(mesh, Element::q2);
  const Supports supports(mesh, scene, body);
  const Eigen::VectorXd u = supports.displacements(1);
  int held = 0;
  for (std::size_t n = 0; n < body.nodes.size(); ++n) {
    if (supports.is_free()[3 * n]) continue;
    ++held;
    BOOST_TEST((u.segment<3>(static_cast<Eigen::Index>(3 * n)) -
                displacement(turn, body.nodes[n], 1))
                   .norm() < 1e-15);
  }
  BOOST_TEST(held == 25);
}

BOOST_AUTO_TEST_CASE(sliding_plates_and_pins_hold_single_components) {
  const Vector3 up(0, 0, 0.004);
  const Scene scene{
      .material = of_poisson_ratio(0.3),
      .plates = {plate("bottom", translation(Vector3::Zero()), z_only),
                 plate("top", translation(up), z_only)},
      .pins = {{.point = Vector3::Zero(), .held = {true, true, false}},
               {.point = Vector3(edge, 0, 0), .held = {false, true, false}}},
      .gravity = Vector3::Zero()};
  for (const int cells : {1, 2})
    check(
        cube(cells), scene,
        [](const Vector3& X) -> Held {
          const bool first = X.norm() < 1e-9;
          return {first, first || (X - Vector3(edge, 0, 0)).norm() < 1e-9,
                  at(X.z(), 0) || at(X.z(), edge)};
        },
        [&](const Vector3& X, double s) -> Vector3 {
          return (at(X.z(), edge) ? s : 0) * up;
        });
}

// The nodes in the middle of an edge that leads from one plate to another belong to
// neither, although a third plate has the edge and both its ends are held.
BOOST_AUTO_TEST_CASE(sliding_plates_that_meet_hold_what_each_of_them_holds) {
  const Vector3 apart(0.003, 0, 0);
  const Scene scene{.material = of_poisson_ratio(0.3),
                    .plates = {plate("x_min", translation(-apart), x_only),
                               plate("x_max", translation(apart), x_only),
                               plate("bottom", translation(Vector3::Zero()), z_only)},
                    .gravity = Vector3::Zero()};
  for (const int cells : {1, 2})
    check(
        cube(cells), scene,
        [](const Vector3& X) -> Held {
          return {at(X.x(), 0) || at(X.x(), edge), false, at(X.z(), 0)};
        },
        [&](const Vector3& X, double s) -> Vector3 {
          return (at(X.x(), 0) ? -s : s) * apart;
        });
}

BOOST_AUTO_TEST_CASE(boundary_gradient_moves_the_whole_boundary) {
  const Matrix3 H = general_gradient();
  const Scene scene{.material = of_poisson_ratio(0.3),
                    .plates = {},
                    .boundary_gradient = H,
                    .gravity = Vector3::Zero()};
  for (const int cells : {1, 2})
    check(
        cube(cells), scene,
        [](const Vector3& X) { return on_cubes_boundary(X) ? all_components : nothing; },
        [&](const Vector3& X, double s) -> Vector3 { return s * (H * X); });
}

// The resultant and torque are kept in every affine state: the intermediate nodes stay at
// the mean of their vertices. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(forces_on_vertices_keep_resultant_and_torque) {
  const Mesh mesh = distorted_cube(2, 0.2, Moved::all_nodes);
  const Discretisation body = discretise(mesh, Element::q2);
  const Eigen::VectorXd forces = random_nodal(body, 1);  // N
  const std::vector<Vector3> shared = on_vertices(body, forces);
  BOOST_TEST_REQUIRE(shared.size() == mesh.nodes().size());
  BOOST_TEST((total(shared) - total(forces)).norm() < 1e-13);
  for (const Matrix3& F : {Matrix3(Matrix3::Identity()), Matrix3(rotation(1, {1, 2, 3})),
                           Matrix3(Matrix3::Identity() + general_gradient())}) {
    Vector3 torque = Vector3::Zero(), torque_shared = Vector3::Zero();
    for (std::size_t n = 0; n < body.nodes.size(); ++n)
      torque +=
          (F * body.nodes[n]).cross(forces.segment<3>(static_cast<Eigen::Index>(3 * n)));
    for (std::size_t n = 0; n < shared.size(); ++n)
      torque_shared += (F * mesh.nodes()[n]).cross(shared[n]);
    BOOST_TEST((torque_shared - torque).norm() < 1e-13 * edge);
  }
}

BOOST_AUTO_TEST_CASE(forces_of_trilinear_elements_stay_where_they_are) {
  const Discretisation body = discretise(cube(2), Element::q1);
  const Eigen::VectorXd forces = random_nodal(body, 1);
  const std::vector<Vector3> shared = on_vertices(body, forces);
  for (std::size_t n = 0; n < body.nodes.size(); ++n)
    BOOST_TEST((shared[n] == forces.segment<3>(static_cast<Eigen::Index>(3 * n))));
}

BOOST_AUTO_TEST_SUITE_END()
