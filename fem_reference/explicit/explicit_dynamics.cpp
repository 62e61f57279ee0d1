#include "fem_reference/explicit/explicit_dynamics.hpp"

#include "dynamics/blocks/mesh_motion.hpp"
#include "dynamics/marching/plain_body.hpp"
#include "fem_reference/explicit/explicit_kernel.hpp"
#include "fem_reference/explicit/plain_forces.hpp"
#include "fem_reference/motion/drag.hpp"

namespace springcheck::fem_reference {
namespace {

using dynamics::State;

template <class Real>
std::unique_ptr<dynamics::Motion> motion_in(const Mesh& mesh, const Scene& scene,
                                            const ExplicitSettings& settings,
                                            dynamics::InstructionSet set) {
  const auto grid = dynamics::grid_of(mesh);
  std::vector<dynamics::Block> blocks =
      grid ? dynamics::grid_blocks(*grid) : dynamics::free_blocks(mesh);
  auto forces =
      explicit_kernel<Real>(mesh, scene.material, settings.element, blocks,
                            drag_rate(mesh, scene.material, settings.damping_ratio), set);
  return dynamics::mesh_motion(mesh, scene, lumped_masses(mesh, scene.material.density),
                               std::move(blocks), std::move(forces),
                               {.integrator = settings.protocol.integrator,
                                .instruction_set = set,
                                .threads = settings.threads});
}

/// The body by plain loops. Refers to all that it is made of.
dynamics::PlainBody plain_body(const Mesh& mesh, const Scene& scene,
                               const ExplicitSettings& settings,
                               std::span<const double> masses) {
  const LameConstants lame = lame_constants(scene.material);
  const double rate = drag_rate(mesh, scene.material, settings.damping_ratio);
  return {
      .mesh = mesh,
      .scene = scene,
      .masses = masses,
      .forces = {.internal =
                     [&mesh, &settings, lame, rate, masses](const State& state) {
                       return with_drag(plain_forces(mesh, lame, settings.element,
                                                     state.displacements),
                                        rate, masses, state.velocities);
                     },
                 .strain_energy =
                     [&mesh, &settings, lame](std::span<const Vector3> displacements) {
                       return plain_energy(mesh, lame, settings.element, displacements);
                     }},
      .damping_ratio = settings.damping_ratio,
      .undamped = "without drag (--damping) every motion is undamped"};
}

}  // namespace

std::optional<std::string> reason_to_refuse(const Mesh& mesh,
                                            const ExplicitSettings& settings) {
  if (mesh.count(CellType::hexahedron) != mesh.cells().size())
    return "the kernels are for meshes of hexahedra; any cells are for elements by plain "
           "loops, as those of fem-explicit-stvk";
  if (settings.protocol.integrator == dynamics::Integrator::implicit_euler)
    return "elements in motion step explicitly: by semi-implicit Euler, Verlet or "
           "explicit Euler";
  return std::nullopt;
}

std::unique_ptr<dynamics::Motion> motion_of(const Mesh& mesh, const Scene& scene,
                                            const ExplicitSettings& settings,
                                            dynamics::InstructionSet set) {
  return settings.precision == dynamics::Precision::single_precision
             ? motion_in<float>(mesh, scene, settings, set)
             : motion_in<double>(mesh, scene, settings, set);
}

double largest_stable_step(const Mesh& mesh, const Scene& scene,
                           const ExplicitSettings& settings) {
  const std::vector<double> masses = lumped_masses(mesh, scene.material.density);
  return dynamics::largest_stable_step(plain_body(mesh, scene, settings, masses),
                                       settings.protocol.integrator);
}

Solution run_dynamics(const Mesh& mesh, const Scene& scene,
                      const ExplicitSettings& settings,
                      const dynamics::Observers& observers) {
  if (const auto reason = reason_to_refuse(mesh, settings)) return refused(*reason);
  const Stopwatch setup;
  const auto motion = motion_of(mesh, scene, settings);
  const std::vector<double> masses = lumped_masses(mesh, scene.material.density);
  return dynamics::march(plain_body(mesh, scene, settings, masses), *motion,
                         settings.precision, settings.protocol, observers, setup);
}

}  // namespace springcheck::fem_reference
