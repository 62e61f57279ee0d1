#include "meshing/cell_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace springcheck {
CellType type_of(const CornerPositions& x) {
  return type_with(static_cast<std::size_t>(x.cols()));
}

CornerPositions corners(const CellNodes& cell, std::span<const Vector3> positions) {
  CornerPositions x(3, cell.size());
  for (std::size_t i = 0; i < cell.size(); ++i)
    x.col(static_cast<Eigen::Index>(i)) = positions[cell[i]];
  return x;
}

double cell_volume(const CornerPositions& x) {
  double twelve_volumes = 0;
  for (const LocalFace& face : faces(type_of(x))) {
    // Relative to one corner: far from the origin the products would cancel badly.
    const auto corner = [&](std::size_t i) -> Vector3 {
      return x.col(face[i]) - x.col(0);
    };
    const Vector3 a = corner(0), b = corner(1), c = corner(2);
    if (face.size() == 3) {
      twelve_volumes += 2 * a.dot(b.cross(c));
      continue;
    }
    const Vector3 d = corner(3);
    twelve_volumes +=
        a.dot(b.cross(c)) + a.dot(c.cross(d)) + a.dot(b.cross(d)) + b.dot(c.cross(d));
  }
  return twelve_volumes / 12;
}

CornerPositions cell_volume_gradient(const CornerPositions& x) {
  CornerPositions gradient = CornerPositions::Zero(3, x.cols());
  for (const LocalFace& face : faces(type_of(x))) {
    const std::size_t count = face.size();
    const auto corner = [&](std::size_t i) -> Vector3 {
      return x.col(face[i % count]) - x.col(0);
    };
    for (std::size_t i = 0; i < count; ++i) {
      const Vector3 b = corner(i + 1), c = corner(i + 2);
      if (count == 3) {
        gradient.col(face[i]) += b.cross(c) / 6;
      } else {
        const Vector3 d = corner(i + 3);
        gradient.col(face[i]) += (b.cross(c) + c.cross(d) + b.cross(d)) / 12;
      }
    }
  }
  return gradient;
}

Vector3 cell_centroid(const CornerPositions& x) {
  Vector3 moment = Vector3::Zero();  // V (c - x_0)
  for (const LocalFace& face : faces(type_of(x))) {
    const auto corner = [&](std::size_t i) -> Vector3 {
      return x.col(face[i]) - x.col(0);
    };
    const Vector3 a = corner(0), b = corner(1), c = corner(2);
    if (face.size() == 3) {
      const Vector3 area = (b - a).cross(c - a) / 2, sum = a + b + c;
      const Vector3 mean_square =
          (sum.cwiseAbs2() + a.cwiseAbs2() + b.cwiseAbs2() + c.cwiseAbs2()) / 12;
      moment += mean_square.cwiseProduct(area) / 2;
      continue;
    }
    const Vector3 d = corner(3);
    const double gauss = std::sqrt(1. / 3);
    for (const double s : {-gauss, gauss})
      for (const double t : {-gauss, gauss}) {
        const Vector3 place = ((1 - s) * (1 - t) * a + (1 + s) * (1 - t) * b +
                               (1 + s) * (1 + t) * c + (1 - s) * (1 + t) * d) /
                              4;
        const Vector3 by_s = ((1 - t) * (b - a) + (1 + t) * (c - d)) / 4,
                      by_t = ((1 - s) * (d - a) + (1 + s) * (c - b)) / 4;
        moment += place.cwiseAbs2().cwiseProduct(by_s.cross(by_t)) / 2;
      }
  }
  return x.col(0) + moment / cell_volume(x);
}

double smallest_corner_jacobian(const CornerPositions& x) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& [corner, a, b, c] : corner_patches(type_of(x))) {
    const Vector3 o = x.col(corner), to_a = x.col(a) - o, to_b = x.col(b) - o,
                  to_c = x.col(c) - o;
    smallest = std::min(smallest, to_a.dot(to_b.cross(to_c)));
  }
  return smallest;
}

std::vector<double> cell_volumes(std::span<const CellNodes> cells,
                                 std::span<const Vector3> positions) {
  std::vector<double> volumes;
  volumes.reserve(cells.size());
  for (const CellNodes& cell : cells)
    volumes.push_back(cell_volume(corners(cell, positions)));
  return volumes;
}

bool has_inverted_cell(std::span<const CellNodes> cells,
                       std::span<const Vector3> positions) {
  return std::ranges::any_of(cells, [&](const CellNodes& cell) {
    return !(smallest_corner_jacobian(corners(cell, positions)) > 0);
  });
}

}  // namespace springcheck
