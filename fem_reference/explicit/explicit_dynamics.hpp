#pragma once

#include <memory>

#include "dynamics/blocks/instruction_set.hpp"
#include "dynamics/marching/march.hpp"
#include "dynamics/precision.hpp"
#include "fem_reference/explicit/explicit_element.hpp"

namespace springcheck::fem_reference {

struct ExplicitSettings {
  ExplicitElement element;
  dynamics::Protocol protocol;
  double damping_ratio;  // zeta of the drag
  dynamics::Precision precision = dynamics::Precision::double_precision;
  int threads = 1;
};

/// Why the mesh does not move so, or nothing when it does.
std::optional<std::string> reason_to_refuse(const Mesh& mesh,
                                            const ExplicitSettings& settings);

/// What steps the mesh of hexahedra through time.
std::unique_ptr<dynamics::Motion> motion_of(
    const Mesh& mesh, const Scene& scene, const ExplicitSettings& settings,
    dynamics::InstructionSet set = dynamics::best_instruction_set());

/// Runs explicit finite elements with lumped masses and returns the state at the end; see
/// dynamics::march. Gravity acts on the lumped masses, tractions by traction_forces.
Solution run_dynamics(const Mesh& mesh, const Scene& scene,
                      const ExplicitSettings& settings,
                      const dynamics::Observers& observers = {});

/// dynamics::largest_stable_step about the rest state, by plain loops.
double largest_stable_step(const Mesh& mesh, const Scene& scene,
                           const ExplicitSettings& settings);

}  // namespace springcheck::fem_reference
