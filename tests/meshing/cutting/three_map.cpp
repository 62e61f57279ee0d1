#include "tests/meshing/cutting/three_map.hpp"

#include <map>

namespace springcheck {

ThreeMap::ThreeMap(const CellComplex& cells) {
  for (std::uint32_t c = 0; c < cells.cell_count(); ++c) add_cell(cells, c);
  for (std::uint32_t c = 0; c < cells.cell_count(); ++c)
    for (std::uint8_t f = 0; f < cells.face_count(c); ++f)
      if (const std::uint32_t other = cells.across({c, f});
          other > c && other != CellComplex::none)
        join(cells, {c, f});
  auto vertices = map_.one_dart_per_cell<0>();
  for (auto one = vertices.begin(); one != vertices.end(); ++one)
    map_.set_attribute<0>(one, map_.create_attribute<0>());
}

ThreeMap::Dart& ThreeMap::dart(const CellSide& face, std::size_t node) {
  return darts_[4 * (first_[face.cell] + face.face) + node];
}

void ThreeMap::add_cell(const CellComplex& cells, std::uint32_t cell) {
  first_.push_back(size_.size());
  std::map<std::pair<NodeIndex, NodeIndex>, Dart> along;
  for (std::uint8_t f = 0; f < cells.face_count(cell); ++f) {
    const FaceNodes nodes = cells.nodes_of(CellSide{cell, f});
    size_.push_back(static_cast<std::uint8_t>(nodes.size()));
    darts_.resize(4 * size_.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      dart({cell, f}, i) = map_.create_dart();
      const NodeIndex a = nodes[i], b = nodes[(i + 1) % nodes.size()];
      along[{a, b}] = dart({cell, f}, i);
      if (const auto back = along.find({b, a}); back != along.end())
        map_.link_beta<2>(dart({cell, f}, i), back->second);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i)
      map_.link_beta<1>(dart({cell, f}, i), dart({cell, f}, (i + 1) % nodes.size()));
  }
}

void ThreeMap::join(const CellComplex& cells, const CellSide& face) {
  const CellSide other = cells.other_side(face);
  const FaceNodes a = cells.nodes_of(face), b = cells.nodes_of(other);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (a[i] == b[(j + 1) % b.size()]) map_.link_beta<3>(dart(face, i), dart(other, j));
}

void ThreeMap::cut(const Cut& cut) {
  for (const CellSide& face : cut.parted) map_.unsew<3>(dart(face, 0));
  for (const std::uint32_t cell : cut.removed) {
    map_.remove_cell<3>(dart({cell, 0}, 0));
    const std::size_t end = cell + 1 < first_.size() ? first_[cell + 1] : size_.size();
    for (std::size_t f = first_[cell]; f < end; ++f) size_[f] = 0;
  }
}

std::vector<ThreeMap::Corner> ThreeMap::corners() {
  std::vector<Corner> corners;
  for (std::uint32_t c = 0; c < first_.size(); ++c) {
    const std::size_t end = c + 1 < first_.size() ? first_[c + 1] : size_.size();
    for (std::size_t f = first_[c]; f < end; ++f)
      for (std::uint8_t i = 0; i < size_[f]; ++i) {
        const CellSide face{c, static_cast<std::uint8_t>(f - first_[c])};
        corners.push_back(
            {.face = face, .node = i, .vertex = &*map_.attribute<0>(dart(face, i))});
      }
  }
  return corners;
}

}  // namespace springcheck
