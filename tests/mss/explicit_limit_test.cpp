#define BOOST_TEST_MODULE explicit_limit
#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>

#include "mss/forces.hpp"
#include "spring_runs.hpp"

using namespace springcheck;
using namespace springcheck::mss;
using dynamics::Integrator;

namespace {

constexpr double h = 0.005;  // [m]

/// Largest dt with |1 + dt Gamma| <= 1 for all rates Gamma of the network at rest: of M
/// v' = -K u - C v by dense eigenvalues, and by its matrices from differences of forces.
double limit_by_dense_rates(const Network& network, double zeta,
                            const std::vector<bool>& is_free) {
  std::vector<std::size_t> components;
  for (std::size_t i = 0; i < is_free.size(); ++i)
    if (is_free[i]) components.push_back(i);
  const auto count = static_cast<Eigen::Index>(components.size());
  Eigen::MatrixXd rates = Eigen::MatrixXd::Zero(2 * count, 2 * count);
  rates.topRightCorner(count, count).setIdentity();
  const std::vector<Vector3>& rest = network.rest_positions;
  const double probe = 1e-5 * h, speed = 1e-3;
  for (Eigen::Index j = 0; j < count; ++j) {
    const std::size_t node = components[static_cast<std::size_t>(j)] / 3;
    const auto axis =
        static_cast<Eigen::Index>(components[static_cast<std::size_t>(j)] % 3);
    std::vector<Vector3> ahead(rest.size()), behind(rest.size()),
        drag(rest.size(), Vector3::Zero()), x = rest, v(rest.size(), Vector3::Zero());
    x[node][axis] += probe;
    nodal_forces(network, x, ahead);
    x[node][axis] -= 2 * probe;
    nodal_forces(network, x, behind);
    v[node][axis] = speed;
    add_dashpot_forces(network, zeta, rest, v, drag);
    for (Eigen::Index i = 0; i < count; ++i) {
      const std::size_t to = components[static_cast<std::size_t>(i)];
      const auto k = static_cast<Eigen::Index>(to % 3);
      const double mass = network.masses[to / 3];
      rates(count + i, j) = (ahead[to / 3][k] - behind[to / 3][k]) / (2 * probe * mass);
      rates(count + i, count + j) = drag[to / 3][k] / (speed * mass);
    }
  }
  double limit = std::numeric_limits<double>::infinity();
  for (const std::complex<double>& rate : rates.eigenvalues())
    if (std::abs(rate) > 1e-3)
      limit = std::min(limit, -2 * rate.real() / std::norm(rate));
  return limit;
}

}  // namespace

BOOST_AUTO_TEST_CASE(probe) {
  for (int n : {2, 3})
    for (const auto& [name, method] : methods_on_cubes)
      for (const double nu : {0., .25, .4, .499})
        for (const double zeta : {0.05, 0.2, 1., 3.}) {
          const Mesh mesh = cube(n, h);
          const Scene scene = between_plates(tissue_of(nu), Vector3::Zero());
          if (reason_to_refuse(mesh, scene.material, method)) continue;
          const Network network =
              build_network(mesh, scene.material, in_shear_modulus_form(method));
          auto is_free = free_components(mesh, prescribed_components(mesh, scene));
          if (n == 3)
            for (const NodeIndex node : mesh.region("top").nodes)
              for (int i = 0; i < 3; ++i) is_free[3 * node + i] = true;
          const double dense = limit_by_dense_rates(network, zeta, is_free);
          const double found =
              largest_stable_step(network, zeta, is_free, Integrator::explicit_euler);
          printf("%d %s nu %g zeta %g: dense %.6g found %.6g ratio %.5f semi %.6g\n", n,
                 name, nu, zeta, dense, found, found / dense,
                 largest_stable_step(network, zeta, is_free));
        }
}
