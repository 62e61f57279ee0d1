#include "dynamics/blocks/mesh_motion.hpp"

#include <utility>

#include "meshing/loads/traction.hpp"

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

template <class Real>
std::unique_ptr<Motion> mesh_motion(const Mesh& mesh, const Scene& scene,
                                    std::span<const double> masses,
                                    std::vector<Block> blocks, BlockForces<Real> forces,
                                    const ExplicitSettings& settings) {
  const std::vector<Vector3> load = load_forces(mesh, scene, masses);
  return explicit_motion<Real>(
      {.rest = mesh.nodes(),
       .masses = masses,
       .load = load,
       .supports = supports(scene, prescribed_components(mesh, scene)),
       .blocks = std::move(blocks),
       .forces = std::move(forces)},
      settings);
}

template std::unique_ptr<Motion> mesh_motion(const Mesh&, const Scene&,
                                             std::span<const double>, std::vector<Block>,
                                             BlockForces<float>, const ExplicitSettings&);
template std::unique_ptr<Motion> mesh_motion(const Mesh&, const Scene&,
                                             std::span<const double>, std::vector<Block>,
                                             BlockForces<double>,
                                             const ExplicitSettings&);

std::unique_ptr<Motion> plain_motion(const Mesh& mesh, const Scene& scene,
                                     std::span<const double> masses, ForcesAt forces,
                                     Integrator integrator, InstructionSet set) {
  return mesh_motion(mesh, scene, masses, {whole_mesh(mesh)},
                     on_one_block(std::move(forces), mesh.nodes().size()),
                     {.integrator = integrator, .instruction_set = set, .threads = 1});
}

}  // namespace springcheck::dynamics
