#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>

#include "meshing/cell_geometry.hpp"
#include "meshing/loads/traction.hpp"
#include "mss/statics/equilibrium.hpp"
#include "tests/mss/blocks.hpp"

// Blocks between sliding plates, under tractions and on an affine boundary deform
// homogeneously, and the lattice's energy per volume is known on paper.

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(homogeneous_test)

namespace {

constexpr double E = 1e4;           // [Pa]
constexpr double cell_edge = 0.01;  // [m]
constexpr int cells = 3;            // along each edge of the cube
constexpr double side = cells * cell_edge;
constexpr Held only_z{false, false, true};

/// Energy per volume of a cubic lattice with A = 1 and the volume correction, stretched
/// by l along x and y and by z along z:
///
///     psi = (k_e/2h) [2 (l-1)^2 + (z-1)^2] + (k_f/h) [2 (l-1)^2 + 2 (d - sqrt 2)^2]
///           + (2 k_c/h) (c - sqrt 3)^2 + kappa/2 (l^2 z - 1)^2,
///     d^2 = l^2 + z^2,   c^2 = 2 l^2 + z^2
///
/// (per cell one edge spring and two face diagonals of each direction, four inner
/// diagonals; k_c = 3 mu h/7, k_f = k_c, k_e = 11/3 k_c), and its derivatives.
class Lattice {
 public:
  explicit Lattice(double nu)
      : k_(3 * E / (2 * (1 + nu)) / 7),
        kappa_(E * (4 * nu - 1) / (2 * (1 + nu) * (1 - 2 * nu))) {}

  /// dpsi/dl [Pa]
  [[nodiscard]] double lateral(double l, double z) const {
    const double d = std::sqrt(l * l + z * z), c = std::sqrt(2 * l * l + z * z);
    return k_ * (22. / 3 * (l - 1) + 4 * (l - 1) + 4 * (1 - std::sqrt(2.) / d) * l +
                 8 * (1 - std::sqrt(3.) / c) * l) +
           kappa_ * (l * l * z - 1) * 2 * l * z;
  }

  /// dpsi/dz [Pa]: force on the plate per undeformed area.
  [[nodiscard]] double axial(double l, double z) const {
    const double d = std::sqrt(l * l + z * z), c = std::sqrt(2 * l * l + z * z);
    return k_ * (11. / 3 * (z - 1) + 4 * (1 - std::sqrt(2.) / d) * z +
                 4 * (1 - std::sqrt(3.) / c) * z) +
           kappa_ * (l * l * z - 1) * l * l;
  }

  /// The lateral stretch at which the sides are free of stress, by Newton's method with a
  /// difference quotient, from the one of small strain.
  [[nodiscard]] double free_sides(double z, double nu) const {
    double l = 1 - nu * (z - 1);
    for (int i = 0; i < 60; ++i) {
      constexpr double step = 1e-7;
      const double slope = (lateral(l + step, z) - lateral(l - step, z)) / (2 * step);
      l -= lateral(l, z) / slope;
    }
    return l;
  }

 private:
  double k_;  // k_c/h
  double kappa_;
};

RigidMotion lift(double by) {
  return translation({0, 0, by});
}

const std::vector<Pin> pins{{.point = {0, 0, 0}, .held = {true, true, false}},
                            {.point = {side, 0, 0}, .held = {false, true, false}}};

Scene between_sliding_plates(double nu, double strain) {
  return {.material = {.young_modulus = E, .poisson_ratio = nu, .density = 1000},
          .plates = {{"bottom", lift(0), only_z}, {"top", lift(strain * side), only_z}},
          .pins = pins,
          .gravity = Vector3::Zero()};
}

Scene pulled(double nu, const Held& held, const Vector3& traction) {
  Scene scene{.material = {.young_modulus = E, .poisson_ratio = nu, .density = 1000},
              .plates = {{"bottom", lift(0), held}},
              .tractions = {{"top", traction}},
              .gravity = Vector3::Zero()};
  if (held == only_z) scene.pins = pins;
  return scene;
}

struct Case {
  Mesh mesh;
  Solution solution;
};

Case solved(const Scene& scene, SpringModel model = SpringModel::cf) {
  const Mesh mesh = cube(cells, cell_edge);
  Solution solution = find_equilibrium(
      mesh, scene, build_network(mesh, scene.material, in_shear_modulus_form(model)));
  BOOST_TEST_REQUIRE((solution.status == SolveStatus::ok), solution.reason);
  return {mesh, std::move(solution)};
}

Vector3 force_on(const Case& c, const std::string& region) {
  Vector3 force = Vector3::Zero();
  for (const NodeIndex n : c.mesh.region(region).nodes) force += c.solution.reactions[n];
  return force;
}

double volume(const Case& c) {
  const auto volumes =
      cell_volumes(c.mesh.cells(), sum(c.mesh.nodes(), c.solution.displacements));
  return std::accumulate(volumes.begin(), volumes.end(), 0.);
}

/// P = (1/V0) sum r (x) X.
Eigen::Matrix3d mean_stress(const Case& c) {
  Eigen::Matrix3d P = Eigen::Matrix3d::Zero();
  for (std::size_t n = 0; n < c.mesh.nodes().size(); ++n)
    P += c.solution.reactions[n] * c.mesh.nodes()[n].transpose() / c.mesh.volume();
  return P;
}

}  // namespace

// The paper's lattice is solved to round-off; the block to a residual of 1e-10 of its
// forces, times the condition of its tangent (about 10).
BOOST_AUTO_TEST_CASE(block_between_sliding_plates_is_the_homogeneous_lattice) {
  const auto close = boost::test_tools::tolerance(1e-8);
  struct Row {
    double nu, strain;
  };
  // At nu = 0 the pulled lattice has no lateral minimum beyond 19.5 %.
  for (const auto& [nu, strain] :
       {Row{0, -0.2}, Row{0, 0.1}, Row{0.25, -0.2}, Row{0.25, 0.2}, Row{0.4, -0.2},
        Row{0.4, 0.2}, Row{0.499, -0.2}, Row{0.499, 0.2}})
    BOOST_TEST_CONTEXT("nu " << nu << ", strain " << strain) {
      const Case c = solved(between_sliding_plates(nu, strain));
      const double z = 1 + strain, l = Lattice(nu).free_sides(z, nu);
      BOOST_TEST(std::abs(Lattice(nu).lateral(l, z)) < 1e-9);  // E is 1e4
      const Vector3 top = force_on(c, "top"), bottom = force_on(c, "bottom");
      BOOST_TEST(top.z() == side * side * Lattice(nu).axial(l, z), close);
      BOOST_TEST((top + bottom).norm() < 1e-8 * top.norm());
      BOOST_TEST(volume(c) == c.mesh.volume() * l * l * z, close);
      // The pins hold nothing: there is nothing to hold.
      BOOST_TEST(std::hypot(bottom.x(), bottom.y()) < 1e-8 * top.norm());
      for (std::size_t n = 0; n < c.mesh.nodes().size(); ++n) {
        const Vector3& X = c.mesh.nodes()[n];
        const Vector3 expected((l - 1) * X.x(), (l - 1) * X.y(), (z - 1) * X.z());
        BOOST_TEST((c.solution.displacements[n] - expected).norm() < 1e-8 * side);
      }
    }
}

// What E and nu mean. The strain's square enters by about 1e-6; round-off of positions
// of 1e-17 in displacements of 1e-8 m by 1e-9.
BOOST_AUTO_TEST_CASE(small_uniaxial_strain_recovers_e_and_nu) {
  constexpr double strain = 1e-6;
  for (const SpringModel model :
       {SpringModel::nfd, SpringModel::cf, SpringModel::baudet, SpringModel::affine})
    for (const double nu : {0., 0.1, 0.25, 0.4, 0.49}) {
      if (model == SpringModel::baudet && nu != 0.25) continue;  // exact there only
      const Case c = solved(between_sliding_plates(nu, strain), model);
      BOOST_TEST_CONTEXT("method " << static_cast<int>(model) << ", nu " << nu) {
        BOOST_TEST(force_on(c, "top").z() / (side * side * strain) == E,
                   boost::test_tools::tolerance(1e-5));
        // This is the corner opposite the pinned one.
        const Vector3& u = c.solution.displacements.back();
        BOOST_TEST(std::abs(-u.x() / (side * strain) - nu) < 1e-5);
        BOOST_TEST(std::abs(-u.y() / (side * strain) - nu) < 1e-5);
      }
    }
}

// The stress that a strain needs, applied as a load, gives the strain back. Tolerance as
// above. (A block pressed by a dead load of about .15 E buckles: its top is free.)
BOOST_AUTO_TEST_CASE(traction_on_a_sliding_block_is_the_inverse_of_a_strain) {
  for (const double nu : {0., 0.25, 0.4, 0.499})
    for (const double strain : {-0.08, 0.08}) {
      const double z = 1 + strain, l = Lattice(nu).free_sides(z, nu);
      const double stress = Lattice(nu).axial(l, z);
      const Case c = solved(pulled(nu, only_z, {0, 0, stress}));
      BOOST_TEST_CONTEXT("nu " << nu << ", strain " << strain) {
        for (std::size_t n = 0; n < c.mesh.nodes().size(); ++n) {
          const Vector3& X = c.mesh.nodes()[n];
          const Vector3 expected((l - 1) * X.x(), (l - 1) * X.y(), (z - 1) * X.z());
          BOOST_TEST((c.solution.displacements[n] - expected).norm() < 1e-8 * side);
        }
        BOOST_TEST((force_on(c, "bottom") + side * side * Vector3(0, 0, stress)).norm() <
                   1e-8 * side * side * std::abs(stress));
        BOOST_TEST(norm(c.solution.reactions) > 0);
        BOOST_TEST(force_on(c, "top").norm() == 0);  // a load is no reaction
      }
    }
}

// Whatever the traction on a glued block, the plate balances force and moment. The error
// is bounded by the residual, 1e-10 of the forces.
BOOST_AUTO_TEST_CASE(glued_plate_balances_a_tractions_force_and_moment) {
  const Vector3 traction(120, -60, 200);
  const Scene scene = pulled(0.3, all_components, traction);
  const Case c = solved(scene);
  const std::vector<Vector3> x = sum(c.mesh.nodes(), c.solution.displacements),
                             load = traction_forces(c.mesh, scene);
  Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
  for (std::size_t n = 0; n < x.size(); ++n) {
    const Vector3 all = load[n] + c.solution.reactions[n];
    force += all;
    moment += x[n].cross(all);
  }
  const double scale = side * side * traction.norm();
  BOOST_TEST((total(load) - side * side * traction).norm() < 1e-12 * scale);
  BOOST_TEST(force.norm() < 1e-9 * scale);
  BOOST_TEST(moment.norm() < 1e-9 * scale * side);
}

// The work that a growing dead load does is the energy that the body holds:
// W(1) = int s t . du = t . u(1) - int t . u ds. By Simpson's rule over nine loads, whose
// error is the fourth derivative's: measured 2e-6.
BOOST_AUTO_TEST_CASE(work_of_a_growing_traction_is_the_energy_it_stores) {
  const Vector3 traction(300, 0, 600);
  const auto work = [&](double fraction) {  // of the full load through the displacement
    const Scene scene = pulled(0.3, all_components, fraction * traction);
    const Case c = solved(scene);
    const std::vector<Vector3> load = traction_forces(c.mesh, scene);
    double sum = 0;
    for (std::size_t n = 0; n < load.size(); ++n)
      sum += load[n].dot(c.solution.displacements[n]) / fraction;
    return std::pair(sum, c.solution.strain_energy);
  };
  double integral = 0;
  for (int i = 1; i < 8; ++i) integral += (i % 2 == 1 ? 4 : 2) * work(i / 8.).first / 24;
  const auto [whole, energy] = work(1);
  integral += whole / 24;
  BOOST_TEST(energy == whole - integral, boost::test_tools::tolerance(1e-5));
}

// The patch test: every node inside has the springs of a centrosymmetric lattice, which
// balance in any affine state. Positions are good to 1e-10 of the displacements.
BOOST_AUTO_TEST_CASE(body_follows_an_affine_boundary) {
  Eigen::Matrix3d H;
  H << 0.1, 0.04, -0.03, 0.02, -0.08, 0.05, -0.01, 0.03, 0.06;
  for (const auto& [name, model] : models_on_cubes) {
    if (model == SpringModel::nfd)
      continue;  // hourglass modes cost nothing in its inside
    for (const double nu : {0., 0.25, 0.45}) {
      const Scene scene{
          .material = {.young_modulus = E, .poisson_ratio = nu, .density = 1},
          .plates = {},
          .boundary_gradient = H,
          .gravity = Vector3::Zero()};
      const Case c = solved(scene, model);
      double worst = 0;
      for (std::size_t n = 0; n < c.mesh.nodes().size(); ++n)
        worst =
            std::max(worst, (c.solution.displacements[n] - H * c.mesh.nodes()[n]).norm());
      BOOST_TEST(worst < 1e-12 * side, name << ", nu " << nu);
      BOOST_TEST(force_on(c, "top").norm() > 0);
    }
  }
}

// mean_stress of a small gradient is that of the isotropic Hooke's law:
// lambda tr(eps) I + 2 mu eps; of a homogeneous uniaxial stretch that of psi. The
// strain's square enters by 1e-6 of its size.
BOOST_AUTO_TEST_CASE(boundary_reactions_carry_the_homogenised_stress) {
  Eigen::Matrix3d H;
  H << 1, 0.4, -0.3, 0.2, -0.8, 0.5, -0.1, 0.3, 0.6;
  H *= 1e-6;
  const Eigen::Matrix3d strain = (H + H.transpose()) / 2;
  for (const double nu : {0., 0.25, 0.45}) {
    Scene scene{.material = {.young_modulus = E, .poisson_ratio = nu, .density = 1},
                .plates = {},
                .boundary_gradient = H,
                .gravity = Vector3::Zero()};
    const auto [lambda, mu] = lame_constants(scene.material);
    const Eigen::Matrix3d hooke =
        lambda * strain.trace() * Eigen::Matrix3d::Identity() + 2 * mu * strain;
    BOOST_TEST((mean_stress(solved(scene)) - hooke).norm() < 1e-5 * hooke.norm());

    const double z = 0.8, l = 1.1;
    scene.boundary_gradient = Vector3(l - 1, l - 1, z - 1).asDiagonal();
    const Eigen::Matrix3d P = mean_stress(solved(scene));
    const Lattice lattice(nu);
    const Vector3 expected(lattice.lateral(l, z) / 2, lattice.lateral(l, z) / 2,
                           lattice.axial(l, z));
    BOOST_TEST((P - Eigen::Matrix3d(expected.asDiagonal())).norm() <
               1e-10 * expected.norm());
  }
}

BOOST_AUTO_TEST_SUITE_END()
