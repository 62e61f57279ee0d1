#include "fem_reference/motion/moving_elements.hpp"

#include <tbb/task_arena.h>

#include "dynamics/blocks/mesh_motion.hpp"
#include "dynamics/marching/plain_body.hpp"
#include "fem_reference/cells/discretisation.hpp"
#include "fem_reference/motion/drag.hpp"
#include "fem_reference/statics/coverage.hpp"
#include "fem_reference/statics/elements_body.hpp"
#include "fem_reference/statics/loads.hpp"
#include "statics/systems/nodal_vectors.hpp"

namespace springcheck::fem_reference {
namespace {

using dynamics::State;

std::vector<double> lumped_masses_of(const Discretisation& body, double density) {
  const Eigen::VectorXd shares = body_load(body, [&](const Vector3&) -> Vector3 {
    return {density, 0, 0};
  });
  std::vector<double> masses(body.nodes.size());
  for (std::size_t n = 0; n < masses.size(); ++n)
    masses[n] = shares[3 * static_cast<Eigen::Index>(n)];
  return masses;
}

/// The elements of a mesh with their masses. Neither copied nor moved: the elements refer
/// to the discretisation.
class MovingElements {
 public:
  MovingElements(const Mesh& mesh, const Scene& scene, const MotionSettings& settings)
      : mesh_(mesh),
        scene_(scene),
        damping_ratio_(settings.damping_ratio),
        drag_rate_(drag_rate(mesh, scene.material, settings.damping_ratio)),
        body_(discretise(mesh, settings.elements.element)),
        elements_(body_, {.constitution = constitution(scene.material, settings.elements),
                          .dilatation = dilatation_taken(settings.elements)}),
        masses_(lumped_masses_of(body_, scene.material.density)),
        arena_(settings.threads) {}
  MovingElements(const MovingElements&) = delete;
  MovingElements& operator=(const MovingElements&) = delete;

  [[nodiscard]] std::vector<Vector3> forces(const State& state) {
    const Eigen::VectorXd forces = arena_.execute(
        [&] { return elements_.state(statics::stacked(state.displacements)).forces; });
    return with_drag(statics::by_node(forces), drag_rate_, masses_, state.velocities);
  }

  [[nodiscard]] dynamics::PlainBody plain_body() {
    return {
        .mesh = mesh_,
        .scene = scene_,
        .masses = masses_,
        .forces = {
            .internal = [this](const State& state) { return forces(state); },
            .strain_energy =
                [this](std::span<const Vector3> displacements) {
                  return elements_.state(statics::stacked(displacements)).strain_energy;
                }},
        .damping_ratio = damping_ratio_,
        .undamped = "without drag (--damping) every motion is undamped",
        .lever_arms =
            elements_.is_linear() ? LeverArms::undeformed : LeverArms::deformed};
  }

 private:
  const Mesh& mesh_;
  const Scene& scene_;
  double damping_ratio_, drag_rate_;
  Discretisation body_;
  ElementsBody elements_;
  std::vector<double> masses_;
  tbb::task_arena arena_;
};

std::unique_ptr<dynamics::Motion> motion_by(
    const std::shared_ptr<MovingElements>& elements, const Mesh& mesh, const Scene& scene,
    const MotionSettings& settings, dynamics::InstructionSet set) {
  const dynamics::PlainBody body = elements->plain_body();
  return dynamics::plain_motion(
      mesh, scene, body.masses,
      [elements](const State& state) { return elements->forces(state); },
      settings.protocol.integrator, set);
}

}  // namespace

std::optional<std::string> reason_to_refuse(const Mesh& mesh, const Scene& scene,
                                            const MotionSettings& settings) {
  if (settings.elements.element == Element::q2)
    return "elements in motion move the mesh's nodes; q2 has more of them";
  if (settings.protocol.integrator == dynamics::Integrator::implicit_euler)
    return "elements in motion step explicitly: by semi-implicit Euler, Verlet or "
           "explicit Euler";
  return reason_to_refuse(mesh, scene, settings.elements);
}

std::unique_ptr<dynamics::Motion> motion_of(const Mesh& mesh, const Scene& scene,
                                            const MotionSettings& settings,
                                            dynamics::InstructionSet set) {
  return motion_by(std::make_shared<MovingElements>(mesh, scene, settings), mesh, scene,
                   settings, set);
}

Solution run_dynamics(const Mesh& mesh, const Scene& scene,
                      const MotionSettings& settings,
                      const dynamics::Observers& observers) {
  if (const auto reason = reason_to_refuse(mesh, scene, settings))
    return refused(*reason);
  const Stopwatch setup;
  const auto elements = std::make_shared<MovingElements>(mesh, scene, settings);
  const auto motion =
      motion_by(elements, mesh, scene, settings, dynamics::best_instruction_set());
  return dynamics::march(elements->plain_body(), *motion,
                         dynamics::Precision::double_precision, settings.protocol,
                         observers, setup);
}

double largest_stable_step(const Mesh& mesh, const Scene& scene,
                           const MotionSettings& settings) {
  MovingElements elements(mesh, scene, settings);
  return dynamics::largest_stable_step(elements.plain_body(),
                                       settings.protocol.integrator);
}

}  // namespace springcheck::fem_reference
