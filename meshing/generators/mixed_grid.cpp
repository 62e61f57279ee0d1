#include "meshing/generators/mixed_grid.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <ranges>

#include "meshing/generators/uniform_number.hpp"

namespace springcheck {
namespace {

/// What a cut makes of the faces across an axis.
enum class FaceNeed { whole, cut, either };

FaceNeed need(MixedCut cut, std::size_t axis) {
  switch (cut) {
    case MixedCut::hexahedron:
      return FaceNeed::whole;
    case MixedCut::centre:
      return FaceNeed::either;
    default:
      return static_cast<std::size_t>(cut) == axis + 1 ? FaceNeed::cut : FaceNeed::whole;
  }
}

bool can_meet(MixedCut a, MixedCut b, std::size_t axis) {
  const FaceNeed needs_a = need(a, axis), needs_b = need(b, axis);
  return needs_a == needs_b || needs_a == FaceNeed::either || needs_b == FaceNeed::either;
}

class Grid {
 public:
  explicit Grid(const std::array<int, 3>& cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      counts_[axis] = static_cast<std::size_t>(cells[axis]);
      strides_[axis] = axis == 0 ? 1 : strides_[axis - 1] * counts_[axis - 1];
    }
  }

  [[nodiscard]] std::size_t size() const { return counts_[2] * strides_[2]; }

  [[nodiscard]] std::optional<std::size_t> below(std::size_t cell,
                                                 std::size_t axis) const {
    if (place(cell, axis) == 0) return std::nullopt;
    return cell - strides_[axis];
  }
  [[nodiscard]] std::optional<std::size_t> above(std::size_t cell,
                                                 std::size_t axis) const {
    if (place(cell, axis) + 1 == counts_[axis]) return std::nullopt;
    return cell + strides_[axis];
  }

 private:
  [[nodiscard]] std::size_t place(std::size_t cell, std::size_t axis) const {
    return cell / strides_[axis] % counts_[axis];
  }

  std::array<std::size_t, 3> counts_{}, strides_{};
};

std::vector<MixedCut> draw(const Grid& grid, std::mt19937_64& random) {
  using enum MixedCut;
  // One chance in three for hexahedra, prisms and cells around a centre.
  constexpr std::array chances{hexahedron,     hexahedron,     hexahedron,
                               prisms_along_x, prisms_along_y, prisms_along_z,
                               centre,         centre,         centre};
  std::vector<MixedCut> cuts(grid.size());
  for (std::size_t cell = 0; cell < cuts.size(); ++cell) {
    std::vector<MixedCut> possible;
    std::ranges::copy_if(chances, std::back_inserter(possible), [&](MixedCut cut) {
      return std::ranges::all_of(std::views::iota(0U, 3U), [&](std::size_t axis) {
        const auto neighbour = grid.below(cell, axis);
        return !neighbour || can_meet(cuts[*neighbour], cut, axis);
      });
    });
    const double place = uniform_number(random) * static_cast<double>(possible.size());
    cuts[cell] = possible[static_cast<std::size_t>(place)];
  }
  return cuts;
}

/// Whether the face between two cells, of which the second may be missing, is cut.
bool is_cut(const std::vector<MixedCut>& cuts, std::size_t cell,
            std::optional<std::size_t> neighbour, std::size_t axis) {
  const FaceNeed own = need(cuts[cell], axis);
  if (!neighbour || own != FaceNeed::either) return own == FaceNeed::cut;
  return need(cuts[*neighbour], axis) != FaceNeed::whole;
}

std::vector<MixedGridCell> with_faces(const Grid& grid,
                                      const std::vector<MixedCut>& cuts) {
  std::vector<MixedGridCell> cells;
  for (std::size_t cell = 0; cell < cuts.size(); ++cell) {
    const auto below = [&](std::size_t axis) {
      return is_cut(cuts, cell, grid.below(cell, axis), axis);
    };
    const auto above = [&](std::size_t axis) {
      return is_cut(cuts, cell, grid.above(cell, axis), axis);
    };
    cells.push_back(
        {.cut = cuts[cell],
         .is_cut = {below(2), above(2), below(1), above(1), below(0), above(0)}});
  }
  return cells;
}

bool has_all_types(const std::vector<MixedGridCell>& cells) {
  bool hexahedra = false, prisms = false, pyramids = false, tetrahedra = false;
  for (const auto& [cut, is_face_cut] : cells) {
    if (cut == MixedCut::hexahedron) {
      hexahedra = true;
    } else if (cut == MixedCut::centre) {
      pyramids = pyramids || !std::ranges::all_of(is_face_cut, std::identity{});
      tetrahedra = tetrahedra || std::ranges::any_of(is_face_cut, std::identity{});
    } else {
      prisms = true;
    }
  }
  return hexahedra && prisms && pyramids && tetrahedra;
}

}  // namespace

std::vector<MixedGridCell> mixed_grid(const std::array<int, 3>& cells, unsigned seed) {
  // These are not the numbers that the distortion draws from the same seed.
  std::mt19937_64 random((std::uint64_t{1} << 32U) + seed);
  const Grid grid(cells);
  std::vector<MixedGridCell> drawn;
  for (int attempt = 0; attempt < 1000 && !has_all_types(drawn); ++attempt)
    drawn = with_faces(grid, draw(grid, random));
  return drawn;
}

}  // namespace springcheck
