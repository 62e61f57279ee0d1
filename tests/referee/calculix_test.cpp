#include "tests/referee/calculix.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/own_folder.hpp"
#include "tests/referee/figures.hpp"

BOOST_AUTO_TEST_SUITE(calculix_test)

// CalculiX solves what springcheck solves, on the mesh that `springcheck mesh` writes,
// with its own elements (C3D8: trilinear, 2x2x2 points, like q1), its own Newton
// iterations and its own linear solver. The program's path is in the environment
// variable SPRINGCHECK.

namespace {

namespace fs = std::filesystem;
using namespace referee;
using springcheck::OwnFolder;
using Json = nlohmann::json;

// CalculiX prints seven significant digits, so that a number is off by 5e-7 of itself at
// most. The two solvers take their residuals to 1e-9 and below.
//
// Force: 5e-7 and as much again.
constexpr double force_tolerance = 1e-6;  // relative
// Volume: a side that is off by d changes a body of width w by d/w of its volume. The
// plates stand where they were told; the four free sides move by less than a quarter of
// the width (shearing by 20 %: .24), which makes 4 * .25 * 5e-7 even if all nodes of a
// side were rounded the same way. As they are not, what is seen is below 1e-8.
constexpr double volume_tolerance = 5e-7;  // of V0

/// Runs the program and returns what it printed.
std::string springcheck(const OwnFolder& folder, const std::string& arguments) {
  const char* program = std::getenv("SPRINGCHECK");
  if (!program) throw std::runtime_error("SPRINGCHECK is not set");
  const fs::path out = folder / "springcheck.out";
  const std::string command =
      fmt::format("{} {} >'{}' 2>/dev/null </dev/null", program, arguments, out.string());
  if (std::system(command.c_str()) != 0)
    throw std::runtime_error("failed: springcheck " + arguments);
  std::ostringstream text;
  text << std::ifstream(out).rdbuf();
  return text.str();
}

struct Case {
  const char* scene;
  double nu;
  double deformation;
  const char* mesh;
};

/// The meshes of a comparison.
struct Meshes {
  const char *cube, *thin_beam;
};

constexpr Meshes coarse{.cube = "--cells 6,6,6", .thin_beam = "--cells 3,3,18"};
constexpr Meshes fine{.cube = "--cells 10,10,10", .thin_beam = "--cells 4,4,24"};
// No two sizes and no two counts alike, and coordinates of many digits.
constexpr const char* uneven = "--size 0.05,0.04,0.06 --cells 7,6,9";

constexpr double young_modulus = 1e4;  // [Pa] of the scenes

struct Measured {
  double plate_force;       // along the motion [N]
  double plate_force_norm;  // length of the resultant [N]
  double volume_change;     // (V - V0)/V0
};

Measured by_springcheck(const OwnFolder& folder, const Case& c, const std::string& law) {
  const Json json = Json::parse(springcheck(
      folder, fmt::format("run {0} --method {1} --element q1 --reference {1}:q1 --nu {2} "
                          "--deformation {3} {4} --json",
                          c.scene, law, c.nu, c.deformation, c.mesh)));
  const Json& result = json["results"][0];
  BOOST_TEST_REQUIRE(result["status"] == "ok");
  return {.plate_force = result["plate_force"],
          .plate_force_norm = result["plate_force_norm"],
          .volume_change = result["volume_change"]};
}

Measured by_calculix(const OwnFolder& folder, const Case& c, Kinematics kinematics,
                     double modulus) {
  const fs::path file = folder / "mesh.inp";
  springcheck(folder,
              fmt::format("mesh {} {} --out '{}'", c.scene, c.mesh, file.string()));
  const InpMesh mesh = read_inp(file);
  double height = 0;
  for (const Vector3& x : mesh.nodes) height = std::max(height, x.z());
  const std::string scene = c.scene;
  const Vector3 direction = scene == "compression" ? Vector3(0, 0, -1)
                            : scene == "tension"   ? Vector3(0, 0, 1)
                                                   : Vector3(1, 0, 0);
  const Equilibrium equilibrium = solve(
      file,
      {.kinematics = kinematics,
       .young_modulus = modulus,
       .poisson_ratio = c.nu,
       .held = {{"bottom", Vector3::Zero()}, {"top", c.deformation * height * direction}},
       .pressures = {},
       .reaction_of = "top"});
  std::vector<Vector3> positions = mesh.nodes;
  for (std::size_t n = 0; n < positions.size(); ++n)
    positions[n] += equilibrium.displacements[n];
  const double rest_volume = volume(mesh, mesh.nodes);
  return {.plate_force = equilibrium.reaction.dot(direction),
          .plate_force_norm = equilibrium.reaction.norm(),
          .volume_change = (volume(mesh, positions) - rest_volume) / rest_volume};
}

void compare(const Case& c, const std::string& law, Kinematics kinematics) {
  BOOST_TEST_CONTEXT(
      fmt::format("{} {} {} nu {} {}", law, c.scene, c.deformation, c.nu, c.mesh)) {
    const OwnFolder folder;
    const Measured ours = by_springcheck(folder, c, law);
    const Measured theirs = by_calculix(folder, c, kinematics, young_modulus);
    BOOST_TEST(ours.plate_force == theirs.plate_force,
               boost::test_tools::tolerance(force_tolerance));
    BOOST_TEST(ours.plate_force_norm == theirs.plate_force_norm,
               boost::test_tools::tolerance(force_tolerance));
    BOOST_TEST(std::abs(ours.volume_change - theirs.volume_change) < volume_tolerance,
               "volume changes " << ours.volume_change << ", " << theirs.volume_change);
    BOOST_TEST_MESSAGE(fmt::format(
        "{:10} {:11} {:4} nu {:5}: force {:.6e} N, {:+.1e} of it from CalculiX; norm "
        "{:+.1e}; volume change {:+.7f}, {:+.1e} from CalculiX",
        law, c.scene, c.deformation, c.nu, ours.plate_force,
        ours.plate_force / theirs.plate_force - 1,
        ours.plate_force_norm / theirs.plate_force_norm - 1, ours.volume_change,
        ours.volume_change - theirs.volume_change));
  }
}

void compare_hooke(const Meshes& on) {
  for (const Case& c : std::initializer_list<Case>{{"compression", 0.25, 0.05, on.cube},
                                                   {"compression", 0.499, 0.05, on.cube},
                                                   {"tension", 0.25, 0.05, on.thin_beam},
                                                   {"tension", 0.499, 0.05, on.thin_beam},
                                                   {"shearing", 0.25, 0.05, on.cube},
                                                   {"shearing", 0.499, 0.05, on.cube},
                                                   {"shearing", 0, 0.20, uneven}})
    compare(c, "fem-hooke", Kinematics::linear);
}

/// Compression by 20 % at nu = .499 is left out: springcheck finds that state unstable.
void compare_st_venant(const Meshes& on) {
  for (const Case& c : std::initializer_list<Case>{{"compression", 0.25, 0.05, on.cube},
                                                   {"compression", 0.25, 0.20, on.cube},
                                                   {"compression", 0.499, 0.05, on.cube},
                                                   {"tension", 0.25, 0.05, on.thin_beam},
                                                   {"tension", 0.25, 0.20, on.thin_beam},
                                                   {"tension", 0.499, 0.20, on.thin_beam},
                                                   {"shearing", 0.25, 0.05, on.cube},
                                                   {"shearing", 0.25, 0.20, on.cube},
                                                   {"shearing", 0.499, 0.20, on.cube},
                                                   {"compression", 0.4, 0.10, uneven}})
    compare(c, "fem-stvk", Kinematics::nlgeom);
}

}  // namespace

BOOST_AUTO_TEST_CASE(hooke_agrees_with_calculix) {
  compare_hooke(coarse);
}

BOOST_AUTO_TEST_CASE(st_venant_agrees_with_calculix) {
  compare_st_venant(coarse);
}

BOOST_AUTO_TEST_CASE(they_agree_on_finer_meshes, *boost::unit_test::label("slow")) {
  compare_hooke(fine);
  compare_st_venant(fine);
}

// The comparison is worth something only if it sees a small slip: 3e-6 of the modulus.
BOOST_AUTO_TEST_CASE(a_slip_in_the_material_is_seen) {
  const OwnFolder folder;
  const Case c{"compression", 0.25, 0.05, fine.cube};
  const double ours = by_springcheck(folder, c, "fem-hooke").plate_force;
  const double slipped =
      by_calculix(folder, c, Kinematics::linear, (1 + 3e-6) * young_modulus).plate_force;
  BOOST_TEST(std::abs(slipped / ours - 1) > force_tolerance);
}

/// Force of the second program's q1 in compression at nu = .25.
double by_the_second_program(const std::string& law, const std::string& strain) {
  for (const Row& row : rows("elements"))
    if (row.text("test") == "compression" && row.text("amount") == strain &&
        row.text("law") == law && row.text("element") == "q1" &&
        row.text("nu") == "0.25" && row.text("quantity") == "force")
      return row.number("value");
  throw std::runtime_error("no such row");
}

// Three programs agree.
BOOST_AUTO_TEST_CASE(calculix_gives_the_second_program_s_figures,
                     *boost::unit_test::tolerance(force_tolerance)) {
  const OwnFolder folder;
  const double hooke = by_calculix(folder, {"compression", 0.25, 0.05, fine.cube},
                                   Kinematics::linear, young_modulus)
                           .plate_force;
  BOOST_TEST(hooke == by_the_second_program("hooke", "0.05"));
  const double st_venant = by_calculix(folder, {"compression", 0.25, 0.20, fine.cube},
                                       Kinematics::nlgeom, young_modulus)
                               .plate_force;
  BOOST_TEST(st_venant == by_the_second_program("stvk", "0.2"));
}

// A pressure p on a surface of area A is carried by the opposite side: p A inwards on the
// body, p A outwards from the support, whatever the material. Seven digits.
BOOST_AUTO_TEST_CASE(every_surface_of_the_mesh_file_takes_a_pressure) {
  const double x = 0.05, y = 0.04, z = 0.06, pressure = 100;  // m, m, m, Pa
  struct Side {
    const char *surface, *held;
    Vector3 outward_area;  // [m^2]
  };
  for (const Side& side : {Side{"bottom", "top", {0, 0, -x * y}},
                           {"top", "bottom", {0, 0, x * y}},
                           {"y_min", "y_max", {0, -x * z, 0}},
                           {"y_max", "y_min", {0, x * z, 0}},
                           {"x_min", "x_max", {-y * z, 0, 0}},
                           {"x_max", "x_min", {y * z, 0, 0}}}) {
    const OwnFolder folder;
    const fs::path file = folder / "mesh.inp";
    springcheck(folder, fmt::format("mesh compression --size {},{},{} --cells 3,2,4 "
                                    "--out '{}'",
                                    x, y, z, file.string()));
    const Equilibrium equilibrium = solve(file, {.kinematics = Kinematics::linear,
                                                 .young_modulus = young_modulus,
                                                 .poisson_ratio = 0.25,
                                                 .held = {{side.held, Vector3::Zero()}},
                                                 .pressures = {{side.surface, pressure}},
                                                 .reaction_of = side.held});
    const Vector3 expected = pressure * side.outward_area;
    BOOST_TEST((equilibrium.reaction - expected).norm() < 1e-6 * expected.norm(),
               side.surface << ": " << equilibrium.reaction.transpose());
  }
}

BOOST_AUTO_TEST_CASE(a_missing_calculix_is_named) {
  const OwnFolder folder;
  const fs::path file = folder / "mesh.inp";
  springcheck(folder,
              fmt::format("mesh compression --cells 1,1,2 --out '{}'", file.string()));
  const Problem problem{.kinematics = Kinematics::linear,
                        .young_modulus = young_modulus,
                        .poisson_ratio = 0.25,
                        .held = {{"bottom", Vector3::Zero()}},
                        .pressures = {},
                        .reaction_of = "bottom"};
  BOOST_CHECK_EXCEPTION(solve(file, problem, "no-such-ccx"), std::runtime_error,
                        [](const std::runtime_error& error) {
                          return std::string(error.what()).find("calculix-ccx") !=
                                 std::string::npos;
                        });
}

// Here it stops at a set that the mesh file does not have.
BOOST_AUTO_TEST_CASE(a_failed_calculix_is_a_failure) {
  const OwnFolder folder;
  const fs::path file = folder / "mesh.inp";
  springcheck(folder,
              fmt::format("mesh compression --cells 1,1,2 --out '{}'", file.string()));
  const Problem problem{.kinematics = Kinematics::linear,
                        .young_modulus = young_modulus,
                        .poisson_ratio = 0.25,
                        .held = {{"no_such_set", Vector3::Zero()}},
                        .pressures = {},
                        .reaction_of = "bottom"};
  BOOST_CHECK_THROW(solve(file, problem), std::runtime_error);
}

BOOST_AUTO_TEST_SUITE_END()
