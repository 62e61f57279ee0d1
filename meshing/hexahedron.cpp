#include "meshing/hexahedron.hpp"

#include <algorithm>
#include <limits>

namespace springcheck {

HexahedronCorners corners(const Hexahedron& cell, std::span<const Vector3> positions) {
  HexahedronCorners x;
  for (std::size_t i = 0; i < 8; ++i) x[i] = positions[cell[i]];
  return x;
}

double trilinear_volume(const HexahedronCorners& x) {
  double twelve_volumes = 0;
  for (const auto& face : hexahedron_faces) {
    // Relative to one corner: far from the origin the products would cancel badly.
    const auto corner = [&](std::size_t i) -> Vector3 {
      return x[static_cast<std::size_t>(face[i])] - x[0];
    };
    const Vector3 a = corner(0), b = corner(1), c = corner(2), d = corner(3);
    twelve_volumes +=
        a.dot(b.cross(c)) + a.dot(c.cross(d)) + a.dot(b.cross(d)) + b.dot(c.cross(d));
  }
  return twelve_volumes / 12;
}

double smallest_corner_jacobian(const HexahedronCorners& x) {
  // A corner and the ends of its three edges, right-handed.
  constexpr std::array<std::array<std::size_t, 4>, 8> stars{{{0, 1, 3, 4},
                                                             {1, 2, 0, 5},
                                                             {2, 3, 1, 6},
                                                             {3, 0, 2, 7},
                                                             {4, 7, 5, 0},
                                                             {5, 4, 6, 1},
                                                             {6, 5, 7, 2},
                                                             {7, 6, 4, 3}}};
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& [corner, a, b, c] : stars) {
    const Vector3& o = x[corner];
    smallest = std::min(smallest, (x[a] - o).dot((x[b] - o).cross(x[c] - o)));
  }
  return smallest;
}

std::vector<double> cell_volumes(std::span<const Hexahedron> cells,
                                 std::span<const Vector3> positions) {
  std::vector<double> volumes;
  volumes.reserve(cells.size());
  for (const Hexahedron& cell : cells)
    volumes.push_back(trilinear_volume(corners(cell, positions)));
  return volumes;
}

}  // namespace springcheck
