#pragma once

#include <functional>
#include <vector>

#include "dynamics/supports.hpp"

namespace springcheck::dynamics {

/// The displacements and velocities of all nodes, in the mesh's order.
struct State {
  std::vector<Vector3> displacements;  // [m]
  std::vector<Vector3> velocities;     // [m/s]; of Verlet half a step behind
};

/// The internal forces in a state [N]: springs, dashpots and the like, without loads.
using ForcesAt = std::function<std::vector<Vector3>(const State& state)>;

/// The end of a step. The motions are support_motions at its beginning and end.
struct StepTo {
  double dt;    // [s]
  double kick;  // [s], see step()
  double load_fraction;
  std::vector<AffineDisplacement> motions_before, motions;
};

/// A body on its way in time.
class Motion {
 public:
  virtual ~Motion() = default;
  virtual void advance(const StepTo& step) = 0;
  [[nodiscard]] virtual State state() const = 0;
  /// The internal forces in another state [N]. restore() must be called before going on.
  [[nodiscard]] virtual std::vector<Vector3> forces_at(const State& state) = 0;
  /// Goes on from a state, bit for bit as if it had been reached just now.
  virtual void restore(const State& state) = 0;
};

}  // namespace springcheck::dynamics
