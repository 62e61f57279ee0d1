#pragma once

#include <memory>
#include <vector>

#include "dynamics/integrators.hpp"
#include "mss/motion/dynamics.hpp"
#include "mss/tissue/tissue_kernel.hpp"

namespace springcheck::mss {

struct TissueMotionSettings {
  dynamics::Integrator integrator;  // not the implicit one
  int threads = 1;                  // of kernels
  Kernel kernel = Kernel::fast;     // plain loops for other cells than hexahedra
};

/// Steps tissue through time from rest with memories at rest: a step moves the nodes,
/// then the memories by a short_memory_step, which gives the next forces. The dashpot's
/// rate is that of the nodes' velocities.
class TissueMotion final : public dynamics::Motion {
 public:
  /// Mesh and body outlive the motion.
  TissueMotion(const Mesh& mesh, const Scene& scene, const TissueBody& body,
               const TissueMotionSettings& settings,
               dynamics::InstructionSet set = dynamics::best_instruction_set());

  void advance(const dynamics::StepTo& step) override;
  [[nodiscard]] dynamics::State state() const override { return motion_->state(); }
  /// The forces in a state with the memories as they are.
  [[nodiscard]] std::vector<Vector3> forces_at(const dynamics::State& state) override {
    return motion_->forces_at(state);
  }
  /// The memories stay those of the step made last.
  void restore(const dynamics::State& state) override { motion_->restore(state); }

  /// The memories in the form of TissueForces::memories.
  [[nodiscard]] std::vector<double> memories() const;

 private:
  const Mesh& mesh_;
  const TissueBody& body_;
  TissueForces forces_;
  std::unique_ptr<dynamics::Motion> motion_;
  tissue::MemoryStep memory_step_{.duration = 0};
};

}  // namespace springcheck::mss
