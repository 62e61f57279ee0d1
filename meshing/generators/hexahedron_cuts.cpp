#include "meshing/generators/hexahedron_cuts.hpp"

#include <algorithm>

namespace springcheck {
namespace {

/// Local nodes of the hexahedron for each cell cut from it.
template <std::size_t Nodes>
std::vector<CellNodes> cells(const CellNodes& hexahedron,
                             std::span<const std::array<std::size_t, Nodes>> cuts) {
  std::vector<CellNodes> cut;
  for (const auto& local : cuts) {
    cut.emplace_back();
    for (const std::size_t i : local) cut.back().push_back(hexahedron[i]);
  }
  return cut;
}

}  // namespace

std::vector<CellNodes> prisms_along(std::size_t axis, const CellNodes& hexahedron) {
  constexpr std::array<std::array<std::array<std::size_t, 6>, 2>, 3> prisms{
      {{{{0, 3, 7, 1, 2, 6}, {0, 7, 4, 1, 6, 5}}},
       {{{0, 4, 5, 3, 7, 6}, {0, 5, 1, 3, 6, 2}}},
       {{{0, 1, 2, 4, 5, 6}, {0, 2, 3, 4, 6, 7}}}}};
  return cells<6>(hexahedron, prisms[axis]);
}

std::vector<CellNodes> six_tetrahedra(const CellNodes& hexahedron) {
  constexpr std::array<std::array<std::size_t, 4>, 6> tetrahedra{{{0, 1, 2, 6},
                                                                  {0, 5, 1, 6},
                                                                  {0, 4, 5, 6},
                                                                  {0, 2, 3, 6},
                                                                  {0, 3, 7, 6},
                                                                  {0, 7, 4, 6}}};
  return cells<4>(hexahedron, tetrahedra);
}

std::vector<CellNodes> five_tetrahedra(const CellNodes& hexahedron, bool is_even) {
  constexpr std::array<std::array<std::size_t, 4>, 5> even{
      {{0, 5, 2, 7}, {0, 1, 2, 5}, {2, 3, 0, 7}, {4, 7, 5, 0}, {6, 5, 7, 2}}};
  constexpr std::array<std::array<std::size_t, 4>, 5> odd{
      {{1, 3, 4, 6}, {0, 1, 3, 4}, {2, 3, 1, 6}, {5, 4, 6, 1}, {7, 6, 4, 3}}};
  return cells<4>(hexahedron, is_even ? even : odd);
}

Vector3 mean_of(const CellNodes& hexahedron, std::span<const Vector3> nodes) {
  Vector3 mean = Vector3::Zero();
  for (const NodeIndex corner : hexahedron) mean += nodes[corner] / 8;
  return mean;
}

std::vector<CellNodes> cells_around(NodeIndex centre, const CellNodes& hexahedron,
                                    const std::array<bool, 6>& is_cut) {
  std::vector<CellNodes> around;
  for (std::size_t f = 0; f < 6; ++f) {
    FaceNodes face = face_nodes(hexahedron, faces(CellType::hexahedron)[f]);
    std::ranges::rotate(face, std::ranges::min_element(face));
    const auto [a, b, c, d] = std::array{face[0], face[1], face[2], face[3]};
    if (is_cut[f]) {
      around.push_back({a, c, b, centre});
      around.push_back({a, d, c, centre});
    } else {
      around.push_back({a, d, c, b, centre});
    }
  }
  return around;
}

}  // namespace springcheck
