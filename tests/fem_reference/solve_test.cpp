#include "fem_reference/solve.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "meshing/basics/input_error.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"

// The solver as its users call it, against closed forms of whole bodies.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(solve_test)

namespace {

void for_all_settings(const std::function<void(const Settings&)>& test,
                      CellPattern pattern = CellPattern::hexahedron) {
  for (const Law law : laws)
    for (const Element element : elements_on(pattern))
      BOOST_TEST_CONTEXT(words(law) << ' ' << words(element))
  test({.law = law, .element = element});
}

Vector3 force_on(const Mesh& mesh, const std::string& region, const Solution& solution) {
  Vector3 force = Vector3::Zero();
  for (const NodeIndex node : mesh.region(region).nodes)
    force += solution.reactions[node];
  return force;
}

}  // namespace

// All eight nodes prescribed: uniaxial strain; on_vertices() leaves each upper corner a
// quarter.
BOOST_AUTO_TEST_CASE(one_element_between_plates_has_its_closed_form_reactions,
                     *boost::unit_test::tolerance(1e-12)) {
  constexpr double e = 0.05;
  const Material material = of_poisson_ratio(0.3);
  const auto [lambda, mu] = lame_constants(material);
  const Mesh mesh = cube(1);
  for (const Element element : {Element::q1, Element::q1_sri}) {
    const Solution solution = solve(mesh, between_plates(material, {0, 0, -e * edge}),
                                    {.law = Law::hooke, .element = element});
    BOOST_TEST((solution.status == SolveStatus::ok));
    for (const NodeIndex node : mesh.region("top").nodes)
      BOOST_TEST(solution.reactions[node].z() ==
                 -(lambda + 2 * mu) * e * edge * edge / 4);
    BOOST_TEST(solution.strain_energy ==
               (lambda + 2 * mu) / 2 * e * e * edge * edge * edge);
  }
}

// A column of nu = 0 under its own weight shortens by rho g L^2/(2E), exact at the nodes
// of elements whose cells act by themselves.
BOOST_AUTO_TEST_CASE(hexahedral_column_shortens_under_its_weight,
                     *boost::unit_test::tolerance(1e-10)) {
  const Mesh mesh = cube(3);
  const Scene scene{.material = of_poisson_ratio(0),
                    .plates = {fixed("bottom")},
                    .gravity = Vector3(0, 0, -10)};
  for (const Element element : {Element::q1, Element::q1_sri, Element::q2}) {
    const Solution solution = solve(mesh, scene, {.law = Law::hooke, .element = element});
    for (const NodeIndex node : mesh.region("top").nodes)
      BOOST_TEST(solution.displacements[node].z() ==
                 -1000 * 10 * edge * edge / (2 * young));
    BOOST_TEST(total(solution.reactions).z() == 1000 * 10 * std::pow(edge, 3));
  }
}

// Pulled by a dead load of t = .1 E on its top, a body of nu = 0 stretches uniformly:
// by t/E for Hooke, to the root of l (l^2 - 1)/2 = t/E for St-Venant.
BOOST_AUTO_TEST_CASE(traction_stretches_a_body_uniformly) {
  const Scene scene{.material = of_poisson_ratio(0),
                    .plates = {fixed("bottom")},
                    .tractions = {{.region = "top", .stress = {0, 0, 0.1 * young}}},
                    .gravity = Vector3::Zero()};
  double stretch = 1;
  for (int iteration = 0; iteration < 30; ++iteration)
    stretch -=
        (stretch * (stretch * stretch - 1) / 2 - 0.1) / (1.5 * stretch * stretch - 0.5);
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = cube(2, pattern, 0.2);
    for (const Element element : elements_on(pattern))
      for (const Law law : {Law::hooke, Law::st_venant_kirchhoff}) {
        const Solution solution = solve(mesh, scene, {.law = law, .element = element});
        BOOST_TEST((solution.status == SolveStatus::ok));
        const double growth = law == Law::hooke ? 0.1 : stretch - 1;
        for (std::size_t n = 0; n < mesh.nodes().size(); ++n)
          BOOST_TEST((solution.displacements[n] -
                      growth * mesh.nodes()[n].z() * Vector3::UnitZ())
                         .norm() < 1e-9 * edge);
        BOOST_TEST((force_on(mesh, "bottom", solution) +
                    0.1 * young * edge * edge * Vector3::UnitZ())
                       .norm() < 1e-9 * young * edge * edge);
        BOOST_TEST(force_on(mesh, "top", solution).norm() == 0);
      }
  }
}

// Whatever the field inside, the support carries the body's weight and the torque of it
// about the origin, in the undeformed body. The tolerance is round-off, times the
// condition of some 1e3.
BOOST_AUTO_TEST_CASE(support_carries_the_weight_at_the_centre_of_any_cells) {
  const Vector3 gravity(-10, 0, 0), centre = Vector3::Constant(edge / 2);
  const Vector3 weight = 1000 * std::pow(edge, 3) * gravity;
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = cube(3, pattern, 0.2);
    for (const Element element : elements_on(pattern)) {
      const Solution solution = solve(mesh,
                                      {.material = of_poisson_ratio(0.3),
                                       .plates = {fixed("bottom")},
                                       .gravity = gravity},
                                      {.law = Law::hooke, .element = element});
      Vector3 torque = Vector3::Zero();
      for (std::size_t n = 0; n < mesh.nodes().size(); ++n)
        torque += mesh.nodes()[n].cross(solution.reactions[n]);
      BOOST_TEST((total(solution.reactions) + weight).norm() < 1e-10 * weight.norm());
      BOOST_TEST((torque + centre.cross(weight)).norm() < 1e-10 * weight.norm() * edge);
    }
  }
}

// Equilibrium holds to Newton's 1e-10: Hooke's about the undeformed nodes, that of the
// others about the deformed ones. No force is left on free nodes.
BOOST_AUTO_TEST_CASE(reactions_have_no_net_force_or_torque) {
  const Mesh mesh = cube(3);
  for_all_settings([&](const Settings& settings) {
    const Solution solution = solve(
        mesh, between_plates(of_poisson_ratio(0.3), {0.1 * edge, 0, -0.1 * edge}, 0.4),
        settings);
    BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok), solution.reason);
    BOOST_TEST(
        (solution.lever_arms ==
         (settings.law == Law::hooke ? LeverArms::undeformed : LeverArms::deformed)));
    BOOST_TEST(solution.load_fraction == 1);
    double size_of_forces = 0;
    Vector3 torque = Vector3::Zero();
    for (std::size_t node = 0; node < mesh.nodes().size(); ++node) {
      const double z = mesh.nodes()[node].z();
      if (z > 1e-9 && z < edge - 1e-9) BOOST_TEST(solution.reactions[node].norm() == 0);
      Vector3 arm = mesh.nodes()[node];
      if (solution.lever_arms == LeverArms::deformed) arm += solution.displacements[node];
      torque += arm.cross(solution.reactions[node]);
      size_of_forces += solution.reactions[node].norm();
    }
    BOOST_TEST(size_of_forces > 0);
    BOOST_TEST(total(solution.reactions).norm() < 1e-9 * size_of_forces);
    BOOST_TEST(torque.norm() < 1e-9 * edge * size_of_forces);
    BOOST_TEST(solution.cell_volumes.size() ==
               (settings.element == Element::q2 ? mesh.cells().size() : 0U));
  });
}

// Both plates turn by 100 degrees together. What is left is round-off: 1e-12 of E L^2.
BOOST_AUTO_TEST_CASE(body_is_free_of_force_after_a_rigid_motion) {
  const RigidMotion motion{.translation = Vector3(0.01, -0.02, 0.03),
                           .axis = Vector3(1, 2, -1).normalized(),
                           .centre = Vector3(0.02, 0.01, 0.07),
                           .angle = 100 * std::numbers::pi / 180};
  const Scene scene{.material = of_poisson_ratio(0.3),
                    .plates = {plate("bottom", motion), plate("top", motion)},
                    .gravity = Vector3::Zero()};
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = cube(3, pattern, 0.2);
    for_all_settings(
        [&](const Settings& settings) {
          if (settings.law == Law::hooke) return;
          const Solution solution = solve(mesh, scene, settings);
          BOOST_TEST((solution.status == SolveStatus::ok), solution.reason);
          for (const Vector3& reaction : solution.reactions)
            BOOST_TEST(reaction.norm() < 1e-12 * young * edge * edge);
          for (std::size_t node = 0; node < mesh.nodes().size(); ++node)
            BOOST_TEST((solution.displacements[node] -
                        displacement(motion, mesh.nodes()[node], 1))
                           .norm() < 1e-12);
        },
        pattern);
  }
}

// Without load nothing moves, and a strain of 1e-9 is not taken for none: the reaction is
// Hooke's to first order in the strain. A lattice has Hooke's tensor, but q1_sri and
// q1_nodal take only kappa of it at means, so that they are not the same elements.
BOOST_AUTO_TEST_CASE(all_laws_meet_hookes_at_tiny_strain) {
  const Mesh mesh = cube(2);
  for (const Element element : elements) {
    const auto force = [&](Law law, double strain) {
      const Solution solution =
          solve(mesh, between_plates(of_poisson_ratio(0.3), {0, 0, -strain * edge}),
                {.law = law, .element = element});
      BOOST_TEST((solution.status == SolveStatus::ok));
      return force_on(mesh, "top", solution).z();
    };
    for (const Law law : laws) {
      BOOST_TEST(force(law, 0) == 0);
      if (law == Law::cauchy_born &&
          (element == Element::q1_sri || element == Element::q1_nodal))
        continue;
      BOOST_TEST(force(law, 1e-9) == force(Law::hooke, 1e-9),
                 boost::test_tools::tolerance(1e-7));
    }
  }
}

// A body a thousand times smaller and a million times stiffer, heavier by as much as it
// takes, has the same shape, and forces times 1e6/1e6. Nothing absolute is hidden in the
// solver. The tolerance is Newton's, times the condition.
BOOST_AUTO_TEST_CASE(results_scale_with_units) {
  for_all_settings([&](const Settings& settings) {
    const auto run = [&](double length, double stiffness) {
      const Mesh mesh =
          mapped(cube(2), [&](const Vector3& X) -> Vector3 { return length * X; });
      Scene scene = between_plates({.young_modulus = stiffness * young,
                                    .poisson_ratio = 0.3,
                                    .density = 1000 * stiffness / length},
                                   {0, 0, -0.1 * length * edge});
      scene.gravity = Vector3(-10, 0, 0);
      return solve(mesh, scene, settings);
    };
    const Solution one = run(1, 1), other = run(1e-3, 1e6);
    BOOST_TEST(one.steps == other.steps);
    for (std::size_t n = 0; n < one.displacements.size(); ++n) {
      BOOST_TEST((1e3 * other.displacements[n] - one.displacements[n]).norm() <
                 1e-9 * edge);
      BOOST_TEST((other.reactions[n] - one.reactions[n]).norm() <
                 1e-9 * young * edge * edge);
    }
  });
}

BOOST_AUTO_TEST_CASE(failed_simulations_keep_their_last_state) {
  const Mesh mesh = cube(3);
  const Solution solution =
      solve(mesh, between_plates(of_poisson_ratio(0.25), {0, 0, -1.1 * edge}),
            {.law = Law::st_venant_kirchhoff, .element = Element::q1_sri});
  BOOST_TEST((solution.status == SolveStatus::not_converged));
  BOOST_TEST(!solution.reason.empty());
  for (const NodeIndex node : mesh.region("top").nodes)
    BOOST_TEST(solution.displacements[node].z() == -1.1 * edge * solution.load_fraction,
               boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(lattice_that_pushes_is_refused_with_its_range) {
  const Settings settings{.law = Law::cauchy_born,
                          .element = Element::q1,
                          .lattice = {.springs = Springs::baudet}};
  const auto status = [&](double nu) {
    return solve(cube(1), between_plates(of_poisson_ratio(nu), Vector3::Zero()), settings)
        .status;
  };
  BOOST_TEST((status(-0.3) == SolveStatus::refused));
  BOOST_TEST((status(-0.25) == SolveStatus::refused));
  BOOST_TEST((status(-0.24) == SolveStatus::ok));
}

BOOST_AUTO_TEST_CASE(hooke_beyond_half_a_turn_is_refused) {
  const auto turned = [](double degrees) {
    Scene scene = between_plates(of_poisson_ratio(0.3), Vector3::Zero());
    scene.plates[1].motion.axis = Vector3::UnitZ();
    scene.plates[1].motion.angle = degrees * std::numbers::pi / 180;
    return solve(cube(2), scene, {.law = Law::hooke, .element = Element::q1});
  };
  BOOST_TEST((turned(180).status == SolveStatus::ok));
  const Solution beyond = turned(-181);
  BOOST_TEST((beyond.status == SolveStatus::refused));
  BOOST_TEST(beyond.reason.find("half a turn") != std::string::npos, beyond.reason);
}

BOOST_AUTO_TEST_CASE(triquadratic_elements_on_other_cells_are_refused_with_the_type) {
  const auto reason = [](CellPattern pattern) {
    const Solution solution =
        solve(cube(2, pattern), between_plates(of_poisson_ratio(0.3), Vector3::Zero()),
              {.law = Law::hooke, .element = Element::q2});
    BOOST_TEST((solution.status == SolveStatus::refused));
    BOOST_TEST(solution.displacements.empty());
    return solution.reason;
  };
  BOOST_TEST(reason(CellPattern::prism) ==
             "q2 is for hexahedra; cells of type prism in the mesh: 16");
  BOOST_TEST(reason(CellPattern::pyramid) ==
             "q2 is for hexahedra; cells of type pyramid in the mesh: 48");
  BOOST_TEST(reason(CellPattern::tetrahedron) ==
             "q2 is for hexahedra; cells of type tetrahedron in the mesh: 48");
}

BOOST_AUTO_TEST_CASE(impossible_input_is_refused_by_name) {
  const Mesh mesh = cube(1);
  const auto refused = [&](const std::function<void(Scene&)>& spoil) {
    Scene scene = between_plates(of_poisson_ratio(0.3), Vector3::Zero());
    spoil(scene);
    BOOST_CHECK_THROW(solve(mesh, scene, {.law = Law::hooke, .element = Element::q1}),
                      InputError);
  };
  refused([](Scene& scene) { scene.material.young_modulus = 0; });
  refused([](Scene& scene) { scene.material.young_modulus = std::nan(""); });
  refused([](Scene& scene) { scene.material.poisson_ratio = 0.5; });
  refused([](Scene& scene) { scene.material.poisson_ratio = -1; });
  refused([](Scene& scene) { scene.material.density = 0; });
  refused([](Scene& scene) { scene.plates.clear(); });
  refused([](Scene& scene) { scene.plates[0].region = "nowhere"; });
}

BOOST_AUTO_TEST_SUITE_END()
