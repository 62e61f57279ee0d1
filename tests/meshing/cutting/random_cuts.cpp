#include "tests/meshing/cutting/random_cuts.hpp"

#include <algorithm>
#include <functional>

#include "meshing/generators/generate_block.hpp"

namespace springcheck {
namespace {

class RandomCut {
 public:
  RandomCut(const CellComplex& cells, std::mt19937& random)
      : cells_(cells), random_(random) {
    for (std::uint32_t c = 0; c < cells.cell_count(); ++c)
      if (!cells.is_removed(c)) left_.push_back(c);
  }

  Cut operator()() {
    switch (below(7)) {
      case 0:
        for (std::size_t i = below(10) + 1; i-- > 0;) part_of(cell(), one_in(3));
        break;
      case 1:
        part_of(cell(), [](const CellSide&) { return true; });
        break;
      case 2:
        for (const std::uint32_t c : cells_.cells_at(node())) part_of(c, one_in(2));
        break;
      case 3: {
        const std::uint32_t last = cell();  // a plane of cells, as grids are numbered
        for (const std::uint32_t c : left_)
          part_of(c, [&](const CellSide& face) {
            return c <= last && cells_.across(face) > last;
          });
        break;
      }
      case 4:
        for (std::size_t i = below(4) + 1; i-- > 0;) remove(cell());
        break;
      case 5:
        for (const std::uint32_t c : cells_.cells_at(node())) remove(c);
        break;
      default:
        remove(cell());
        part_of(cell(), one_in(2));
    }
    if (below(20) == 0) spoil();
    return std::move(cut_);
  }

 private:
  std::size_t below(std::size_t end) { return random_() % end; }
  std::uint32_t cell() { return left_[below(left_.size())]; }
  NodeIndex node() {
    const CellNodes& nodes = cells_.nodes_of(cell());
    return nodes[below(nodes.size())];
  }
  std::function<bool(const CellSide&)> one_in(std::size_t count) {
    return [this, count](const CellSide&) { return below(count) == 0; };
  }

  template <class Wanted>
  void part_of(std::uint32_t cell, const Wanted& is_wanted) {
    for (std::uint8_t f = 0; f < cells_.face_count(cell); ++f) {
      const CellSide face{cell, f};
      if (cells_.across(face) == CellComplex::none || !is_wanted(face)) continue;
      const CellSide other = cells_.other_side(face);
      if (std::ranges::count(cut_.parted, face) +
              std::ranges::count(cut_.parted, other) ==
          0)
        cut_.parted.push_back(face);
    }
  }
  void remove(std::uint32_t cell) {
    if (std::ranges::count(cut_.removed, cell) == 0) cut_.removed.push_back(cell);
  }

  void spoil() {
    switch (below(4)) {
      case 0:
        if (!cut_.parted.empty())
          cut_.parted.push_back(cells_.other_side(cut_.parted.front()));
        break;
      case 1:
        for (const std::uint32_t c : left_)
          for (std::uint8_t f = 0; f < cells_.face_count(c); ++f)
            if (cells_.across({c, f}) == CellComplex::none) {
              cut_.parted.push_back({c, f});
              return;
            }
        break;
      case 2:
        if (!cut_.removed.empty()) cut_.removed.push_back(cut_.removed.front());
        break;
      default:
        cut_.removed = left_;
    }
  }

  const CellComplex& cells_;
  std::mt19937& random_;
  std::vector<std::uint32_t> left_;
  Cut cut_{.name = "cut"};
};

}  // namespace

Mesh random_body(unsigned seed) {
  std::mt19937 random(seed);
  const auto patterns = cell_patterns();
  Block block{.size = {0.3, 0.4, 0.5},
              .cells = {},
              .pattern = patterns[seed % patterns.size()].value,
              .distortion = 0.01,
              .seed = seed};
  for (int& count : block.cells) count = 1 + static_cast<int>(random() % 4);
  if (block.pattern == CellPattern::mixed || block.pattern == CellPattern::transition)
    block.cells = {3, 3, 3};
  return generate_block(block);
}

Cut random_cut(const CellComplex& cells, std::mt19937& random) {
  return RandomCut(cells, random)();
}

}  // namespace springcheck
