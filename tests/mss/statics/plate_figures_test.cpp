#include <boost/test/unit_test.hpp>
#include <cmath>

#include "meshing/generators/generate_block.hpp"
#include "mss/statics/equilibrium.hpp"
#include "tests/mss/any_cells.hpp"

// Plate forces and torques at small strain, glued plates, 5^3 cells of 1 cm, as errors
// against Hooke's law on triquadratic elements on the same 5^3 cubes: errors of
// discretisation, and where the formulas are wrong, of the law.

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(plate_figures_test)

namespace {

constexpr double side = 0.05, strain = 1e-4;
constexpr double poisson_ratios[] = {0, 0.25, 0.45, 0.499};

enum class Load { compression, shearing, torsion };

/// By the program's own fem-hooke with q2 elements at 1e-4 [N, N m]: of the law's linear
/// answer.
double triquadratic(Load load, std::size_t nu) {
  constexpr double forces[3][4] = {
      {2.5e-3, 2.6117840e-3, 2.9892941e-3, 3.2997675e-3},
      {7.5288855e-4, 6.6151008e-4, 6.3392036e-4, 6.6098971e-4},
      {9.0515362e-6, 7.2749672e-6, 6.3358459e-6, 6.2332067e-6}};
  return forces[static_cast<std::size_t>(load)][nu];
}

enum class Correction { as_built, on_cells };

/// Error of the plate's force or torque [%].
double error(const Mesh& mesh, const NetworkSettings& settings, Load load, std::size_t nu,
             Correction correction = Correction::as_built) {
  RigidMotion upper = translation(Vector3::Zero());
  upper.centre = {side / 2, side / 2, side};
  if (load == Load::compression) upper.translation.z() = -strain * side;
  if (load == Load::shearing) upper.translation.x() = strain * side;
  if (load == Load::torsion) upper.angle = strain;
  const Scene scene{.material = {.young_modulus = 1e4,
                                 .poisson_ratio = poisson_ratios[nu],
                                 .density = 1000},
                    .plates = {{"bottom", translation(Vector3::Zero()), all_components},
                               {"top", upper, all_components}},
                    .gravity = Vector3::Zero()};
  Network network = build_network(mesh, scene.material, settings);
  if (correction == Correction::on_cells) network.volume_stars = {};
  const Solution solution = find_equilibrium(mesh, scene, network);
  BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok), solution.reason);
  Vector3 force = Vector3::Zero();
  double torque = 0;
  for (const NodeIndex n : mesh.region("top").nodes) {
    force += solution.reactions[n];
    torque += (mesh.nodes()[n] - upper.centre).cross(solution.reactions[n]).z();
  }
  const double answer = load == Load::compression ? -force.z()
                        : load == Load::shearing  ? force.x()
                                                  : torque;
  return 100 * (answer / triquadratic(load, nu) - 1);
}

Block block(CellPattern pattern, double distortion) {
  return {.size = {side, side, side},
          .cells = {5, 5, 5},
          .pattern = pattern,
          .distortion = distortion};
}

constexpr Load loads[] = {Load::compression, Load::shearing, Load::torsion};

}  // namespace

// Rows of an independent prototype, printed to a tenth of a percent. Its cubes have the
// volume correction on cells at every Poisson ratio; the stars, which we have above 1/4,
// are closer by up to 1.1 %.
BOOST_AUTO_TEST_CASE(cubes_have_the_errors_computed_independently) {
  const Mesh mesh = cube(5, 0.01);
  struct Row {
    Method method;
    Correction correction;
    double errors[4][3];
  };
  for (const Row& row :
       {Row{Method::cf,
            Correction::as_built,
            {{0, 8.1, 6.4}, {1.1, 6.6, 6.1}, {3.6, 5.9, 5.5}, {0.7, 1.8, 4.2}}},
        Row{Method::affine,
            Correction::on_cells,
            {{0, 3.9, 2.6}, {0.6, 3.8, 2.6}, {1.7, 3.4, 2.2}, {-1.7, -0.8, 0.8}}},
        Row{Method::affine,
            Correction::as_built,
            {{0, 3.9, 2.6}, {0.6, 3.8, 2.6}, {1.1, 2.3, 1.9}, {-2.0, -0.8, 0.8}}}})
    for (std::size_t nu = 0; nu < 4; ++nu)
      for (const Load load : loads) {
        const double found =
            error(mesh, in_shear_modulus_form(row.method), load, nu, row.correction);
        const double expected = row.errors[nu][static_cast<std::size_t>(load)];
        BOOST_TEST(std::abs(found - expected) < 0.1,
                   "method " << static_cast<int>(row.method) << ", load "
                             << static_cast<int>(load) << ", nu " << poisson_ratios[nu]
                             << ": " << found << " for " << expected);
      }
}

// On distorted meshes of every type, up to nu = .499, errors are those of a
// discretisation with 5 cells: the prototype's on its own distorted mixed mesh are up
// to 4.1 %, ours on these up to 5.2. Five tetrahedra are stiff near nu = .5 (14 % in
// compression, regular).
BOOST_AUTO_TEST_CASE(affine_springs_do_not_lock_on_distorted_cells) {
  for (const CellPattern pattern :
       {CellPattern::hexahedron, CellPattern::prism, CellPattern::pyramid,
        CellPattern::tetrahedron, CellPattern::mixed}) {
    const Mesh mesh = generate_block(block(pattern, 0.2));
    for (std::size_t nu = 0; nu < 4; ++nu)
      for (const Load load : loads)
        BOOST_TEST(
            std::abs(error(mesh, in_shear_modulus_form(Method::affine), load, nu)) < 5.5);
  }
}

// The baselines from the literature on tetrahedra, without the correction; a prototype
// had errors of 1 to 22 % with Lloyd's on a mesh of its own. The claim is that neither
// comes near mss-affine on the same mesh, in the worst of the three loads.
BOOST_AUTO_TEST_CASE(springs_on_tetrahedra_by_formula_are_off_by_tens_of_percent) {
  const Mesh mesh = generate_block(block(CellPattern::tetrahedron, 0.2));
  for (const Method method : {Method::vangelder, Method::lloyd}) {
    NetworkSettings settings = in_shear_modulus_form(method);
    settings.volume_correction = VolumeCorrection::off;
    for (std::size_t nu = 0; nu < 4; ++nu) {
      double worst = 0;
      for (const Load load : loads)
        worst = std::max(worst, std::abs(error(mesh, settings, load, nu)));
      BOOST_TEST(worst > 15, poisson_ratios[nu] << ": " << worst);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
