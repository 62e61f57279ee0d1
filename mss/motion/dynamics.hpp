#pragma once

#include <memory>

#include "dynamics/blocks/instruction_set.hpp"
#include "dynamics/marching/march.hpp"
#include "dynamics/precision.hpp"
#include "meshing/basics/stopwatch.hpp"
#include "mss/networks/network.hpp"

namespace springcheck::mss {

using dynamics::Precision;

/// What computes the forces of explicit steps: nodal_forces and add_dashpot_forces, as
/// they stand, or kernels made for speed where there is one for the network.
enum class Kernel { plain, fast };

struct DynamicsSettings {
  dynamics::Protocol protocol;
  double damping_ratio;  // zeta of the springs' dashpots
  Precision precision = Precision::double_precision;
  int threads = 1;
  Kernel kernel = Kernel::fast;
};

/// Why the network does not move so, or nothing when it does: single precision is that
/// of the kernels, see takes_lattice_kernel and takes_affine_kernel.
std::optional<std::string> reason_to_refuse(const Mesh& mesh, const Network& network,
                                            const DynamicsSettings& settings);

/// What steps the network through time.
std::unique_ptr<dynamics::Motion> motion_of(
    const Mesh& mesh, const Scene& scene, const Network& network,
    const DynamicsSettings& settings,
    dynamics::InstructionSet set = dynamics::best_instruction_set());

/// Runs the dynamics and returns the state at the end, with forces of springs, volume
/// correction, dashpots, gravity and tractions; see dynamics::march.
Solution run_dynamics(const Mesh& mesh, const Scene& scene, const Network& network,
                      const DynamicsSettings& settings,
                      const dynamics::Observers& observers = {},
                      const Stopwatch& setup = {});

/// dynamics::largest_stable_step of the network in a state, by plain loops. is_free: one
/// entry per component, 3 node + component.
double largest_stable_step(
    const Network& network, double damping_ratio, const std::vector<bool>& is_free,
    dynamics::Integrator integrator = dynamics::Integrator::semi_implicit_euler);

}  // namespace springcheck::mss
