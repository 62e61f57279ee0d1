#pragma once

#include <CGAL/Cell_attribute.h>
#include <CGAL/Combinatorial_map.h>

#include <vector>

#include "meshing/cutting/cut_body.hpp"

namespace springcheck {

/// A body as CGAL's combinatorial map, the second opinion on what cuts part: each cell's
/// faces are rings of darts, joined along its edges, and cells are joined by the darts of
/// their common faces. CGAL keeps one attribute for each vertex and decides itself when a
/// vertex becomes two.
class ThreeMap {
 public:
  explicit ThreeMap(const CellComplex& cells);

  /// The cut must be possible.
  void cut(const Cut& cut);

  /// The vertex at each node of each face of the cells that are left.
  struct Corner {
    CellSide face;
    std::uint8_t node;   // in the face
    const void* vertex;  // its attribute
  };
  [[nodiscard]] std::vector<Corner> corners();

 private:
  struct Items {
    template <class Map>
    struct Dart_wrapper {  // NOLINT: CGAL's name for it
      using Attributes = std::tuple<CGAL::Cell_attribute<Map>>;  // of vertices alone
    };
  };
  using Map = CGAL::Combinatorial_map<3, Items>;
  using Dart = Map::Dart_handle;

  Dart& dart(const CellSide& face, std::size_t node);
  void add_cell(const CellComplex& cells, std::uint32_t cell);
  void join(const CellComplex& cells, const CellSide& face);

  Map map_;
  std::vector<std::size_t> first_;  // of each cell's faces, in the darts
  std::vector<Dart> darts_;         // four for each face
  std::vector<std::uint8_t> size_;  // of each face, 0 where the cell was removed
};

}  // namespace springcheck
