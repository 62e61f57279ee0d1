#include "meshing/cell_type.hpp"

#include <algorithm>
#include <cassert>

namespace springcheck {
namespace {

constexpr std::array<LocalEdge, 6> tetrahedron_edges{
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
constexpr std::array<LocalEdge, 8> pyramid_edges{
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}};
constexpr std::array<LocalEdge, 9> prism_edges{
    {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};
constexpr std::array<LocalEdge, 12> hexahedron_edges{{{0, 1},
                                                      {1, 2},
                                                      {2, 3},
                                                      {3, 0},
                                                      {4, 5},
                                                      {5, 6},
                                                      {6, 7},
                                                      {7, 4},
                                                      {0, 4},
                                                      {1, 5},
                                                      {2, 6},
                                                      {3, 7}}};

constexpr std::array<LocalFace, 4> tetrahedron_faces{
    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
constexpr std::array<LocalFace, 5> pyramid_faces{
    {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
constexpr std::array<LocalFace, 5> prism_faces{
    {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
constexpr std::array<LocalFace, 6> hexahedron_faces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 4, 7, 3}, {1, 2, 6, 5}}};

constexpr std::array<CornerPatch, 1> tetrahedron_patches{{{0, 1, 2, 3}}};
constexpr std::array<CornerPatch, 4> pyramid_patches{
    {{0, 1, 3, 4}, {1, 2, 0, 4}, {2, 3, 1, 4}, {3, 0, 2, 4}}};
constexpr std::array<CornerPatch, 6> prism_patches{
    {{0, 1, 2, 3}, {1, 2, 0, 4}, {2, 0, 1, 5}, {3, 5, 4, 0}, {4, 3, 5, 1}, {5, 4, 3, 2}}};
constexpr std::array<CornerPatch, 8> hexahedron_patches{{{0, 1, 3, 4},
                                                         {1, 2, 0, 5},
                                                         {2, 3, 1, 6},
                                                         {3, 0, 2, 7},
                                                         {4, 7, 5, 0},
                                                         {5, 4, 6, 1},
                                                         {6, 5, 7, 2},
                                                         {7, 6, 4, 3}}};

struct Topology {
  std::string_view name, plural;
  std::size_t nodes;
  std::span<const LocalEdge> edges;
  std::span<const LocalFace> faces;
  std::span<const CornerPatch> corner_patches;
};

constexpr std::array<Topology, 4> topologies{
    {{"tetrahedron", "tetrahedra", 4, tetrahedron_edges, tetrahedron_faces,
      tetrahedron_patches},
     {"pyramid", "pyramids", 5, pyramid_edges, pyramid_faces, pyramid_patches},
     {"prism", "prisms", 6, prism_edges, prism_faces, prism_patches},
     {"hexahedron", "hexahedra", 8, hexahedron_edges, hexahedron_faces,
      hexahedron_patches}}};

const Topology& of(CellType type) {
  return topologies[static_cast<std::size_t>(type)];
}

}  // namespace

std::string_view name_of(CellType type) {
  return of(type).name;
}

std::string_view plural_of(CellType type) {
  return of(type).plural;
}

std::size_t node_count(CellType type) {
  return of(type).nodes;
}

CellType type_with(std::size_t nodes) {
  assert((nodes >= 4 && nodes <= 6) || nodes == 8);
  return nodes == 8 ? CellType::hexahedron : static_cast<CellType>(nodes - 4);
}

std::span<const LocalEdge> edges(CellType type) {
  return of(type).edges;
}

std::span<const LocalFace> faces(CellType type) {
  return of(type).faces;
}

FaceNodes ascending(FaceNodes face) {
  for (auto* unplaced = face.begin(); unplaced != face.end(); ++unplaced)
    std::rotate(std::upper_bound(face.begin(), unplaced, *unplaced), unplaced,
                unplaced + 1);
  return face;
}

FaceNodes face_nodes(const CellNodes& cell, const LocalFace& face) {
  FaceNodes nodes;
  for (const std::uint8_t i : face) nodes.push_back(cell[i]);
  return nodes;
}

std::span<const CornerPatch> corner_patches(CellType type) {
  return of(type).corner_patches;
}

}  // namespace springcheck
