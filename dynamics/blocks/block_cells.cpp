#include "dynamics/blocks/block_cells.hpp"

#include <algorithm>
#include <limits>

namespace springcheck::dynamics {

BlockCells cells_in_arrays(const Block& block, std::size_t lanes) {
  BlockCells cells{.row = block.row,
                   .layer = block.layer,
                   .count = block.cells.size(),
                   .corners = block.corners};
  for (auto& corners : cells.corners)
    for (std::uint32_t& corner : corners)
      corner = static_cast<std::uint32_t>(element_of(block, corner, lanes));
  return cells;
}

std::size_t element_of(const Block& block, std::size_t slot, std::size_t lanes) {
  const std::size_t rows = block.nodes.size() / lanes;
  return slot % rows * lanes + slot / rows;
}

std::size_t number_of(const Block& block, std::size_t cell, std::size_t lanes) {
  return block.is_grid() ? element_of(block, cell, lanes) : cell;
}

double rounding_of(std::span<const Vector3> positions) {
  double reach = 0;
  for (const Vector3& x : positions) reach = std::max(reach, x.cwiseAbs().maxCoeff());
  return 8 * std::numeric_limits<double>::epsilon() * reach;
}

std::optional<Eigen::Matrix3d> common_edges(const Block& block,
                                            std::span<const Vector3> positions,
                                            double rounding) {
  if (!block.is_grid()) return std::nullopt;
  std::optional<Eigen::Matrix3d> edges;
  bool alike = true;
  for_each_cell(block, [&](std::size_t, const std::array<std::uint32_t, 8>& slots) {
    const auto corner = [&](std::size_t c) -> const Vector3& {
      return positions[block.nodes[slots[c]]];
    };
    if (!edges) {
      edges.emplace();
      for (Eigen::Index k = 0; k < 3; ++k)
        edges->col(k) = corner(std::size_t{1} << k) - corner(0);
    }
    for (std::size_t c = 1; c < 8; ++c) {
      const Vector3 place(static_cast<double>(c & 1U), static_cast<double>(c >> 1U & 1U),
                          static_cast<double>(c >> 2U));
      const Vector3 off = corner(c) - corner(0) - *edges * place;
      if (off.cwiseAbs().maxCoeff() > rounding) alike = false;
    }
  });
  return alike ? edges : std::nullopt;
}

}  // namespace springcheck::dynamics
