#include "dynamics/blocks/plain_motion.hpp"

#include <utility>

#include "dynamics/blocks/explicit_motion.hpp"

namespace springcheck::dynamics {
namespace {

BlockForces<double> on_one_block(ForcesAt forces, std::size_t nodes) {
  const auto state = std::make_shared<State>();
  state->displacements.resize(nodes);
  state->velocities.resize(nodes);
  const auto add = [forces = std::move(forces), state](
                       std::size_t, const BlockArrays<double>& arrays) {
    const std::size_t count = state->displacements.size();
    for (std::size_t n = 0; n < count; ++n)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto j = static_cast<Eigen::Index>(i);
        state->displacements[n][j] = arrays.displacement[i][n];
        state->velocities[n][j] = arrays.velocity[i][n];
      }
    const std::vector<Vector3> found = forces(*state);
    for (std::size_t n = 0; n < count; ++n)
      for (std::size_t i = 0; i < 3; ++i)
        arrays.force[i][n] = found[n][static_cast<Eigen::Index>(i)];
  };
  return {.lanes = 1, .add = add};
}

}  // namespace

std::unique_ptr<Motion> plain_motion(const Mesh& mesh, const Scene& scene,
                                     std::span<const double> masses,
                                     std::span<const Vector3> load, ForcesAt forces,
                                     Integrator integrator, InstructionSet set) {
  return explicit_motion<double>(
      {.rest = mesh.nodes(),
       .masses = masses,
       .load = load,
       .supports = supports(scene, prescribed_components(mesh, scene)),
       .blocks = {whole_mesh(mesh)},
       .forces = on_one_block(std::move(forces), mesh.nodes().size())},
      {.integrator = integrator, .instruction_set = set, .threads = 1});
}

}  // namespace springcheck::dynamics
