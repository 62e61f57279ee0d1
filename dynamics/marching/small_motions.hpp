#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "dynamics/motion.hpp"

namespace springcheck::dynamics {

/// A system about which small motions are looked at.
struct SmallMotions {
  ForcesAt forces{};
  State state;                     // K and C are those of this state
  std::span<const double> masses;  // [kg] of each node
  std::vector<bool> is_free;       // of each component, 3 node + component
  double amplitude;                // [m] by which nodes are moved to find K
  bool has_dashpots;               // without, C is zero and not looked for
};

/// SmallMotions::amplitude in mean cell edges, in double precision: forces keep half
/// their digits at least, and what is not linear stays in the last.
inline constexpr double probe = 1e-4;

/// The system at rest, with an amplitude of `probe` cell edges; its forces are left
/// empty.
SmallMotions about_rest(std::span<const double> masses, std::vector<bool> is_free,
                        double cell_edge, bool has_dashpots);

/// A vector with one entry per free component, in their order.
using Field = Eigen::VectorXd;

/// v -> M^-1/2 (stiffness_factor K + dashpot_factor C) M^-1/2 v on the free components,
/// by central differences of the forces.
class Combination {
 public:
  /// The combination refers to the system.
  Combination(const SmallMotions& system, double stiffness_factor, double dashpot_factor);

  [[nodiscard]] Eigen::Index size() const { return inverse_root_mass_.size(); }
  /// A unit vector, always the same, that is orthogonal to nothing in particular.
  [[nodiscard]] Field start() const;
  /// One pair of forces gives both: displacements move along the vector where K counts,
  /// velocities in proportion.
  [[nodiscard]] Field apply(const Field& v) const;

 private:
  [[nodiscard]] State at(const Field& u, double moved, double pushed) const;

  const SmallMotions& system_;
  double stiffness_, dashpots_;
  std::vector<std::size_t> components_;
  Field inverse_root_mass_;
};

}  // namespace springcheck::dynamics
