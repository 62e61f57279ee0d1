#include "mss/statics/landscape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mss/forces/forces.hpp"

namespace springcheck::mss {
namespace {

// Up to here a factor costs seconds at most, however ill-conditioned the body is.
// Measured: compression of cubes of mss-cf by 5 %, whole solutions, processor seconds and
// gigabytes at nu = .25 and at .499:
//
//     cells   direct               conjugate gradients
//     10^3    .3   .4   (.1 GB)    .1   .3  (.1 GB)
//     30^3    19   31   (1.1 GB)   2.3  18  (.4 GB)
//     60^3                         35   287 (2.9 GB)
constexpr std::ptrdiff_t most_unknowns_solved_directly = 10'000;
// At 60^3 cells and nu = .499 less, 1e-3, leaves so much volume change that the load has
// to be cut in two.
constexpr double predictor_accuracy = 1e-4;

statics::LinearSolver taken(statics::LinearSolver wanted,
                            const std::vector<bool>& is_free) {
  using enum statics::LinearSolver;
  if (wanted != automatic) return wanted;
  return std::ranges::count(is_free, true) <= most_unknowns_solved_directly
             ? direct
             : conjugate_gradients;
}

statics::System system_of(const Mesh& mesh, const Scene& scene, const Network& network,
                          statics::LinearSolver wanted) {
  const std::vector<bool> is_free =
      free_components(mesh, prescribed_components(mesh, scene));
  return {mesh.nodes(), patches(network), is_free, taken(wanted, is_free)};
}

}  // namespace

double norm(const std::vector<Vector3>& vectors) {
  double sum = 0;
  for (const Vector3& v : vectors) sum += v.squaredNorm();
  return std::sqrt(sum);
}

Landscape::Landscape(const Mesh& mesh, const Scene& scene, const Network& network,
                     statics::LinearSolver linear_solver)
    : mesh_(mesh),
      scene_(scene),
      network_(network),
      prescribed_(prescribed_components(mesh, scene)),
      load_(load_forces(mesh, scene, network)),
      cell_edge_(std::cbrt(mesh.volume() / static_cast<double>(mesh.cells().size()))),
      system_(system_of(mesh, scene, network, linear_solver)),
      forces_(mesh.nodes().size()),
      tangent_(tangent_at(network, network.rest_positions)) {
  assemble();
  stiffness_ = diagonal(system_.matrix(), system_.unknowns()).norm();
}

void Landscape::assemble() {
  system_.matrix().assemble([&](std::size_t patch) { return part(tangent_, patch); });
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
  // Errors of a sum add up like a random walk; 1e-13 is ample for 10^4 unknowns.
  const double terms = std::max(1., static_cast<double>(unknowns()) / 1e4);
  return 1e-13 * std::sqrt(terms) * std::abs(energy) +
         force_round_off(x) * std::sqrt(2 * std::abs(energy) / stiffness_);
}

Eigen::VectorXd Landscape::on_free(const std::vector<Vector3>& all) const {
  return system_.unknowns().in(
      Eigen::Map<const Eigen::VectorXd>(all.data()->data(), 3 * std::ssize(all)));
}

Positions Landscape::moved(const Positions& x, const Eigen::VectorXd& by,
                           double factor) const {
  Positions y = x;
  Eigen::Map<Eigen::VectorXd>(y.data()->data(), 3 * std::ssize(y))(
      system_.unknowns().components()) += factor * by;
  return y;
}

double Landscape::longest_move(const Eigen::VectorXd& step) const {
  const Positions moves = moved(Positions(forces_.size(), Vector3::Zero()), step, 1);
  double longest = 0;
  for (const Vector3& move : moves) longest = std::max(longest, move.norm());
  return longest;
}

void Landscape::linearise(const Positions& x) {
  tangent_ = tangent_at(network_, x);
  assemble();
  system_.prepare();
}

void Landscape::clamp() {
  clamp_to_positive(tangent_);
  assemble();
  system_.prepare_semidefinite();
}

std::optional<bool> Landscape::is_definite(std::mt19937_64& random) {
  return system_.is_definite(random);
}

std::optional<Eigen::VectorXd> Landscape::solve(const Eigen::VectorXd& right,
                                                double accuracy) {
  return system_.solve(right, accuracy);
}

Eigen::VectorXd Landscape::negative_curvature(const Eigen::VectorXd& downhill,
                                              std::mt19937_64& random) {
  Eigen::VectorXd v = system_.negative_curvature(random);
  if (downhill.dot(v) < 0) v = -v;
  return v;
}

double Landscape::curvature_along(const Eigen::VectorXd& direction) const {
  Eigen::VectorXd product;
  system_.matrix().multiply(system_.unknowns().spread(direction), product);
  return direction.dot(system_.unknowns().in(product));
}

std::optional<int> Landscape::linear_iterations() const {
  return system_.iterations();
}

std::optional<int> Landscape::factorisations() const {
  return system_.factorisations();
}

Positions Landscape::predicted(const Positions& x, double to) {
  std::vector<Vector3> increment(x.size(), Vector3::Zero());
  for (const PrescribedComponent& held : prescribed_) {
    const auto& [node, i, plate] = held;
    increment[node][i] = mesh_.nodes()[node][i] +
                         prescribed_displacement(mesh_, scene_, held, to) - x[node][i];
  }
  const auto answer = [&] {
    std::vector<Vector3> push = product(system_.matrix(), increment);
    for (std::size_t n = 0; n < x.size(); ++n)
      push[n] = (to - load_fraction_) * load_[n] - push[n];
    return solve(on_free(push), predictor_accuracy);
  };
  std::optional<Eigen::VectorXd> step = answer();
  if (!step) {
    clamp();
    step = answer();
  }
  Positions y = moved(x, step.value(), 1);
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

double Landscape::path_gradient(const Positions& rest, const Positions& whole) {
  constexpr double little = 1. / 64, clearly = 1.01;
  const double chord = gradient(rest, whole);
  const double path = gradient(rest, predicted(rest, little)) / little;
  return path > clearly * chord ? path : chord;
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

}  // namespace springcheck::mss
