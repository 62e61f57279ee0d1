#include "mss/tissue/tissue_motion.hpp"

#include <algorithm>
#include <optional>

#include "dynamics/blocks/mesh_motion.hpp"

namespace springcheck::mss {
namespace {

using dynamics::Block;

/// The blocks for the kernel, or none where the cells are not all hexahedra.
std::optional<std::vector<Block>> blocks_for_kernel(const Mesh& mesh) {
  if (mesh.count(CellType::hexahedron) != mesh.cells().size()) return std::nullopt;
  if (const auto grid = dynamics::grid_of(mesh)) return dynamics::grid_blocks(*grid);
  return dynamics::free_blocks(mesh);
}

}  // namespace

TissueMotion::TissueMotion(const Mesh& mesh, const Scene& scene, const TissueBody& body,
                           const TissueMotionSettings& settings,
                           dynamics::InstructionSet set)
    : mesh_(mesh), body_(body) {
  auto blocks = settings.kernel == Kernel::fast ? blocks_for_kernel(mesh) : std::nullopt;
  forces_ = blocks ? tissue_kernel(body, *blocks, set) : plain_tissue_forces(body);
  const int threads = blocks ? settings.threads : 1;
  motion_ = dynamics::mesh_motion(
      mesh, scene, body.masses,
      blocks ? std::move(*blocks) : std::vector{dynamics::whole_mesh(mesh)},
      forces_.forces,
      {.integrator = settings.integrator, .instruction_set = set, .threads = threads});
}

std::vector<double> TissueMotion::memories() const {
  return forces_.memories(blocks_for_kernel(mesh_).value_or(std::vector<Block>{}));
}

void TissueMotion::advance(const dynamics::StepTo& step) {
  if (step.dt != memory_step_.duration)
    memory_step_ = tissue::short_memory_step(body_.solid, step.dt);
  *forces_.step = &memory_step_;
  motion_->advance(step);
  *forces_.step = nullptr;
}

}  // namespace springcheck::mss
