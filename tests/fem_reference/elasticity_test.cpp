#define BOOST_TEST_MODULE fem_reference_elasticity
#include "fem_reference/elasticity.hpp"

#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "fem_reference/equilibrium.hpp"
#include "fem_reference/materials.hpp"
#include "meshing/gmsh.hpp"
#include "meshing/input_error.hpp"

using namespace springcheck;
using namespace springcheck::fem_reference;

namespace {

constexpr Material material{.young_modulus = 1e4, .poisson_ratio = 0.3, .density = 1000};
constexpr double size = 0.05;  // m, the cube's edge
const Vector3 no_gravity = Vector3::Zero();

constexpr std::array<Settings, 4> all_settings{
    {{.law = Law::hooke, .element = Element::q1},
     {.law = Law::hooke, .element = Element::q1_sri},
     {.law = Law::st_venant_kirchhoff, .element = Element::q1},
     {.law = Law::st_venant_kirchhoff, .element = Element::q1_sri}}};

Mesh cube(int cells) {
  return generate_block({.size = {size, size, size}, .cells = {cells, cells, cells}});
}

Mesh mapped(const Mesh& mesh, const std::function<Vector3(const Vector3&)>& map) {
  std::vector<Vector3> nodes;
  for (const Vector3& x : mesh.nodes()) nodes.push_back(map(x));
  return {"mapped " + mesh.source(), nodes, mesh.hexahedra(), {}};
}

bool on_boundary(const Vector3& x) {
  return x.minCoeff() < 1e-9 || x.maxCoeff() > size - 1e-9;
}

/// Every interior node moved by up to a quarter of the cell edge.
Mesh distorted_cube(int cells) {
  std::mt19937 random(7);
  const auto amount = [&] {
    return (static_cast<double>(random()) / 0x1p31 - 1) * size / (4 * cells);
  };
  return mapped(cube(cells), [&](const Vector3& x) {
    const Vector3 move(amount(), amount(), amount());
    return on_boundary(x) ? x : x + move;
  });
}

std::vector<NodeIndex> boundary_nodes(const Mesh& mesh) {
  std::vector<NodeIndex> nodes;
  for (NodeIndex node = 0; node < mesh.nodes().size(); ++node)
    if (on_boundary(mesh.nodes()[node])) nodes.push_back(node);
  return nodes;
}

Eigen::VectorXd nodal(const Mesh& mesh,
                      const std::function<Vector3(const Vector3&)>& field) {
  Eigen::VectorXd values(3 * static_cast<Eigen::Index>(mesh.nodes().size()));
  for (NodeIndex node = 0; node < mesh.nodes().size(); ++node)
    values.segment<3>(3 * node) = field(mesh.nodes()[node]);
  return values;
}

Eigen::VectorXd random_nodal(const Mesh& mesh, double amplitude) {
  std::mt19937 random(11);
  return nodal(mesh, [&](const Vector3&) -> Vector3 {
    const auto amount = [&] { return static_cast<double>(random()) / 0x1p31 - 1; };
    const double x = amount(), y = amount(), z = amount();
    return amplitude * Vector3(x, y, z);
  });
}

Plate held(std::string region) {
  return {.region = std::move(region),
          .motion = {.translation = Vector3::Zero(),
                     .axis = Vector3::UnitZ(),
                     .centre = Vector3::Zero(),
                     .angle = 0}};
}

Plate moved_top(const Vector3& translation, double angle) {
  return {.region = "top",
          .motion = {.translation = translation,
                     .axis = Vector3::UnitZ(),
                     .centre = Vector3(size / 2, size / 2, size),
                     .angle = angle}};
}

Scene between_plates(const Vector3& translation, double angle) {
  return {.material = material,
          .plates = {held("bottom"), moved_top(translation, angle)},
          .gravity = no_gravity};
}

Vector3 sum(const std::vector<Vector3>& vectors) {
  Vector3 total = Vector3::Zero();
  for (const Vector3& v : vectors) total += v;
  return total;
}

}  // namespace

// With an affine displacement on the whole boundary every law and element reproduces it
// inside, on cells of any shape. Tolerance: Newton's 1e-10 of the reactions.
BOOST_AUTO_TEST_CASE(affine_fields_are_reproduced_on_distorted_hexahedra) {
  const Mesh mesh = distorted_cube(4);
  Matrix3 H;
  H << 0.05, -0.03, 0.02, 0.04, -0.06, 0.01, -0.02, 0.05, 0.03;
  const Eigen::VectorXd affine =
      nodal(mesh, [&](const Vector3& x) -> Vector3 { return H * x; });
  for (const Settings& settings : all_settings) {
    Elasticity body(mesh, material, settings, boundary_nodes(mesh));
    const Equilibrium found = find_equilibrium(
        body, settings.law,
        {.displacements = [&](double s) -> Eigen::VectorXd { return s * affine; },
         .forces = Eigen::VectorXd::Zero(affine.size())});
    BOOST_TEST((found.status == SolveStatus::ok));
    BOOST_TEST((found.displacements - affine).norm() < 1e-9 * affine.norm());
    const double density =
        energy(settings.law, energy_density(Part::whole, lame_constants(material)), H);
    BOOST_TEST(found.energy == mesh.volume() * density,
               boost::test_tools::tolerance(1e-12));
  }
}

// u = (a z^2 + b x y, c x^2, d y z) is in equilibrium with a uniform body force. On a
// smoothly curved mesh the error falls with h^2: by 4 per halving, 3.4 to 4.6 allowed.
BOOST_AUTO_TEST_CASE(manufactured_quadratic_field_converges_at_second_order) {
  constexpr double a = 0.7, b = -0.4, c = 0.5, d = 0.9;  // 1/m
  const auto [lambda, mu] = lame_constants(material);
  const Vector3 force = -Vector3(2 * mu * a, 2 * mu * c + (lambda + mu) * (b + d), 0);
  const auto field = [&](const Vector3& x) -> Vector3 {
    return {a * x.z() * x.z() + b * x.x() * x.y(), c * x.x() * x.x(), d * x.y() * x.z()};
  };
  const auto curve = [](const Vector3& x) -> Vector3 {
    const Vector3 wave = (std::numbers::pi / size * x).array().sin();
    return x + 0.08 * size * wave.prod() * Vector3(1, -0.7, 0.5);
  };
  for (const Element element : {Element::q1, Element::q1_sri}) {
    const auto error = [&](int cells) {
      const Mesh mesh = mapped(cube(cells), curve);
      const Eigen::VectorXd exact = nodal(mesh, field);
      Elasticity body(mesh, material, {.law = Law::hooke, .element = element},
                      boundary_nodes(mesh));
      const Equilibrium found = find_equilibrium(
          body, Law::hooke,
          {.displacements = [&](double s) -> Eigen::VectorXd { return s * exact; },
           .forces = body.weight(force / material.density)});
      return (found.displacements - exact).norm() / exact.norm();
    };
    const double rate = error(6) / error(12);
    BOOST_TEST(rate > 3.4);
    BOOST_TEST(rate < 4.6);
  }
}

// Central differences: error about 1e-16/1e-6 of round-off and (1e-6)^2, so 1e-8.
BOOST_AUTO_TEST_CASE(forces_are_the_derivative_of_the_energy) {
  const Mesh mesh = distorted_cube(2);
  const Eigen::VectorXd u = random_nodal(mesh, 0.1 * size / 2);
  const Eigen::VectorXd direction =
      nodal(mesh, [](const Vector3& x) -> Vector3 { return x.cwiseProduct(x) / size; });
  for (const Settings& settings : all_settings) {
    const Elasticity body(mesh, material, settings, {});
    constexpr double d = 1e-5;
    const double slope = (body.internal(u + d * direction).energy -
                          body.internal(u - d * direction).energy) /
                         (2 * d);
    BOOST_TEST(slope == body.internal(u).forces.dot(direction),
               boost::test_tools::tolerance(1e-7));
  }
}

// The forces' change along a direction, sent through step(), is that direction again, on
// free and prescribed nodes; so step() holds the exact tangent. Error as above, times the
// condition of the tangent, some 100.
BOOST_AUTO_TEST_CASE(step_inverts_the_derivative_of_the_forces) {
  const Mesh mesh = distorted_cube(2);
  const Eigen::VectorXd u = random_nodal(mesh, 0.02 * size / 2);
  const Eigen::VectorXd direction =
      nodal(mesh, [](const Vector3& x) -> Vector3 { return x.cwiseProduct(x) / size; });
  for (const Settings& settings : all_settings) {
    Elasticity body(mesh, material, settings, std::vector<NodeIndex>{0, 1, 4, 5});
    constexpr double d = 1e-4;
    const Eigen::VectorXd change = (body.internal(u + d * direction).forces -
                                    body.internal(u - d * direction).forces) /
                                   (2 * d);
    BOOST_TEST_REQUIRE(body.factor(u));
    BOOST_TEST((body.step(change, direction) - direction).norm() <
               1e-5 * direction.norm());
  }
}

// u_x = c x z about the centre of a cube of edge h: eps_xx = c z, eps_xz = c x/2, and
// int x^2 = int z^2 = h^5/12. Its mean dilatation is zero: q1_sri spares it K.
BOOST_AUTO_TEST_CASE(one_element_in_bending_has_its_closed_form_energy,
                     *boost::unit_test::tolerance(1e-12)) {
  const Mesh mesh = cube(1);
  constexpr double c = 0.3;  // 1/m
  const Eigen::VectorXd u = nodal(mesh, [](const Vector3& x) -> Vector3 {
    return {c * (x.x() - size / 2) * (x.z() - size / 2), 0, 0};
  });
  const auto [lambda, mu] = lame_constants(material);
  const double inertia = c * c * std::pow(size, 5) / 12;
  const auto energy_of = [&](Element element) {
    return Elasticity(mesh, material, {.law = Law::hooke, .element = element}, {})
        .internal(u)
        .energy;
  };
  BOOST_TEST(energy_of(Element::q1) == inertia * (1.5 * mu + lambda / 2));
  BOOST_TEST(energy_of(Element::q1_sri) == inertia * (1.5 * mu - mu / 3));
}

// All eight nodes prescribed: uniaxial strain, each upper corner carries a quarter.
BOOST_AUTO_TEST_CASE(one_element_between_plates_has_its_closed_form_reactions,
                     *boost::unit_test::tolerance(1e-12)) {
  constexpr double e = 0.05;
  const auto [lambda, mu] = lame_constants(material);
  const Mesh mesh = cube(1);
  for (const Element element : {Element::q1, Element::q1_sri}) {
    const Solution solution = solve(mesh, between_plates({0, 0, -e * size}, 0),
                                    {.law = Law::hooke, .element = element});
    BOOST_TEST((solution.status == SolveStatus::ok));
    for (const NodeIndex node : mesh.region("top").nodes)
      BOOST_TEST(solution.reactions[node].z() ==
                 -(lambda + 2 * mu) * e * size * size / 4);
  }
}

// A column of nu = 0 under its own weight shortens by rho g L^2/(2E), exact at the nodes.
BOOST_AUTO_TEST_CASE(column_shortens_under_its_weight,
                     *boost::unit_test::tolerance(1e-10)) {
  const Mesh mesh = cube(3);
  const Scene scene{
      .material = {.young_modulus = 1e4, .poisson_ratio = 0, .density = 1000},
      .plates = {held("bottom")},
      .gravity = Vector3(0, 0, -10)};
  const Solution solution =
      solve(mesh, scene, {.law = Law::hooke, .element = Element::q1_sri});
  for (const NodeIndex node : mesh.region("top").nodes)
    BOOST_TEST(solution.displacements[node].z() == -1000 * 10 * size * size / (2 * 1e4));
  BOOST_TEST(sum(solution.reactions).z() == 1000 * 10 * std::pow(size, 3));
}

// Equilibrium holds to Newton's 1e-10: Hooke's about the undeformed nodes,
// St-Venant's about the deformed ones.
BOOST_AUTO_TEST_CASE(reactions_have_no_net_force_or_torque) {
  const Mesh mesh = cube(3);
  for (const Settings& settings : all_settings) {
    const Solution solution =
        solve(mesh, between_plates({0.1 * size, 0, -0.1 * size}, 0.4), settings);
    BOOST_TEST((solution.status == SolveStatus::ok));
    double size_of_forces = 0;
    Vector3 torque = Vector3::Zero();
    for (NodeIndex node = 0; node < mesh.nodes().size(); ++node) {
      Vector3 arm = mesh.nodes()[node];
      if (solution.lever_arms == LeverArms::deformed) arm += solution.displacements[node];
      torque += arm.cross(solution.reactions[node]);
      size_of_forces += solution.reactions[node].norm();
    }
    BOOST_TEST(sum(solution.reactions).norm() < 1e-10 * size_of_forces);
    BOOST_TEST(torque.norm() < 1e-10 * size * size_of_forces);
  }
}

// Both plates turn by 100 degrees together. What is left is round-off: 1e-12 of E L^2.
BOOST_AUTO_TEST_CASE(st_venant_body_is_free_of_force_after_a_rigid_motion) {
  const Mesh mesh = cube(3);
  const RigidMotion motion{.translation = Vector3(0.01, -0.02, 0.03),
                           .axis = Vector3(1, 2, -1).normalized(),
                           .centre = Vector3(0.02, 0.01, 0.07),
                           .angle = 100 * std::numbers::pi / 180};
  const Scene scene{.material = material,
                    .plates = {{.region = "bottom", .motion = motion},
                               {.region = "top", .motion = motion}},
                    .gravity = no_gravity};
  for (const Element element : {Element::q1, Element::q1_sri}) {
    const Solution solution =
        solve(mesh, scene, {.law = Law::st_venant_kirchhoff, .element = element});
    BOOST_TEST((solution.status == SolveStatus::ok));
    for (const Vector3& reaction : solution.reactions)
      BOOST_TEST(reaction.norm() < 1e-12 * material.young_modulus * size * size);
    for (NodeIndex node = 0; node < mesh.nodes().size(); ++node)
      BOOST_TEST(
          (solution.displacements[node] - displacement(motion, mesh.nodes()[node], 1))
              .norm() < 1e-12);
  }
}

// The prediction from plates and weight is the answer: the only evaluations are those at
// rest and at the result.
BOOST_AUTO_TEST_CASE(hooke_takes_one_step_and_one_linear_solve) {
  Scene heavy = between_plates({0, 0, -0.2 * size}, 0);
  heavy.gravity = Vector3(-10, 0, 0);
  const Solution solution =
      solve(cube(4), heavy, {.law = Law::hooke, .element = Element::q1_sri});
  BOOST_TEST((solution.status == SolveStatus::ok));
  BOOST_TEST(solution.steps == 1);
  BOOST_TEST(solution.force_evaluations == 2);
}

// Without load nothing moves, and a load of 1e-9 is not taken for none: the reaction is
// Hooke's to first order in the strain.
BOOST_AUTO_TEST_CASE(st_venant_meets_hooke_at_tiny_strain,
                     *boost::unit_test::tolerance(1e-7)) {
  const Mesh mesh = cube(2);
  const auto force = [&](Law law, double strain) {
    const Solution solution = solve(mesh, between_plates({0, 0, -strain * size}, 0),
                                    {.law = law, .element = Element::q1_sri});
    BOOST_TEST((solution.status == SolveStatus::ok));
    double total = 0;
    for (const NodeIndex node : mesh.region("top").nodes)
      total += solution.reactions[node].z();
    return total;
  };
  BOOST_TEST(force(Law::st_venant_kirchhoff, 0) == 0);
  BOOST_TEST(force(Law::st_venant_kirchhoff, 1e-9) == force(Law::hooke, 1e-9));
}

// The homogeneous bar of nu = 0 has its limit at a stretch of 0.577 and, cut into cells,
// loses definiteness before; Newton's method would converge through it unseen.
BOOST_AUTO_TEST_CASE(equilibrium_past_a_bifurcation_is_reported_indefinite) {
  Scene scene = between_plates({0, 0, -0.45 * size}, 0);
  scene.material.poisson_ratio = 0;
  const Solution solution = solve(
      cube(3), scene, {.law = Law::st_venant_kirchhoff, .element = Element::q1_sri});
  BOOST_TEST((solution.status == SolveStatus::indefinite));
  BOOST_TEST(solution.load_fraction == 1);
  BOOST_TEST(solution.reason.find("lost positive definiteness at") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(limit_point_is_reported_with_the_load_reached) {
  const Solution solution =
      solve(cube(4), between_plates({0, 0, -0.6 * size}, 0),
            {.law = Law::st_venant_kirchhoff, .element = Element::q1_sri});
  BOOST_TEST((solution.status == SolveStatus::no_equilibrium));
  BOOST_TEST(solution.load_fraction > 0.5);
  BOOST_TEST(solution.load_fraction < 1);
  BOOST_TEST(solution.reason.find("limit point at") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(motion_that_is_not_a_number_never_ends_ok) {
  for (const Settings& settings : all_settings) {
    const Solution solution =
        solve(cube(2), between_plates({0, 0, std::nan("")}, 0), settings);
    BOOST_TEST((solution.status == SolveStatus::not_converged));
    BOOST_TEST(solution.load_fraction == 0);
  }
}

BOOST_AUTO_TEST_CASE(impossible_input_is_refused_by_name) {
  const Mesh mesh = cube(1);
  const Scene good = between_plates(Vector3::Zero(), 0);
  Scene rigid = good, incompressible = good, loose = good;
  rigid.material.young_modulus = 0;
  incompressible.material.poisson_ratio = 0.5;
  loose.plates.clear();
  for (const Scene& bad : {rigid, incompressible, loose})
    BOOST_CHECK_THROW(solve(mesh, bad, all_settings[0]), InputError);
}
