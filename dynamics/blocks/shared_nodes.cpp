#include "dynamics/blocks/shared_nodes.hpp"

#include <algorithm>

namespace springcheck::dynamics {

SharedNodes shared_nodes(const std::vector<Block>& blocks) {
  NodeIndex last = 0;
  for (const Block& block : blocks)
    for (const NodeIndex node : block.nodes)
      if (node != no_node) last = std::max(last, node);
  std::vector<std::uint32_t> blocks_of(last + std::size_t{1}, 0);
  for (const Block& block : blocks)
    for (const NodeIndex node : block.nodes)
      if (node != no_node) ++blocks_of[node];

  SharedNodes shared;
  std::vector<std::vector<std::uint32_t>> entries_of(blocks_of.size());
  std::vector<NodeIndex> node_of;  // of each entry
  for (const Block& block : blocks) {
    shared.first_entry.push_back(node_of.size());
    std::vector<std::uint32_t>& slots = shared.slots.emplace_back();
    for (std::uint32_t slot = 0; slot < block.nodes.size(); ++slot) {
      const NodeIndex node = block.nodes[slot];
      if (node == no_node || blocks_of[node] < 2) continue;
      slots.push_back(slot);
      entries_of[node].push_back(static_cast<std::uint32_t>(node_of.size()));
      node_of.push_back(node);
    }
  }
  shared.entries = node_of.size();
  for (std::uint32_t entry = 0; entry < node_of.size(); ++entry) {
    const std::vector<std::uint32_t>& all = entries_of[node_of[entry]];
    shared.only_other.push_back(all.size() == 2 ? all[all[0] == entry ? 1 : 0]
                                                : SharedNodes::many);
  }
  for (const NodeIndex node : node_of) {
    shared.first_copy.push_back(static_cast<std::uint32_t>(shared.copy_entries.size()));
    shared.copy_entries.insert(shared.copy_entries.end(), entries_of[node].begin(),
                               entries_of[node].end());
  }
  shared.first_copy.push_back(static_cast<std::uint32_t>(shared.copy_entries.size()));
  return shared;
}

}  // namespace springcheck::dynamics
