#pragma once

#include <span>

#include "dynamics/blocks/blocks.hpp"

namespace springcheck::dynamics {

/// The nodes that several blocks have. Each block's copy of one is an entry; entries are
/// numbered block by block.
struct SharedNodes {
  std::size_t entries = 0;
  std::vector<std::size_t> first_entry;           // of each block
  std::vector<std::vector<std::uint32_t>> slots;  // of each block's shared nodes

  /// Entries of all copies of the block's n-th shared node, ascending.
  [[nodiscard]] std::span<const std::uint32_t> copies(std::size_t block,
                                                      std::size_t n) const {
    const std::size_t entry = first_entry[block] + n;
    return std::span(copy_entries)
        .subspan(first_copy[entry], first_copy[entry + 1] - first_copy[entry]);
  }

  static constexpr std::uint32_t many = ~std::uint32_t{0};
  std::vector<std::uint32_t> only_other;  // of each entry the other copy; many
  std::vector<std::uint32_t> first_copy;  // of each entry, and the end
  std::vector<std::uint32_t> copy_entries;
};

SharedNodes shared_nodes(const std::vector<Block>& blocks);

}  // namespace springcheck::dynamics
