#include "mss/motion/dynamics.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dynamics/blocks/mesh_motion.hpp"
#include "dynamics/marching/plain_body.hpp"
#include "mss/forces/forces.hpp"
#include "mss/kernels/affine_kernel.hpp"
#include "mss/kernels/lattice_kernel.hpp"
#include "mss/motion/implicit_motion.hpp"

namespace springcheck::mss {
namespace {

using dynamics::Block;
using dynamics::State;

double cell_edge(const Network& network) {
  double volume = 0;
  for (std::size_t c = 0; c < network.cells.size(); ++c)
    volume += network.cells.volume(c);
  return std::cbrt(volume / static_cast<double>(network.cells.size()));
}

std::vector<Vector3> positions_of(const Network& network,
                                  std::span<const Vector3> displacements) {
  std::vector<Vector3> positions = network.rest_positions;
  for (std::size_t n = 0; n < positions.size(); ++n) positions[n] += displacements[n];
  return positions;
}

/// The forces of nodal_forces and add_dashpot_forces, as they stand.
dynamics::ForcesAt plain_forces(const Network& network, double damping_ratio) {
  return [&network, damping_ratio,
          room = std::make_shared<CellStates>()](const State& state) {
    const std::vector<Vector3> positions = positions_of(network, state.displacements);
    std::vector<Vector3> forces(positions.size());
    nodal_forces(network, positions, *room, forces);
    if (damping_ratio > 0)
      add_dashpot_forces(network, damping_ratio, positions, state.velocities, forces);
    return forces;
  };
}

std::optional<std::vector<Block>> blocks_for_kernel(const Mesh& mesh,
                                                    const Network& network) {
  const bool is_affine = takes_affine_kernel(network);
  if (!is_affine && !takes_lattice_kernel(network)) return std::nullopt;
  if (const auto grid = dynamics::grid_of(mesh)) return dynamics::grid_blocks(*grid);
  if (!is_affine) return std::nullopt;
  return dynamics::free_blocks(mesh);
}

template <class Real>
std::unique_ptr<dynamics::Motion> by_kernel(const Mesh& mesh, const Scene& scene,
                                            const Network& network,
                                            const DynamicsSettings& settings,
                                            std::vector<Block> blocks,
                                            dynamics::InstructionSet set) {
  auto forces = takes_affine_kernel(network)
                    ? affine_kernel<Real>(network, blocks, settings.damping_ratio, set)
                    : lattice_kernel<Real>(network, blocks, settings.damping_ratio, set);
  return dynamics::mesh_motion(mesh, scene, network.masses, std::move(blocks),
                               std::move(forces),
                               {.integrator = settings.protocol.integrator,
                                .instruction_set = set,
                                .threads = settings.threads});
}

/// Why explicit Euler may find a motion that swings undamped.
std::string what_is_undamped(const Network& network, double damping_ratio) {
  if (!(damping_ratio > 0))
    return "without dashpots (--damping) every motion is undamped";
  if (network.spring_modulus != 0)
    return "virtual springs have their dashpots along the cells' edges, which leave "
           "their shear undamped";
  return "a motion that stretches no dashpot is undamped";
}

}  // namespace

std::optional<std::string> reason_to_refuse(const Mesh& mesh, const Network& network,
                                            const DynamicsSettings& settings) {
  if (settings.precision == Precision::double_precision) return std::nullopt;
  if (settings.protocol.integrator == dynamics::Integrator::implicit_euler)
    return "implicit Euler's equations are solved in double precision";
  if (!blocks_for_kernel(mesh, network))
    return "single precision is for hexahedra with springs by engineering strain "
           "(virtual ones along 6 axes) or by Green's";
  return std::nullopt;
}

std::unique_ptr<dynamics::Motion> motion_of(const Mesh& mesh, const Scene& scene,
                                            const Network& network,
                                            const DynamicsSettings& settings,
                                            dynamics::InstructionSet set) {
  if (settings.protocol.integrator == dynamics::Integrator::implicit_euler)
    return implicit_motion(mesh, scene, network, settings.damping_ratio);
  auto blocks =
      settings.kernel == Kernel::fast ? blocks_for_kernel(mesh, network) : std::nullopt;
  if (blocks && settings.precision == Precision::single_precision)
    return by_kernel<float>(mesh, scene, network, settings, std::move(*blocks), set);
  if (blocks)
    return by_kernel<double>(mesh, scene, network, settings, std::move(*blocks), set);
  return dynamics::plain_motion(mesh, scene, network.masses,
                                plain_forces(network, settings.damping_ratio),
                                settings.protocol.integrator, set);
}

double largest_stable_step(const Network& network, double damping_ratio,
                           const std::vector<bool>& is_free,
                           dynamics::Integrator integrator) {
  dynamics::SmallMotions system = dynamics::about_rest(
      network.masses, is_free, cell_edge(network), damping_ratio > 0);
  system.forces = plain_forces(network, damping_ratio);
  return dynamics::largest_stable_step(system, integrator);
}

Solution run_dynamics(const Mesh& mesh, const Scene& scene, const Network& network,
                      const DynamicsSettings& settings,
                      const dynamics::Observers& observers, const Stopwatch& setup) {
  if (const auto reason = reason_to_refuse(mesh, network, settings))
    return refused(*reason);
  const auto motion = motion_of(mesh, scene, network, settings);
  return dynamics::march(
      {.mesh = mesh,
       .scene = scene,
       .masses = network.masses,
       .forces = {.internal = plain_forces(network, settings.damping_ratio),
                  .strain_energy =
                      [&](std::span<const Vector3> displacements) {
                        return strain_energy(network,
                                             positions_of(network, displacements));
                      }},
       .damping_ratio = settings.damping_ratio,
       .undamped = what_is_undamped(network, settings.damping_ratio)},
      *motion, settings.precision, settings.protocol, observers, setup);
}

}  // namespace springcheck::mss
