#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "mss/kernels/lattice_cells.hpp"

namespace springcheck::mss {

/// The springs between nodes that blocks share, each with all its shares, in the first
/// block that has it.
class BorderSprings {
 public:
  struct Sum {
    std::size_t block, slot, step;
    double stiffness, length;
    std::uint8_t shares;
  };

  /// Cells on the other side of a border may have springs of another stiffness than the
  /// block that owns them: then its cells are no longer alike.
  BorderSprings(const Network& network, const std::vector<dynamics::Block>& blocks,
                std::vector<CommonShape>& common);

  [[nodiscard]] bool has(const PlacedSpring& spring) const {
    return is_shared_[spring.from] && is_shared_[spring.to];
  }
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const auto& [nodes, sum] : sums_) visit(sum);
  }

 private:
  std::vector<bool> is_shared_;
  std::unordered_map<std::uint64_t, Sum> sums_;
};

}  // namespace springcheck::mss
