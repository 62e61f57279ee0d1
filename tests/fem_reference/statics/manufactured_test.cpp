#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "fem_reference/statics/elements_body.hpp"
#include "fem_reference/statics/loads.hpp"
#include "fem_reference/statics/supports.hpp"
#include "statics/minimum.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"

// Manufactured solutions: a smooth field u, the body force f = -div P(grad u) that it
// needs, and the exact values on the boundary. On smoothly curved meshes the errors fall
// with the orders that theory promises: in L2 2 (q1, q1_sri, q1_nodal) and 3 (q2), of the
// gradient 1 and 2, on cells of every type. Pre-asymptotic parts leave them within .1
// between the two finest grids.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(manufactured_test)

namespace {

struct Field {
  std::function<Vector3(const Vector3&)> value;     // u
  std::function<Matrix3(const Vector3&)> gradient;  // H, by hand
};

constexpr double k = std::numbers::pi / edge;

/// Waves that vanish nowhere in particular, strains of up to about .15.
const Field waves{
    .value = [](const Vector3& X) -> Vector3 {
      return edge * Vector3(0.05 * std::sin(k * X.y()) * std::cos(k * X.z() / 2),
                            0.04 * std::sin(k * X.z()) + 0.02 * std::cos(k * X.x()),
                            0.05 * std::sin(k * X.x() / 2) * std::sin(k * X.y() / 2));
    },
    .gradient = [](const Vector3& X) -> Matrix3 {
      const double x = k * X.x(), y = k * X.y(), z = k * X.z();
      Matrix3 H;
      H << 0, 0.05 * std::cos(y) * std::cos(z / 2),
          -0.05 / 2 * std::sin(y) * std::sin(z / 2),   //
          -0.02 * std::sin(x), 0, 0.04 * std::cos(z),  //
          0.05 / 2 * std::cos(x / 2) * std::sin(y / 2),
          0.05 / 2 * std::sin(x / 2) * std::cos(y / 2), 0;
      return k * edge * H;
    }};

/// Twist about the axis x = y = h/2 that grows to 70 degrees at z = h, on top of a wave.
const Field twist{
    .value = [](const Vector3& X) -> Vector3 {
      const double angle = 70. / 180 * std::numbers::pi * X.z() / edge;
      const Vector3 arm(X.x() - edge / 2, X.y() - edge / 2, 0);
      return rotation(angle, Vector3::UnitZ()) * arm - arm + 0.3 * waves.value(X);
    },
    .gradient = [](const Vector3& X) -> Matrix3 {
      const double rate = 70. / 180 * std::numbers::pi / edge;
      const Vector3 arm(X.x() - edge / 2, X.y() - edge / 2, 0);
      Matrix3 in_plane = Matrix3::Identity();
      in_plane(2, 2) = 0;
      const Matrix3 R = rotation(rate * X.z(), Vector3::UnitZ());
      return (R - Matrix3::Identity()) * in_plane +
             rate * Vector3::UnitZ().cross(R * arm) * Vector3::UnitZ().transpose() +
             0.3 * waves.gradient(X);
    }};

/// -div P(H(X)) by extrapolated differences, accurate to about 1e-9.
Vector3 body_force(const Constitution& law, const Field& field, const Vector3& X) {
  Vector3 force = Vector3::Zero();
  for (int J = 0; J < 3; ++J)
    force -= derivative([&](double d) -> Eigen::VectorXd {
               return stress(law, field.gradient(X + d * edge * Vector3::Unit(J))).col(J);
             }) /
             edge;
  return force;
}

struct Errors {
  double value;     // L2 norm of u_h - u over that of u
  double gradient;  // the same of H
};

Errors errors(const Discretisation& body, const Field& field, const Eigen::VectorXd& u) {
  double value = 0, gradient = 0, value_scale = 0, gradient_scale = 0;
  const Eigen::VectorXd places = nodal(body, [](const Vector3& X) { return X; });
  for (const Cell& cell : body.cells) {
    const CellVectors u_cell = of_cell(u, cell), X_cell = of_cell(places, cell);
    for (Eigen::Index q = 0; q < cell.shape->weights.size(); ++q) {
      const Vector3 X = X_cell * cell.shape->values->row(q).transpose();
      const Vector3 u_h = u_cell * cell.shape->values->row(q).transpose();
      const Matrix3 H_h = u_cell * cell.shape->gradients_at(q).transpose();
      const double w = cell.shape->weights[q];
      value += w * (u_h - field.value(X)).squaredNorm();
      gradient += w * (H_h - field.gradient(X)).squaredNorm();
      value_scale += w * field.value(X).squaredNorm();
      gradient_scale += w * field.gradient(X).squaredNorm();
    }
  }
  return {.value = std::sqrt(value / value_scale),
          .gradient = std::sqrt(gradient / gradient_scale)};
}

Errors solved(int cells, CellPattern pattern, double nu, const Settings& settings,
              const Field& field) {
  const Mesh mesh = mapped(cube(cells, pattern), [](const Vector3& X) -> Vector3 {
    const Vector3 wave = (k * X).array().sin();
    return X + 0.08 * edge * wave.prod() * Vector3(1, -0.7, 0.5);
  });
  const Discretisation body = discretise(mesh, settings.element);
  const Scene whole_boundary{.material = of_poisson_ratio(nu),
                             .plates = {},
                             .boundary_gradient = Matrix3(Matrix3::Zero()),
                             .gravity = Vector3::Zero()};
  const Supports supports(mesh, whole_boundary, body);
  const Constitution law = constitution(whole_boundary.material, settings);
  const Eigen::VectorXd exact = nodal(body, field.value);
  ElementsBody elements(body,
                        {.constitution = law, .dilatation = dilatation_taken(settings)});
  const statics::Loading loading{
      .is_free = supports.is_free(),
      .displacements = [&](double) { return exact; },
      .forces =
          body_load(body, [&](const Vector3& X) { return body_force(law, field, X); }),
      .follows_supports = [](const Eigen::VectorXd&, double) { return true; }};
  statics::PotentialEnergy potential(elements, loading, statics::LinearSolver::direct);
  potential.set_load(1);
  std::mt19937_64 random(1);
  // The discrete solution is a few Newton steps away from the exact nodal values.
  const statics::Minimum found =
      statics::minimise(potential, exact, random, statics::Tangents::definite);
  BOOST_TEST_REQUIRE(found.found);
  return errors(body, field, found.state.displacements);
}

void check_orders(CellPattern pattern, Law law, const Field& field,
                  int finest_trilinear) {
  constexpr double nu = 0.3;
  for (const Element element : elements_on(pattern)) {
    const Settings settings{.law = law, .element = element};
    const int degree = element == Element::q2 ? 2 : 1;
    const int finest = finest_trilinear / degree;
    const Errors coarse = solved(finest / 2, pattern, nu, settings, field),
                 fine = solved(finest, pattern, nu, settings, field);
    const double value_order = std::log2(coarse.value / fine.value),
                 gradient_order = std::log2(coarse.gradient / fine.gradient);
    BOOST_TEST_MESSAGE(words(pattern)
                       << ", " << words(law) << ' ' << words(element) << ": L2 order "
                       << value_order << ", H1 order " << gradient_order
                       << ", finest L2 error " << fine.value << ", H1 " << fine.gradient);
    BOOST_TEST_CONTEXT(words(pattern) << ", " << words(law) << ' ' << words(element)) {
      BOOST_TEST(std::abs(value_order - (degree + 1)) < 0.1);
      BOOST_TEST(std::abs(gradient_order - degree) < 0.1);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(gradients_of_the_manufactured_fields_are_right) {
  for (const Field* field : {&waves, &twist})
    for (const Vector3& X : {Vector3(0.01, 0.02, 0.035), Vector3(0.04, 0.03, 0.02)})
      for (int J = 0; J < 3; ++J) {
        const Eigen::VectorXd slope =
            derivative([&](double d) -> Eigen::VectorXd {
              return field->value(X + d * edge * Vector3::Unit(J));
            }) /
            edge;
        BOOST_TEST((slope - field->gradient(X).col(J)).norm() < 1e-9);
      }
}

BOOST_AUTO_TEST_CASE(hooke_converges_with_the_orders_of_its_elements,
                     *boost::unit_test::label("slow")) {
  for (const CellPattern pattern : patterns) check_orders(pattern, Law::hooke, waves, 16);
}

BOOST_AUTO_TEST_CASE(st_venant_converges_with_the_orders_of_its_elements) {
  for (const CellPattern pattern : {CellPattern::hexahedron, CellPattern::tetrahedron})
    check_orders(pattern, Law::st_venant_kirchhoff, waves, 16);
}

BOOST_AUTO_TEST_CASE(hencky_converges_at_large_rotations) {
  for (const CellPattern pattern :
       {CellPattern::hexahedron, CellPattern::tetrahedron, CellPattern::mixed})
    check_orders(pattern, Law::hencky, twist, 12);
}

BOOST_AUTO_TEST_CASE(cauchy_born_converges_at_large_rotations) {
  check_orders(CellPattern::hexahedron, Law::cauchy_born, twist, 12);
}

BOOST_AUTO_TEST_SUITE_END()
