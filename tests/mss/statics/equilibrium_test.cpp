#include "mss/statics/equilibrium.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "meshing/generators/generate_block.hpp"
#include "mss/forces/forces.hpp"
#include "mss/solve.hpp"
#include "tests/mss/blocks.hpp"
#include "tests/mss/path_limits.hpp"
#include "tests/referee/figures.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(equilibrium_test)

namespace {

constexpr double edge = 0.005;  // [m] of a cell; blocks of 4^3
constexpr double degree = std::numbers::pi / 180;

Scene between_plates(double nu, const RigidMotion& lower, const RigidMotion& upper) {
  return {.material = {.young_modulus = 1e4, .poisson_ratio = nu, .density = 1000},
          .plates = {{"bottom", lower, all_components}, {"top", upper, all_components}},
          .gravity = Vector3::Zero()};
}

Scene compression(double nu, double strain) {
  return between_plates(nu, translation(Vector3::Zero()),
                        translation({0, 0, -strain * 4 * edge}));
}

/// Rotation about an axis that is none of the lattice's, through a point off the block.
RigidMotion rotation(double angle) {
  return {.translation = Vector3::Zero(),
          .axis = Vector3(2, 1, 2) / 3,
          .centre = {0.01, -0.02, 0.03},
          .angle = angle};
}

struct Case {
  Mesh mesh;
  Scene scene;
  Network network;
  Solution solution;
};

Case solved(const Scene& scene, const NetworkSettings& settings, unsigned seed = 1) {
  const Mesh mesh = cube(4, edge);
  const Network network = build_network(mesh, scene.material, settings);
  return {mesh, scene, network, find_equilibrium(mesh, scene, network, {.seed = seed})};
}

Case solved(const Scene& scene, SpringModel model, unsigned seed = 1) {
  return solved(scene, in_shear_modulus_form(model), seed);
}

std::vector<Vector3> difference(std::vector<Vector3> a, const std::vector<Vector3>& b) {
  for (std::size_t n = 0; n < a.size(); ++n) a[n] -= b[n];
  return a;
}

// Positions of a state whose residual is below 1e-10 are good to about 1e-10 of the
// imposed displacement, times the condition of the tangent (about 100): 1e-8 of it.
constexpr double position_tolerance = 1e-8;

}  // namespace

// Every node's force is computed again: those on free nodes are below the solver's own
// bound of 1e-10 of the norm of all of them.
BOOST_AUTO_TEST_CASE(free_nodes_are_in_balance_to_the_bound_the_solver_states) {
  for (const auto& [name, model] : models_on_cubes)
    for (const double nu : {0., 0.25, 0.45}) {
      const Case c = solved(compression(nu, 0.01), model);
      BOOST_TEST((c.solution.status == SolveStatus::ok),
                 name << ": " << c.solution.reason);
      BOOST_TEST(c.solution.load_fraction == 1);
      const auto x = sum(c.mesh.nodes(), c.solution.displacements);
      std::vector<Vector3> forces(x.size());
      nodal_forces(c.network, x, forces);
      BOOST_TEST(norm(sum(forces, c.solution.reactions)) < 1e-10 * norm(forces), name);
      BOOST_TEST(c.solution.strain_energy == strain_energy(c.network, x), name);
      for (const PrescribedComponent& held : prescribed_components(c.mesh, c.scene)) {
        const double imposed = prescribed_displacement(c.mesh, c.scene, held, 1);
        // x - X of lengths of 2 cm has round-off
        BOOST_TEST(std::abs(c.solution.displacements[held.node][held.component] -
                            imposed) < 1e-17);
      }
    }
}

// The error is bounded by the residual, 1e-10 of the forces.
BOOST_AUTO_TEST_CASE(reactions_carry_the_weight) {
  Scene scene = compression(0.3, 0.05);
  scene.gravity = {3, 0, -10};
  const Case c = solved(scene, SpringModel::cf);
  const Vector3 weight = 1000 * std::pow(4 * edge, 3) * scene.gravity;
  BOOST_TEST((total(c.solution.reactions) + weight).norm() <
             1e-9 * norm(c.solution.reactions));
  for (NodeIndex n = 0; n < c.mesh.nodes().size(); ++n) {
    const double z = c.mesh.nodes()[n].z();
    if (z > 0 && z < 4 * edge) BOOST_TEST(c.solution.reactions[n].norm() == 0);
  }
}

BOOST_AUTO_TEST_CASE(compressed_block_stays_symmetric) {
  const Case c = solved(compression(0.3, 0.1), SpringModel::cf);
  const auto u = [&](int i, int j, int k) {
    return c.solution.displacements[static_cast<std::size_t>(i + 5 * (j + 5 * k))];
  };
  constexpr double close = position_tolerance * 0.1 * 4 * edge;
  for (int k = 0; k <= 4; ++k)
    for (int j = 0; j <= 4; ++j)
      for (int i = 0; i <= 4; ++i) {
        const Vector3 here = u(i, j, k);
        const Vector3 mirrored = u(4 - i, j, k), turned = u(j, i, k);
        BOOST_TEST((here - Vector3(-mirrored.x(), mirrored.y(), mirrored.z())).norm() <
                   close);
        BOOST_TEST((here - Vector3(turned.y(), turned.x(), turned.z())).norm() < close);
      }
}

// Both plates turn alike, and the body follows without strain. The tolerance is round-off
// of the positions (1e-17 m) times the stiffness (50 N/m).
BOOST_AUTO_TEST_CASE(body_follows_a_rigid_rotation_of_both_plates_without_force) {
  for (const auto& [name, model] : models_on_cubes) {
    const Case c =
        solved(between_plates(0.4, rotation(40 * degree), rotation(40 * degree)), model);
    BOOST_TEST((c.solution.status == SolveStatus::ok), name << ": " << c.solution.reason);
    BOOST_TEST(norm(c.solution.reactions) < 1e-12, name);
    std::vector<Vector3> rigid;
    for (const Vector3& X : c.mesh.nodes())
      rigid.push_back(displacement(rotation(40 * degree), X, 1));
    BOOST_TEST(norm(difference(c.solution.displacements, rigid)) < 1e-12, name);
  }
}

// At the smallest strain the plate moves by 2e-11 m, of which rounding of the positions
// takes about 1e-7; at the largest the curvature of the force takes about 1e-4.
BOOST_AUTO_TEST_CASE(force_is_proportional_to_a_tiny_load) {
  const auto stiffness = [](double strain) {
    const Case c = solved(compression(0.4, strain), SpringModel::cf);
    BOOST_TEST((c.solution.status == SolveStatus::ok), c.solution.reason);
    double force = 0;
    for (const NodeIndex node : c.mesh.region("top").nodes)
      force -= c.solution.reactions[node].z();
    return force / strain;
  };
  BOOST_TEST(stiffness(1e-9) == stiffness(1e-7), boost::test_tools::tolerance(1e-5));
  for (const double strain : {1e-4, 1e-5, 1e-6})
    BOOST_TEST(stiffness(1e-7) == stiffness(strain), boost::test_tools::tolerance(1e-3));
}

// At such strains the energy's round-off is larger than what the last Newton step gains;
// a line search that believed it would go on for tens of steps.
BOOST_AUTO_TEST_CASE(tiny_load_is_not_lost_in_round_off) {
  for (const double nu : {0., 0.25, 0.499})
    for (const double strain : {3e-6, 1e-6, 3e-7, 1e-7}) {
      const double way = strain * 4 * edge;
      const RigidMotion upper{.translation = {way, 0, -way},
                              .axis = Vector3::UnitZ(),
                              .centre = {2 * edge, 2 * edge, 4 * edge},
                              .angle = strain};
      const Case c = solved(between_plates(nu, translation(Vector3::Zero()), upper),
                            SpringModel::cf);
      BOOST_TEST((c.solution.status == SolveStatus::ok), c.solution.reason);
      BOOST_TEST(c.solution.force_evaluations <= 6, "nu = " << nu << ", " << strain);
    }
}

// The end state does not depend on the way: pushed straight down, and pushed down while
// everything turns, are the same but for the turn.
BOOST_AUTO_TEST_CASE(equilibrium_turns_with_its_plates) {
  const Scene straight = compression(0.4, 0.1);
  const RigidMotion turn = rotation(30 * degree);
  const Eigen::Matrix3d R = Eigen::AngleAxisd(turn.angle, turn.axis).toRotationMatrix();
  RigidMotion upper = turn;
  upper.translation = R * straight.plates[1].motion.translation;

  const Case a = solved(straight, SpringModel::cf);
  const Case b = solved(between_plates(0.4, turn, upper), SpringModel::cf);
  std::vector<Vector3> expected, expected_reactions;
  for (std::size_t n = 0; n < a.mesh.nodes().size(); ++n) {
    const Vector3& X = a.mesh.nodes()[n];
    const Vector3 turned = displacement(turn, X + a.solution.displacements[n], 1);
    expected.push_back(a.solution.displacements[n] + turned);
    expected_reactions.push_back(R * a.solution.reactions[n]);
  }
  BOOST_TEST(norm(difference(b.solution.displacements, expected)) <
             position_tolerance * 0.1 * 4 * edge);
  BOOST_TEST(norm(difference(b.solution.reactions, expected_reactions)) <
             1e-8 * norm(a.solution.reactions));
}

BOOST_AUTO_TEST_CASE(stable_equilibrium_does_not_depend_on_the_seed) {
  const Scene scene = compression(0.45, 0.2);
  const Case a = solved(scene, SpringModel::cf, 1), b = solved(scene, SpringModel::cf, 2);
  BOOST_TEST(norm(difference(a.solution.displacements, b.solution.displacements)) <
             position_tolerance * 0.2 * 4 * edge);
}

// Springs and correction alike: forces double where positions stay. In powers of two
// every operation keeps its digits.
BOOST_AUTO_TEST_CASE(doubled_constants_double_the_force_and_move_nothing) {
  const auto scaled = [](double factor) {
    return solved(compression(0.25, 0.1), custom({.edge = factor * 20,
                                                  .face_diagonal = factor * 8,
                                                  .inner_diagonal = factor * 7},
                                                 factor * 5e3));
  };
  const Case one = scaled(1), two = scaled(2);
  BOOST_TEST((one.solution.status == SolveStatus::ok), one.solution.reason);
  const double way = 0.1 * 4 * edge;
  for (std::size_t n = 0; n < one.mesh.nodes().size(); ++n) {
    const Vector3 &u = one.solution.displacements[n], &r = one.solution.reactions[n];
    BOOST_TEST((two.solution.displacements[n] - u).norm() < 1e-12 * way);
    BOOST_TEST((two.solution.reactions[n] - 2 * r).norm() <
               1e-12 * norm(two.solution.reactions));
  }
  BOOST_TEST(two.solution.strain_energy == 2 * one.solution.strain_energy,
             boost::test_tools::tolerance(1e-12));
}

// The plate's force is the slope of the energy it puts in. It is a central difference
// with a step of 1e-3 of the strain: truncation is 1e-6, times the curvature of the
// force.
BOOST_AUTO_TEST_CASE(plate_force_is_the_slope_of_the_energy) {
  constexpr double step = 1e-4;
  const auto energy = [](double strain) {
    return solved(compression(0.4, strain), SpringModel::cf).solution.strain_energy;
  };
  const Case c = solved(compression(0.4, 0.1), SpringModel::cf);
  double force = 0;
  for (const NodeIndex node : c.mesh.region("top").nodes)
    force -= c.solution.reactions[node].z();
  const double slope = (energy(0.1 + step) - energy(0.1 - step)) / (2 * step * 4 * edge);
  BOOST_TEST(force == slope, boost::test_tools::tolerance(1e-5));
}

// mss-nfd loses its straight state at 1.5 % (path_limit_test, 10^3 cells): beyond, the
// solver must have left it for a minimum of lower energy.
BOOST_AUTO_TEST_CASE(unstable_straight_state_is_left_for_a_minimum) {
  const Case c = solved(compression(0.25, 0.1), SpringModel::nfd);
  BOOST_TEST((c.solution.status == SolveStatus::ok), c.solution.reason);
  BOOST_TEST(!c.solution.definite_up_to.has_value());  // a minimum at every step
  const auto u = [&](int i, int j, int k) {
    return c.solution.displacements[static_cast<std::size_t>(i + 5 * (j + 5 * k))];
  };
  double asymmetry = 0;
  for (int k = 0; k <= 4; ++k)
    for (int i = 0; i <= 4; ++i)
      asymmetry = std::max(asymmetry, std::abs(u(i, 0, k).y() + u(i, 4, k).y()));
  BOOST_TEST(asymmetry > 0.01 * edge);
}

// Mss-cf in tension at nu = 0 has no equilibrium beyond 17.5 % strain. We follow the load
// in steps of 1/1024 of 20 %, .02 %, and end up to three of them short of the last.
BOOST_AUTO_TEST_CASE(tension_without_equilibrium_ends_where_it_is_lost) {
  const Mesh mesh = generate_block({.size = {0.004, 0.004, 0.024}, .cells = {4, 4, 24}});
  Scene scene =
      between_plates(0, translation(Vector3::Zero()), translation({0, 0, 0.2 * 0.024}));
  const Network network =
      build_network(mesh, scene.material, in_shear_modulus_form(SpringModel::cf));
  const Solution solution = find_equilibrium(mesh, scene, network);
  BOOST_TEST((solution.status == SolveStatus::no_equilibrium));
  BOOST_TEST(std::abs(.2 * solution.load_fraction -
                      referee::figure("paths", "tension mss-cf nu 0 no equilibrium",
                                      "strain")) < 6e-4,
             20 * solution.load_fraction << " %");
  BOOST_TEST(solution.displacements.size() == mesh.nodes().size());  // the last state
  BOOST_TEST(solution.definite_up_to.value() == solution.load_fraction);
  BOOST_TEST(solution.reason.find("no equilibrium found") == 0U);
}

// The nodes of a plate that turned by 370 degrees lie where 10 would bring them, and the
// springs have an equilibrium there, on another branch. The path ends where definiteness
// is lost, found by a follower that never leaves it (to .1 % of its load); ours goes in
// steps of 1/1024 of 370 degrees.
BOOST_AUTO_TEST_CASE(a_turn_beyond_the_end_of_the_path_is_not_one_less_a_turn) {
  const Mesh mesh = cube(3, edge);
  const Vector3 centre(1.5 * edge, 1.5 * edge, 3 * edge);
  const auto ends = [&](SpringModel model, double degrees) {
    const Scene scene = between_plates(.25, translation(Vector3::Zero()),
                                       {.translation = Vector3::Zero(),
                                        .axis = Vector3::UnitZ(),
                                        .centre = centre,
                                        .angle = degrees * degree});
    const Network network =
        build_network(mesh, scene.material, in_shear_modulus_form(model));
    const Solution solution = find_equilibrium(mesh, scene, network);
    BOOST_TEST((solution.status == SolveStatus::no_equilibrium), solution.reason);
    BOOST_TEST(solution.reason.find("another branch") != std::string::npos);
    BOOST_TEST(solution.definite_up_to.value() == solution.load_fraction);
    const statics::PathLimit limit = limit_of(mesh, scene, network, .001);
    BOOST_TEST(solution.load_fraction == limit.load_fraction,
               boost::test_tools::tolerance(.005));
    return degrees * solution.load_fraction;
  };
  for (const SpringModel model : {SpringModel::cf, SpringModel::affine})
    BOOST_TEST(ends(model, 370) == ends(model, 160), boost::test_tools::tolerance(.005));
}

// Two layers of cells have a stable path on which the nodes between them meet at the axis
// at half a turn, without a cell turned inside out, and part again twisted the other way.
// Three in squared lengths go inside out at some 155 degrees, and at 370 are whole again,
// twisted by 10.
BOOST_AUTO_TEST_CASE(a_path_on_which_layers_lose_their_turn_ends_there) {
  const auto solved_at = [&](int layers, StrainMeasure strain_measure, double degrees) {
    const Mesh mesh = generate_block({.size = {.05, .05, .05}, .cells = {2, 2, layers}});
    const Scene scene = between_plates(.25, translation(Vector3::Zero()),
                                       {.translation = Vector3::Zero(),
                                        .axis = Vector3::UnitZ(),
                                        .centre = {.025, .025, .05},
                                        .angle = degrees * degree});
    NetworkSettings settings = in_shear_modulus_form(SpringModel::cf);
    settings.strain_measure = strain_measure;
    return find_equilibrium(mesh, scene, build_network(mesh, scene.material, settings));
  };
  const auto check_end = [&](const Solution& solution, double part) {
    BOOST_TEST((solution.status == SolveStatus::no_equilibrium), solution.reason);
    BOOST_TEST(solution.reason.find("not turned as its plates are") != std::string::npos,
               solution.reason);
    BOOST_TEST(solution.load_fraction == part, boost::test_tools::tolerance(.005));
  };
  check_end(solved_at(2, StrainMeasure::engineering, 190), 180. / 190);
  check_end(solved_at(2, StrainMeasure::engineering, -370), 180. / 370);
  const Solution less = solved_at(2, StrainMeasure::engineering, 170);
  BOOST_TEST((less.status == SolveStatus::ok), less.reason);
  const Solution whole_turn = solved_at(3, StrainMeasure::green, 370);
  BOOST_TEST((whole_turn.status == SolveStatus::no_equilibrium), whole_turn.reason);
  // Where a cell is inside out at the full load, its measures tell it. (At 170 degrees
  // rounding decides whether the turn is still there.)
  const Solution inside_out = solved_at(3, StrainMeasure::green, 160);
  BOOST_TEST((inside_out.status == SolveStatus::ok), inside_out.reason);
}

BOOST_AUTO_TEST_CASE(method_that_does_not_cover_the_material_is_refused) {
  const Settings settings{.network = in_shear_modulus_form(SpringModel::baudet),
                          .dynamics = {}};
  const Solution solution = solve(cube(2, edge), compression(-0.3, 0.01), settings);
  BOOST_TEST((solution.status == SolveStatus::refused));
  BOOST_TEST(solution.displacements.empty());
  BOOST_TEST(solution.reason.find("mss-baudet covers nu") == 0U);
}

BOOST_AUTO_TEST_SUITE_END()
