#include <fmt/format.h>

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <ostream>

#include "meshing/cell_geometry.hpp"
#include "meshing/generators/generate_block.hpp"
#include "mss/solve.hpp"
#include "tests/mss/blocks.hpp"
#include "tests/referee/figures.hpp"

// The thesis's deformation tests on their own meshes, solved for equilibrium, against the
// referee, another program. Residuals of both are below 1e-8 of the force.

using namespace springcheck;
using namespace springcheck::mss;
namespace data = boost::unit_test::data;

BOOST_AUTO_TEST_SUITE(reference_test)

namespace {

constexpr double degree = std::numbers::pi / 180;
const Block cube_of_5_cm{.size = {0.05, 0.05, 0.05}, .cells = {10, 10, 10}};
const Block small_beam{.size = {0.004, 0.004, 0.024}, .cells = {4, 4, 24}};

struct Measured {
  double volume_change;  // (V - V0)/V0, exact trilinear volumes
  Vector3 force;         // [N] of the upper plate on the body
  double torque;         // [N m] about the axis, arms in the deformed state
};

/// E = 10 kPa between glued plates: the lower one still, the upper one moved.
Measured measured(const Block& block, StiffnessForm form, double nu,
                  const RigidMotion& upper) {
  const Mesh mesh = generate_block(block);
  const Scene scene{
      .material = {.young_modulus = 1e4, .poisson_ratio = nu, .density = 1000},
      .plates = {{"bottom", translation(Vector3::Zero()), all_components},
                 {"top", upper, all_components}},
      .gravity = Vector3::Zero()};
  const Settings settings{
      .network = {.model = SpringModel::cf, .stiffness_form = form, .diagonal_ratio = 1},
      .dynamics = {}};
  const Solution solution = solve(mesh, scene, settings);
  BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok), solution.reason);

  const std::vector<Vector3> x = sum(mesh.nodes(), solution.displacements);
  const std::vector<double> volumes = cell_volumes(mesh.cells(), x);
  const double volume = std::reduce(volumes.begin(), volumes.end());
  Measured result{.volume_change = (volume - mesh.volume()) / mesh.volume(),
                  .force = Vector3::Zero(),
                  .torque = 0};
  for (const NodeIndex node : mesh.region("top").nodes) {
    const Vector3& reaction = solution.reactions[node];
    const Vector3 arm = x[node] - upper.centre - upper.translation;
    result.force += reaction;
    result.torque += arm.cross(reaction).dot(upper.axis);
  }
  return result;
}

RigidMotion twist(double angle) {
  return {.translation = Vector3::Zero(),
          .axis = Vector3::UnitZ(),
          .centre = {0.025, 0.025, 0.05},
          .angle = angle};
}

constexpr auto mu_form = StiffnessForm::shear_modulus;
constexpr auto E_form = StiffnessForm::young_modulus;

struct Row {
  std::string test;
  const Block& block;
  StiffnessForm form;
  double nu;
  double amount;  // of the height, or degrees

  [[nodiscard]] std::string name() const {
    return fmt::format("{} {} mss-cf {} nu {}", test, amount,
                       form == mu_form ? "mu" : "E", nu);
  }
  [[nodiscard]] RigidMotion upper() const {
    const double way = amount * block.size[2];
    if (test == "compression") return translation({0, 0, -way});
    if (test == "tension") return translation({0, 0, way});
    if (test == "shearing") return translation({way, 0, 0});
    return twist(amount * degree);
  }
};
std::ostream& operator<<(std::ostream& out, const Row& row) {
  return out << row.name();
}
const Row plate_rows[] = {{"compression", cube_of_5_cm, mu_form, 0, 0.05},
                          {"compression", cube_of_5_cm, mu_form, 0, 0.2},
                          {"compression", cube_of_5_cm, mu_form, 0.25, 0.05},
                          {"compression", cube_of_5_cm, mu_form, 0.25, 0.2},
                          {"compression", cube_of_5_cm, mu_form, 0.499, 0.05},
                          {"compression", cube_of_5_cm, mu_form, 0.499, 0.2},
                          {"compression", cube_of_5_cm, E_form, 0, 0.05},
                          {"compression", cube_of_5_cm, E_form, 0, 0.2},
                          {"tension", small_beam, mu_form, 0, 0.05},
                          {"tension", small_beam, mu_form, 0.25, 0.05},
                          {"tension", small_beam, mu_form, 0.25, 0.2},
                          {"tension", small_beam, mu_form, 0.499, 0.05},
                          {"tension", small_beam, mu_form, 0.499, 0.2},
                          {"shearing", cube_of_5_cm, mu_form, 0.25, 0.05},
                          {"shearing", cube_of_5_cm, mu_form, 0.25, 0.2},
                          {"torsion", cube_of_5_cm, mu_form, 0.25, 1},
                          {"torsion", cube_of_5_cm, mu_form, 0.25, 45}};

/// Beams whose state is one of a kind: mss-nfd at 2 MPa, and on the finer cells,
/// wrinkles, and which wrinkle is found moves the tip.
struct Beam {
  const char* model;
  SpringModel springs;
  double young_modulus;
  int cells_across;
};
std::ostream& operator<<(std::ostream& out, const Beam& row) {
  return out << row.cells_across << " across " << row.model << " E " << row.young_modulus;
}
const Beam coarse_beams[] = {{"mss-cf", SpringModel::cf, 10e6, 4},
                             {"mss-cf", SpringModel::cf, 2e6, 4},
                             {"mss-nfd", SpringModel::nfd, 10e6, 4}};
const Beam fine_beams[] = {{"mss-cf", SpringModel::cf, 10e6, 8},
                           {"mss-cf", SpringModel::cf, 2e6, 8}};

/// Tip drop of 0.4 x 0.4 x 2.4 m, clamped at z = 0, under its weight along -x, g = 10.
double tip_drop(const Beam& beam) {
  const int across = beam.cells_across;
  const Mesh mesh =
      generate_block({.size = {0.4, 0.4, 2.4}, .cells = {across, across, 6 * across}});
  const Scene scene{.material = {.young_modulus = beam.young_modulus,
                                 .poisson_ratio = 0.25,
                                 .density = 1000},
                    .plates = {{"bottom", translation(Vector3::Zero()), all_components}},
                    .gravity = {-10, 0, 0}};
  const Settings settings{.network = in_shear_modulus_form(beam.springs), .dynamics = {}};
  const Solution solution = solve(mesh, scene, settings);
  BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok), solution.reason);
  // The middle of the end face, which is the last layer of nodes.
  const auto layer = static_cast<std::size_t>((across + 1) * (across + 1));
  return -solution.displacements[mesh.nodes().size() - 1 - layer / 2].x();
}

void check_drop(const Beam& beam) {
  std::ostringstream name;
  name << beam;
  BOOST_TEST(tip_drop(beam) == referee::figure("bending", name.str(), "drop"),
             boost::test_tools::tolerance(1e-7));
}

}  // namespace

BOOST_DATA_TEST_CASE(plate_and_volume_are_the_referee_s, data::make(plate_rows), row) {
  const auto figure = [&](const char* quantity) {
    return referee::figure("plates", row.name(), quantity);
  };
  const auto tolerance = boost::test_tools::tolerance(1e-7);
  const Measured result = measured(row.block, row.form, row.nu, row.upper());
  BOOST_TEST(result.volume_change == figure("volume change"), tolerance);
  if (row.test == "torsion") {
    BOOST_TEST(result.torque == figure("torque"), tolerance);
    return;
  }
  const double along = row.test == "shearing" ? result.force.x() : result.force.z();
  BOOST_TEST(std::abs(along) == figure("force"), tolerance);
  BOOST_TEST(result.force.norm() == figure("norm of force"), tolerance);
}

BOOST_DATA_TEST_CASE(coarse_beam_drops_as_the_referee_s, data::make(coarse_beams), row) {
  check_drop(row);
}

BOOST_TEST_DECORATOR(*boost::unit_test::label("slow"))
BOOST_DATA_TEST_CASE(fine_beam_drops_as_the_referee_s, data::make(fine_beams), row) {
  check_drop(row);
}

BOOST_AUTO_TEST_SUITE_END()
