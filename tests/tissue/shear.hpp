#pragma once

#include <vector>

#include "tissue/memory.hpp"

namespace springcheck::tissue {

/// C of x -> x + gamma y.
inline SymmetricTensor sheared(double strain) {
  return {1, 1 + strain * strain, 1, 0, 0, strain};
}

/// (F S F^T)_xy of the stress; J is 1, and the volume's part adds nothing.
inline double shear_stress_of(const PointStress& stress, double strain) {
  return stress.strands[5] + strain * stress.strands[1];
}

/// A solid with the bulk modulus of nu = .499; in simple shear any would do.
inline Solid sheared_solid(const MaxwellModel& model) {
  return {model, bulk_ratio_of(0.499)};
}

/// A point in simple shear, from rest.
class ShearedPoint {
 public:
  explicit ShearedPoint(const MaxwellModel& model)
      : solid_(sheared_solid(model)), state_(state_size(model.branches.size())) {
    set_to_rest(state_);
  }

  /// The stress after one step.
  double step_to(double strain, const MemoryStep& step) {
    return shear_stress_of(advance(solid_, step, state_, sheared(strain)), strain);
  }
  double step_to(double strain, double duration) {
    return step_to(strain, memory_step(solid_, duration));
  }

  /// The stress after that many equal steps at a constant rate.
  double move(double from, double to, double duration, int steps) {
    const MemoryStep step = memory_step(solid_, duration / steps);
    double stress = 0;
    for (int i = 1; i <= steps; ++i)
      stress = step_to(from + (to - from) * i / steps, step);
    return stress;
  }

  [[nodiscard]] const std::vector<double>& state() const { return state_; }

 private:
  Solid solid_;
  std::vector<double> state_;
};

}  // namespace springcheck::tissue
