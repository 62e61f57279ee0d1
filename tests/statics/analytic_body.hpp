#pragma once

#include <array>
#include <cmath>
#include <functional>

#include "statics/elastic_body.hpp"
#include "statics/loading.hpp"

namespace springcheck::statics {

/// Energy, its gradient and its second derivative over a vector in space.
struct Potential {
  std::function<double(const Vector3&)> energy;
  std::function<Vector3(const Vector3&)> gradient;
  std::function<Matrix3(const Vector3&)> hessian;
};

/// A node that is held and a free one; the energy is of the way between them. One cell of
/// edge 1 m whose volume grows with the way's z.
class AnalyticBody final : public ElasticBody {
 public:
  explicit AnalyticBody(Potential potential) : potential_(std::move(potential)) {}

  [[nodiscard]] std::span<const Vector3> nodes() const override { return nodes_; }
  [[nodiscard]] double cell_edge() const override { return 1; }
  State state(const Eigen::VectorXd& u) override {
    const Vector3 pull = potential_.gradient(way(u));
    State now{.strain_energy = potential_.energy(way(u)), .forces = Eigen::VectorXd(6)};
    now.forces << pull, -pull;
    return now;
  }
  [[nodiscard]] Patches patches() const override { return {{0, 1}}; }
  void linearise(const Eigen::VectorXd& u) override {
    hessian_ = potential_.hessian(way(u));
  }
  [[nodiscard]] Eigen::MatrixXd part(std::size_t) const override {
    return between(hessian_);
  }
  [[nodiscard]] Eigen::MatrixXd positive_part(std::size_t) const override {
    return between(hessian_.diagonal().cwiseMax(0).asDiagonal());
  }
  [[nodiscard]] double mean_gradient(const Eigen::VectorXd& field) const override {
    return way(field).norm();
  }
  [[nodiscard]] double largest_volume_ratio(const Eigen::VectorXd& u) const override {
    return 1 + way(u).z();
  }
  [[nodiscard]] double rounding(const Eigen::VectorXd&) const override { return 1e-16; }

 private:
  static Vector3 way(const Eigen::VectorXd& u) { return u.tail<3>() - u.head<3>(); }
  static Eigen::MatrixXd between(const Matrix3& block) {
    Eigen::MatrixXd all(6, 6);
    all << block, -block, -block, block;
    return all;
  }

  std::vector<Vector3> nodes_{Vector3::Zero(), Vector3::UnitZ()};
  Potential potential_;
  Matrix3 hessian_;
};

/// The free node is pulled along z [N].
inline Loading pulled(double force) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(6);
  forces[5] = force;
  return {
      .is_free = {false, false, false, true, true, true},
      .displacements = [](double) { return Eigen::VectorXd(Eigen::VectorXd::Zero(6)); },
      .forces = forces,
      .follows_supports = [](const Eigen::VectorXd&, double) { return true; }};
}

/// (x^2 + y^2)/2 + z^2/2 - c z^3/3: the pull z - c z^2 has its largest value, 1/(4c), at
/// z = 1/(2c), where the path turns back.
inline Potential with_limit_point(double c) {
  return {.energy =
              [c](const Vector3& w) {
                return w.squaredNorm() / 2 - c * std::pow(w.z(), 3) / 3;
              },
          .gradient = [c](const Vector3& w) -> Vector3 {
            return w - c * w.z() * w.z() * Vector3::UnitZ();
          },
          .hessian = [c](const Vector3& w) -> Matrix3 {
            return Vector3(1, 1, 1 - 2 * c * w.z()).asDiagonal();
          }};
}

/// (x^2 + y^2)/2 + z^4/4 - z^3 + 1.25 z^2: the pull z^3 - 3 z^2 + 2.5 z has its largest
/// value at z = 1 - 1/sqrt(6), .63608 N, where the path turns back; the next one that
/// rises reaches it at z = 1 + 2/sqrt(6).
inline Potential with_snap() {
  return {.energy =
              [](const Vector3& w) {
                const double z = w.z();
                return (w.x() * w.x() + w.y() * w.y()) / 2 + std::pow(z, 4) / 4 -
                       std::pow(z, 3) + 1.25 * z * z;
              },
          .gradient = [](const Vector3& w) -> Vector3 {
            const double z = w.z();
            return {w.x(), w.y(), z * (z * z - 3 * z + 2.5)};
          },
          .hessian = [](const Vector3& w) -> Matrix3 {
            return Vector3(1, 1, 3 * w.z() * w.z() - 6 * w.z() + 2.5).asDiagonal();
          }};
}

/// z^2/2 + (1 - z) x^2/2 + x^4/4 + y^2/2: pulled by p along z there is x = 0, z = p, a
/// minimum up to p = 1. Beyond there are two at x^2 = 2 (p - 1), z = 2p - 1.
inline Potential with_bifurcation() {
  return {.energy =
              [](const Vector3& w) {
                const auto [x, y, z] = std::array{w.x(), w.y(), w.z()};
                return z * z / 2 + (1 - z) * x * x / 2 + std::pow(x, 4) / 4 + y * y / 2;
              },
          .gradient = [](const Vector3& w) -> Vector3 {
            const auto [x, y, z] = std::array{w.x(), w.y(), w.z()};
            return {(1 - z) * x + x * x * x, y, z - x * x / 2};
          },
          .hessian = [](const Vector3& w) -> Matrix3 {
            const auto [x, y, z] = std::array{w.x(), w.y(), w.z()};
            return Matrix3{{1 - z + 3 * x * x, 0, -x}, {0, 1, 0}, {-x, 0, 1}};
          }};
}

}  // namespace springcheck::statics
