#include "fem_reference/explicit/explicit_dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/blocks/explicit_motion.hpp"
#include "dynamics/marching/stable_step.hpp"
#include "fem_reference/explicit/explicit_kernel.hpp"
#include "fem_reference/explicit/plain_forces.hpp"
#include "meshing/stopwatch.hpp"
#include "meshing/traction.hpp"

namespace springcheck::fem_reference {
namespace {

using dynamics::State;

double cell_edge(const Mesh& mesh) {
  return std::cbrt(mesh.volume() / static_cast<double>(mesh.cells().size()));
}

double longest_extent(const Mesh& mesh) {
  Vector3 low = mesh.nodes().front(), high = low;
  for (const Vector3& x : mesh.nodes()) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).maxCoeff();
}

std::vector<Vector3> load_forces(const Mesh& mesh, const Scene& scene,
                                 std::span<const double> masses) {
  std::vector<Vector3> load = traction_forces(mesh, scene);
  for (std::size_t n = 0; n < load.size(); ++n) load[n] += masses[n] * scene.gravity;
  return load;
}

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
  const std::vector<double> masses = lumped_masses(mesh, scene.material.density);
  const std::vector<Vector3> load = load_forces(mesh, scene, masses);
  return dynamics::explicit_motion<Real>(
      {.rest = mesh.nodes(),
       .masses = masses,
       .load = load,
       .supports = dynamics::supports(scene, prescribed_components(mesh, scene)),
       .blocks = std::move(blocks),
       .forces = std::move(forces)},
      {.integrator = settings.protocol.integrator,
       .instruction_set = set,
       .threads = settings.threads});
}

/// By plain loops, and what march asks of them.
class PlainBody {
 public:
  PlainBody(const Mesh& mesh, const Scene& scene, const ExplicitSettings& settings)
      : mesh_(mesh),
        scene_(scene),
        settings_(settings),
        masses_(lumped_masses(mesh, scene.material.density)) {}

  [[nodiscard]] const std::vector<double>& masses() const { return masses_; }

  [[nodiscard]] std::vector<Vector3> forces(const State& state) const {
    std::vector<Vector3> forces = plain_forces(mesh_, lame_constants(scene_.material),
                                               settings_.element, state.displacements);
    const double rate = drag_rate(mesh_, scene_.material, settings_.damping_ratio);
    for (std::size_t n = 0; n < forces.size(); ++n)
      forces[n] -= rate * masses_[n] * state.velocities[n];
    return forces;
  }

  [[nodiscard]] dynamics::SmallMotions small_motions() const {
    const std::size_t nodes = mesh_.nodes().size();
    return {.forces = [this](const State& state) { return forces(state); },
            .state = {.displacements = std::vector<Vector3>(nodes, Vector3::Zero()),
                      .velocities = std::vector<Vector3>(nodes, Vector3::Zero())},
            .masses = masses_,
            .is_free = free_components(mesh_, prescribed_components(mesh_, scene_)),
            .amplitude = dynamics::probe * cell_edge(mesh_),
            .has_dashpots = settings_.damping_ratio > 0};
  }

 private:
  const Mesh& mesh_;
  const Scene& scene_;
  const ExplicitSettings& settings_;
  std::vector<double> masses_;
};

}  // namespace

double drag_rate(const Mesh& mesh, const Material& material, double damping_ratio) {
  const double shear_speed = std::sqrt(lame_constants(material).mu / material.density);
  return 2 * damping_ratio * std::numbers::pi * shear_speed / longest_extent(mesh);
}

std::optional<std::string> reason_to_refuse(const Mesh& mesh,
                                            const ExplicitSettings& settings) {
  if (mesh.count(CellType::hexahedron) != mesh.cells().size())
    return "fem-explicit is for meshes of hexahedra";
  if (settings.protocol.integrator == dynamics::Integrator::implicit_euler)
    return "fem-explicit steps explicitly: by semi-implicit Euler, Verlet or explicit "
           "Euler";
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
  const PlainBody body(mesh, scene, settings);
  return dynamics::largest_stable_step(body.small_motions(),
                                       settings.protocol.integrator);
}

Solution run_dynamics(const Mesh& mesh, const Scene& scene,
                      const ExplicitSettings& settings,
                      const dynamics::Observers& observers) {
  if (const auto reason = reason_to_refuse(mesh, settings)) return refused(*reason);
  const Stopwatch stopwatch;
  const auto motion = motion_of(mesh, scene, settings);
  const PlainBody body(mesh, scene, settings);
  const double motion_wall_s = stopwatch.seconds();
  const std::vector<Vector3> load = load_forces(mesh, scene, body.masses());
  const auto stable_step = [&](const std::optional<State>& state,
                               const dynamics::StableStep* near) {
    return dynamics::largest_stable_step(body.small_motions(), *motion,
                                         settings.precision, state,
                                         settings.protocol.integrator, near);
  };
  Solution solution = dynamics::march(
      {.mesh = mesh,
       .scene = scene,
       .masses = body.masses(),
       .load = load,
       .forces = {.internal =
                      [&](const State& state, std::span<Vector3> forces) {
                        std::ranges::copy(body.forces(state), forces.begin());
                      },
                  .strain_energy =
                      [&](std::span<const Vector3> displacements) {
                        return plain_energy(mesh, lame_constants(scene.material),
                                            settings.element, displacements);
                      }},
       .stable_step = stable_step,
       .step_setters = fmt::format("set by nu = {:g}, cells of {:.3g} m and a damping "
                                   "ratio of {:g}",
                                   scene.material.poisson_ratio, cell_edge(mesh),
                                   settings.damping_ratio),
       .undamped = "without drag (--damping) every motion is undamped"},
      *motion, settings.protocol, observers);
  solution.setup_wall_s += motion_wall_s;
  return solution;
}

}  // namespace springcheck::fem_reference
