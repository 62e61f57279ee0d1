#include "mss/landscape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "meshing/random_numbers.hpp"
#include "mss/forces.hpp"

namespace springcheck::mss {
namespace {

constexpr int inverse_iterations = 12;

}  // namespace

Landscape::Landscape(const Mesh& mesh, const Scene& scene, const Network& network)
    : mesh_(mesh),
      scene_(scene),
      network_(network),
      prescribed_(prescribed_components(mesh, scene)),
      load_(load_forces(mesh, scene, network)),
      assembly_(network, free_components(mesh, prescribed_)),
      cell_edge_(std::cbrt(mesh.volume() / static_cast<double>(mesh.cells().size()))),
      stiffness_(assembly_.assemble(tangent_at(network, network.rest_positions))
                     .diagonal()
                     .norm()),
      forces_(mesh.nodes().size()) {
  cholesky_.cholmod().print = 0;  // a failed factorisation is an answer, not a warning
}

double Landscape::energy(const Positions& x) const {
  double total = strain_energy(network_, x);
  for (std::size_t n = 0; n < x.size(); ++n)
    total -= load_fraction_ * load_[n].dot(x[n] - network_.rest_positions[n]);
  return total;
}

const std::vector<Vector3>& Landscape::forces(const Positions& x) {
  nodal_forces(network_, x, states_, forces_);
  ++evaluations_;
  for (std::size_t n = 0; n < x.size(); ++n) forces_[n] += load_fraction_ * load_[n];
  return forces_;
}

double Landscape::force_round_off(const Positions& x) const {
  double reach = 0;
  for (const Vector3& place : x) reach = std::max(reach, place.cwiseAbs().maxCoeff());
  return std::numeric_limits<double>::epsilon() * stiffness_ * reach;
}

double Landscape::energy_round_off(const Positions& x, double energy) const {
  return 1e-13 * std::abs(energy) +
         force_round_off(x) * std::sqrt(2 * std::abs(energy) / stiffness_);
}

Eigen::VectorXd Landscape::on_free(const std::vector<Vector3>& all) const {
  Eigen::VectorXd values(assembly_.size());
  for_each_free([&](NodeIndex n, int i, Eigen::Index unknown) {  //
    values[unknown] = all[n][i];
  });
  return values;
}

Positions Landscape::moved(const Positions& x, const Eigen::VectorXd& by,
                           double factor) const {
  Positions y = x;
  for_each_free(
      [&](NodeIndex n, int i, Eigen::Index unknown) { y[n][i] += factor * by[unknown]; });
  return y;
}

double Landscape::longest_move(const Eigen::VectorXd& step) const {
  std::vector<Vector3> moves(forces_.size(), Vector3::Zero());
  for_each_free([&](NodeIndex n, int i, Eigen::Index unknown) {  //
    moves[n][i] = step[unknown];
  });
  double longest = 0;
  for (const Vector3& move : moves) longest = std::max(longest, move.norm());
  return longest;
}

bool Landscape::factor(const Positions& x) {
  tangent_ = tangent_at(network_, x);
  return factor_matrix(assembly_.assemble(tangent_));
}

void Landscape::factor_clamped() {
  clamp_to_positive(tangent_);
  factor_shifted(assembly_.assemble(tangent_));
}

Eigen::VectorXd Landscape::negative_curvature(const Eigen::VectorXd& downhill,
                                              std::mt19937_64& random) {
  factor_shifted(assembly_.assemble(tangent_));
  Eigen::VectorXd v(assembly_.size());
  for (double& component : v)
    component = 2 * static_cast<double>(random() >> 11U) * 0x1p-53 - 1;
  for (int i = 0; i < inverse_iterations; ++i) v = solve(v).normalized();
  return downhill.dot(v) < 0 ? Eigen::VectorXd(-v) : v;
}

Eigen::VectorXd Landscape::solve(const Eigen::VectorXd& right) {
  if (assembly_.size() == 0) return right;
  return cholesky_.solve(right);
}

Positions Landscape::predicted(const Positions& x, double to) {
  std::vector<Vector3> increment(x.size(), Vector3::Zero());
  for (const PrescribedComponent& held : prescribed_) {
    const auto& [node, i, plate] = held;
    increment[node][i] = mesh_.nodes()[node][i] +
                         prescribed_displacement(mesh_, scene_, held, to) - x[node][i];
  }
  std::vector<Vector3> push = product(network_, tangent_, increment);
  for (std::size_t n = 0; n < x.size(); ++n)
    push[n] = (to - load_fraction_) * load_[n] - push[n];
  Positions y = moved(x, solve(on_free(push)), 1);
  for (const auto& [node, i, plate] : prescribed_) y[node][i] += increment[node][i];
  return y;
}

double Landscape::gradient(const Positions& from, const Positions& to) const {
  double sum = 0;
  std::size_t count = 0;
  for_each_dashpot(network_, [&](const Spring& spring) {
    const Vector3 change =
        to[spring.b] - to[spring.a] - (from[spring.b] - from[spring.a]);
    sum += change.squaredNorm() / (spring.rest_length * spring.rest_length);
    ++count;
  });
  return std::sqrt(sum / static_cast<double>(count));
}

double Landscape::largest_volume_ratio(const Positions& x) const {
  std::vector<Vector3> u(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) u[n] = x[n] - network_.rest_positions[n];
  double largest = 0;
  for (std::size_t c = 0; c < network_.cells.size(); ++c)
    largest =
        std::max(largest, 1 + volume_change(network_.cells.displacement_gradient(c, u)));
  return largest;
}

bool Landscape::factor_matrix(const Eigen::SparseMatrix<double>& matrix) {
  if (assembly_.size() == 0) return true;
  if (!analysed_) {
    const std::lock_guard lock(random_numbers());  // the ordering is METIS's
    cholesky_.analyzePattern(matrix);
  }
  analysed_ = true;
  cholesky_.factorize(matrix);
  return cholesky_.info() == Eigen::Success;
}

/// Factors the matrix plus the smallest of a series of multiples of the identity that
/// makes it positive definite.
void Landscape::factor_shifted(Eigen::SparseMatrix<double> matrix) {
  const double scale = matrix.diagonal().cwiseAbs().maxCoeff();
  double shift = 0;
  while (!factor_matrix(matrix)) {
    const double next = shift == 0 ? 1e-8 * scale : 4 * shift;
    if (!(next > shift && next < 1e8 * scale))
      throw std::logic_error("a tangent that no shift makes positive definite");
    matrix.diagonal().array() += next - shift;
    shift = next;
  }
}

}  // namespace springcheck::mss
