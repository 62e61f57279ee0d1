#include "meshing/generators/distortion.hpp"

#include "meshing/generators/uniform_number.hpp"

namespace springcheck {

void distort(const Block& block, std::span<Vector3> nodes) {
  const Eigen::Map<const Vector3> size(block.size.data());
  const Vector3 cells(block.cells[0], block.cells[1], block.cells[2]);
  const Vector3 reach = block.distortion * size.cwiseQuotient(cells);
  std::mt19937_64 random(block.seed);
  for (Vector3& x : nodes) {
    if ((x.array() <= 0).any() || (x.array() >= size.array()).any()) continue;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      x[axis] += reach[axis] * (2 * uniform_number(random) - 1);
  }
}

}  // namespace springcheck
