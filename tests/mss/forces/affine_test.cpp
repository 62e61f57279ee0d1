#include <boost/test/unit_test.hpp>
#include <cmath>
#include <span>

#include "meshing/generators/generate_block.hpp"
#include "mss/forces/forces.hpp"
#include "tests/mss/any_cells.hpp"
#include "tests/mss/assembled.hpp"

// Energy, forces and tangent of mss-affine on every type of cell, distorted and mixed.

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(affine_test)

namespace {

/// Poisson's ratios below, at and above 1/4, where the volume correction moves to the
/// nodal patches.
constexpr double poisson_ratios[] = {-0.5, 0, 0.25, 0.45, 0.499};

/// E = 1 Pa and edges of 1 m: forces and energies are of the order of 1.
Material soft(double nu) {
  return {.young_modulus = 1, .poisson_ratio = nu, .density = 1};
}

struct Springs {
  StrainMeasure measure = StrainMeasure::engineering;
  Axes axes = Axes::six;
};
constexpr Springs usual{}, all_springs[] = {usual,
                                            {StrainMeasure::green, Axes::six},
                                            {StrainMeasure::logarithmic, Axes::sixteen},
                                            {StrainMeasure::hencky, Axes::twenty_five}};

Network affine_network(const Mesh& mesh, double nu, const Springs& springs = usual) {
  NetworkSettings settings = springs_in(springs.measure, SpringModel::affine);
  settings.axes = springs.axes;
  return build_network(mesh, soft(nu), settings);
}

std::vector<Vector3> deformed(const Network& network, unsigned seed) {
  return sum(network.rest_positions,
             random_field(network.rest_positions.size(), 0.2, seed));
}

std::vector<Vector3> forces_at(const Network& network, const std::vector<Vector3>& x) {
  std::vector<Vector3> forces(x.size(), Vector3::Constant(1e9));  // to be overwritten
  nodal_forces(network, x, forces);
  return forces;
}

std::vector<Vector3> mapped(const Matrix3& F, std::vector<Vector3> x) {
  for (Vector3& place : x) place = F * place + Vector3(1, -2, 3);
  return x;
}

/// Visits every mesh at every Poisson ratio, with springs of each kind.
template <class Visit>
void for_each_network(int n, const Visit& visit,
                      std::span<const Springs> kinds = all_springs) {
  for (const auto& [name, mesh] : distorted_cubes(n, 1))
    for (const double nu : poisson_ratios)
      for (const Springs& springs : kinds)
        BOOST_TEST_CONTEXT(name << ", nu = " << nu << ", strain measure "
                                << static_cast<int>(springs.measure)) {
          visit(mesh, affine_network(mesh, nu, springs), nu);
        }
}

const Matrix3 some_deformation =
    (Matrix3() << 1.1, 0.2, -0.1, 0.05, 0.8, 0.3, -0.2, 0.1, 1.2).finished();

}  // namespace

BOOST_AUTO_TEST_CASE(network_at_rest_is_free_of_force_and_energy) {
  for_each_network(2, [](const Mesh&, const Network& network, double) {
    BOOST_TEST(strain_energy(network, network.rest_positions) == 0);
    BOOST_TEST(norm(forces_at(network, network.rest_positions)) == 0);
  });
}

// psi written out with F: six virtual springs (an icosahedron's axes) and kappa. Every
// mean over a nodal patch is F itself, and hourglass springs are at their affine lengths.
// The tolerance is round-off of sums over up to 100 cells.
BOOST_AUTO_TEST_CASE(
    affine_state_has_the_energy_and_stress_of_the_cauchy_born_continuum) {
  const Matrix3& F = some_deformation;
  for_each_network(
      2,
      [&](const Mesh& mesh, const Network& network, double nu) {
        const auto [lambda, mu] = lame_constants(soft(nu));
        const double kappa = lambda - mu, J = F.determinant();
        double psi = kappa / 2 * std::pow(J - 1, 2);
        Matrix3 P = kappa * (J - 1) * J * F.inverse().transpose();
        const double phi = (1 + std::sqrt(5.)) / 2;
        for (int axis = 0; axis < 3; ++axis)
          for (const double side : {1., -1.}) {
            Vector3 n = Vector3::Zero();
            n[axis] = phi;
            n[(axis + 1) % 3] = side;
            n.normalize();
            const Vector3 d = F * n;
            psi += 5 * mu / 4 * std::pow(d.norm() - 1, 2);
            P += 5 * mu / 2 * (1 - 1 / d.norm()) * d * n.transpose();
          }
        const std::vector<Vector3> x = mapped(F, mesh.nodes());
        BOOST_TEST(strain_energy(network, x) == mesh.volume() * psi,
                   boost::test_tools::tolerance(1e-12));
        // The virial of the boundary's forces is -V P, and there are none inside.
        const std::vector<Vector3> forces = forces_at(network, x);
        Matrix3 virial = Matrix3::Zero();
        for (std::size_t n = 0; n < x.size(); ++n)
          virial += forces[n] * mesh.nodes()[n].transpose();
        BOOST_TEST((virial + mesh.volume() * P).norm() < 1e-11 * P.norm());
        std::vector<bool> inside(x.size(), true);
        for (const NodeIndex node : mesh.boundary().nodes) inside[node] = false;
        for (std::size_t n = 0; n < x.size(); ++n)
          if (inside[n]) BOOST_TEST(forces[n].norm() < 1e-12 * norm(forces));
      },
      std::span(&usual, 1));
}

// The same of all springs, psi by the law that virtual_springs_test knows.
BOOST_AUTO_TEST_CASE(affine_state_has_the_energy_of_the_law_of_its_springs) {
  const Matrix3& F = some_deformation;
  for_each_network(2, [&](const Mesh& mesh, const Network& network, double) {
    const VirtualSprings law{.shear_modulus = network.spring_modulus,
                             .volume_moduli = network.volume_moduli,
                             .measure = network.strain_measure,
                             .axes = network.axes};
    BOOST_TEST(strain_energy(network, mapped(F, mesh.nodes())) ==
                   mesh.volume() * law.energy(F - Matrix3::Identity()),
               boost::test_tools::tolerance(1e-12));
  });
}

// The tolerance is round-off, from lengths of 1.
BOOST_AUTO_TEST_CASE(hourglass_springs_are_at_rest_in_affine_states_alone) {
  for_each_network(2, [](const Mesh& mesh, const Network& network, double) {
    const auto longest = [&](const std::vector<Vector3>& x) {
      CellStates states;
      update_deformations(network, x, states);
      double elongation = 0;
      for (std::size_t c = 0; c < network.cells.size(); ++c)
        for_each_affine_spring(
            network, states, c, [&](const CellSpring&, const AffineSpring& now) {
              elongation = std::max(elongation, std::abs(now.elongation));
            });
      return elongation;
    };
    BOOST_TEST(longest(mapped(some_deformation, mesh.nodes())) < 1e-14);
    const bool has_springs = mesh.count(CellType::tetrahedron) < mesh.cells().size();
    BOOST_TEST((longest(deformed(network, 1)) > 0.01) == has_springs);
  });
}

// The tolerance is round-off of sums of up to 100 forces at arms of about 3.
BOOST_AUTO_TEST_CASE(forces_and_their_moments_add_up_to_zero) {
  for_each_network(2, [](const Mesh&, const Network& network, double) {
    const std::vector<Vector3> x = deformed(network, 2);
    const std::vector<Vector3> forces = forces_at(network, x);
    Vector3 moment = Vector3::Zero();
    for (std::size_t n = 0; n < x.size(); ++n) moment += x[n].cross(forces[n]);
    BOOST_TEST(norm(forces) > 0.01);
    BOOST_TEST(total(forces).norm() < 1e-13 * norm(forces));
    BOOST_TEST(moment.norm() < 1e-13 * norm(forces));
  });
}

// The tolerance is round-off.
BOOST_AUTO_TEST_CASE(energy_and_forces_turn_with_the_body) {
  const Matrix3 R = Eigen::AngleAxisd(1, Vector3(1, 2, 2) / 3).toRotationMatrix();
  for_each_network(2, [&](const Mesh&, const Network& network, double) {
    const std::vector<Vector3> x = deformed(network, 3), turned = mapped(R, x);
    BOOST_TEST(strain_energy(network, turned) == strain_energy(network, x),
               boost::test_tools::tolerance(1e-12));
    const std::vector<Vector3> forces = forces_at(network, x),
                               turned_forces = forces_at(network, turned);
    for (std::size_t n = 0; n < x.size(); ++n)
      BOOST_TEST((turned_forces[n] - R * forces[n]).norm() < 1e-12 * norm(forces));
  });
}

// Central difference with a step of 1e-5 m: its truncation error is of the order of
// step^2 = 1e-10 of the third derivative, round-off 1e-15/1e-5 = 1e-10 of the energy.
BOOST_AUTO_TEST_CASE(forces_are_minus_the_gradient_of_the_energy) {
  constexpr double step = 1e-5;
  for_each_network(2, [&](const Mesh&, const Network& network, double) {
    std::vector<Vector3> x = deformed(network, 4);
    const std::vector<Vector3> forces = forces_at(network, x);
    double squared_error = 0;
    for (std::size_t n = 0; n < x.size(); ++n)
      for (double& coordinate : x[n]) {
        const double here = coordinate;
        coordinate = here + step;
        const double ahead = strain_energy(network, x);
        coordinate = here - step;
        const double behind = strain_energy(network, x);
        coordinate = here;
        const double force = forces[n][&coordinate - x[n].data()];
        squared_error += std::pow(force + (ahead - behind) / (2 * step), 2);
      }
    BOOST_TEST(std::sqrt(squared_error) < 1e-8 * norm(forces));
  });
}

// The derivative is taken along random ways, for the assembled matrix and for the product
// by patches. The tolerance is as above.
BOOST_AUTO_TEST_CASE(tangent_is_minus_the_slope_of_the_forces) {
  constexpr double step = 1e-5;
  for_each_network(2, [&](const Mesh&, const Network& network, double) {
    const std::vector<Vector3> x = deformed(network, 5);
    const auto components = static_cast<Eigen::Index>(3 * x.size());
    const Tangent tangent = tangent_at(network, x);
    const Eigen::SparseMatrix<double> lower =
        lower_triangle(network, tangent, std::vector<bool>(3 * x.size(), true));
    const Eigen::SparseMatrix<double> K = lower.selfadjointView<Eigen::Lower>();
    for (unsigned seed = 10; seed < 20; ++seed) {
      const std::vector<Vector3> way = random_field(x.size(), 1, seed);
      std::vector<Vector3> ahead = x, behind = x;
      for (std::size_t n = 0; n < x.size(); ++n) {
        ahead[n] += step * way[n];
        behind[n] -= step * way[n];
      }
      const std::vector<Vector3> by_patches = product(tangent, way);
      const std::vector<Vector3> after = forces_at(network, ahead),
                                 before = forces_at(network, behind);
      const Eigen::VectorXd by_matrix =
          K * Eigen::Map<const Eigen::VectorXd>(way.front().data(), components);
      double squared_error = 0, difference = 0;
      for (std::size_t n = 0; n < x.size(); ++n) {
        const Vector3 slope = (after[n] - before[n]) / (2 * step);
        squared_error += (by_patches[n] + slope).squaredNorm();
        difference +=
            (by_matrix.segment<3>(static_cast<Eigen::Index>(3 * n)) - by_patches[n])
                .squaredNorm();
      }
      BOOST_TEST(std::sqrt(squared_error) < 1e-7 * norm(by_patches));
      BOOST_TEST(std::sqrt(difference) < 1e-13 * norm(by_patches));
    }
  });
}

// kappa/2 (J_n - 1)^2 sees the mean over the nodal patch: a node inside that moves by
// itself changes no volume but its own cells', whose sum stays; what is left of the
// pressure is that of its neighbours' nodal patches. By hand for two cubes, whose middle
// nodes have both and whose outer nodes one of them: J of one doubled by its height, of
// the other halved.
BOOST_AUTO_TEST_CASE(patch_pressure_is_that_of_the_mean_volume) {
  const Mesh mesh = generate_block({.size = {1, 1, 2}, .cells = {1, 1, 2}});
  const Network network = affine_network(mesh, 0.499);
  std::vector<Vector3> x = mesh.nodes();
  for (Vector3& place : x)
    place.z() = place.z() == 1 ? 1.5 : place.z();  // heights of 1.5 and .5
  CellStates states;
  update_deformations(network, x, states);
  const double kappa = volume_correction_modulus(soft(0.499));
  const auto close = boost::test_tools::tolerance(1e-13);
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double Z = mesh.nodes()[n].z();
    if (Z == 1)
      BOOST_TEST(std::abs(states.patch_pressures[n]) < 1e-13 * kappa);
    else
      BOOST_TEST(states.patch_pressures[n] == (Z == 0 ? 1 : -1) * kappa / 2, close);
  }
  BOOST_TEST(patch_pressure(network, states, 0) == kappa / 4, close);
}

// Patches of shape are tetrahedra's alone, and those of volume all cells'; both parts of
// a body add up to it.
BOOST_AUTO_TEST_CASE(patches_share_out_the_body) {
  for_each_network(2, [](const Mesh& mesh, const Network& network, double nu) {
    double of_tetrahedra = 0;
    for (std::size_t c = 0; c < mesh.cells().size(); ++c)
      if (type_of(mesh.cells()[c]) == CellType::tetrahedron)
        of_tetrahedra += mesh.cell_volumes()[c];
    const auto whole = [](const NodalPatches& nodal_patches) {
      double sum = 0;
      for (const double volume : nodal_patches.volumes) sum += volume;
      return sum;
    };
    BOOST_TEST(std::abs(whole(network.shape_patches) - of_tetrahedra) < 1e-13);
    const double expected = nu > 0.25 ? mesh.volume() : 0;
    BOOST_TEST(std::abs(whole(network.volume_patches) - expected) < 1e-13);
  });
}

// The virtual springs have sum k l^2 = 15 mu V, in equal parts on the edges of the cell.
BOOST_AUTO_TEST_CASE(dashpots_lie_on_the_edges) {
  for_each_network(2, [](const Mesh& mesh, const Network& network, double nu) {
    double sum = 0;
    for (const Spring& edge : network.damped_edges) {
      BOOST_TEST(edge.a < edge.b);
      sum += edge.stiffness * edge.rest_length * edge.rest_length;
    }
    BOOST_TEST(sum == 15 * lame_constants(soft(nu)).mu * mesh.volume(),
               boost::test_tools::tolerance(1e-13));
    BOOST_TEST(network.springs.empty());
    const std::vector<Vector3> x = deformed(network, 6), v = random_field(x.size(), 1, 7);
    std::vector<Vector3> forces(x.size(), Vector3::Zero());
    add_dashpot_forces(network, 0.2, x, v, forces);
    BOOST_TEST(total(forces).norm() < 1e-13 * norm(forces));
    double power = 0;
    for (std::size_t n = 0; n < x.size(); ++n) power += forces[n].dot(v[n]);
    BOOST_TEST(power < 0);
  });
}

BOOST_AUTO_TEST_SUITE_END()
