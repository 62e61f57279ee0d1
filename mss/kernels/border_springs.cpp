#include "mss/kernels/border_springs.hpp"

#include <algorithm>

namespace springcheck::mss {

BorderSprings::BorderSprings(const Network& network,
                             const std::vector<dynamics::Block>& blocks,
                             std::vector<CommonShape>& common)
    : is_shared_(network.rest_positions.size(), false) {
  std::vector<bool> is_known(is_shared_.size(), false);
  for (const dynamics::Block& block : blocks)
    for (const NodeIndex node : block.nodes) {
      if (node == dynamics::no_node) continue;
      if (is_known[node]) is_shared_[node] = true;
      is_known[node] = true;
    }
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for_each_placed(network, blocks[b], [&](const PlacedSpring& spring) {
      if (!has(spring)) return;
      const auto [first, second] = std::minmax(spring.from, spring.to);
      const auto [entry, is_new] = sums_.try_emplace(std::uint64_t{first} << 32U | second,
                                                     Sum{.block = b,
                                                         .slot = spring.slot,
                                                         .step = spring.step,
                                                         .stiffness = 0,
                                                         .length = spring.rest.norm(),
                                                         .shares = 0});
      Sum& sum = entry->second;
      sum.stiffness += spring.stiffness;
      ++sum.shares;
      CommonShape& owner = common[sum.block];
      if (!equal_but_for_rounding(spring.stiffness, owner.share[sum.step],
                                  owner.relative_rounding))
        owner.alike = false;
    });
}

}  // namespace springcheck::mss
