#include "mss/networks/masses.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <span>

namespace springcheck::mss {
namespace {

using LocalTetrahedron = std::array<Eigen::Index, 4>;
constexpr std::array<LocalTetrahedron, 1> whole{{{0, 1, 2, 3}}};
constexpr std::array<LocalTetrahedron, 2> in_pyramid{{{0, 1, 3, 4}, {1, 2, 3, 4}}};
constexpr std::array<LocalTetrahedron, 3> in_prism{
    {{0, 1, 2, 3}, {1, 3, 4, 5}, {1, 2, 3, 5}}};
constexpr std::array<LocalTetrahedron, 6> in_hexahedron{
    {{0, 1, 2, 4}, {1, 4, 5, 6}, {1, 2, 4, 6}, {0, 2, 3, 4}, {2, 4, 6, 7}, {2, 3, 4, 7}}};

std::span<const LocalTetrahedron> tetrahedra(CellType type) {
  switch (type) {
    case CellType::tetrahedron:
      return whole;
    case CellType::pyramid:
      return in_pyramid;
    case CellType::prism:
      return in_prism;
    case CellType::hexahedron:
      return in_hexahedron;
  }
  return {};
}

}  // namespace

std::vector<double> nodal_volumes(const CornerPositions& x) {
  const auto n = static_cast<double>(x.cols());
  const Vector3 mean = x.rowwise().mean();
  const CornerPositions from_mean = x.colwise() - mean;
  const Eigen::Matrix3d S = from_mean * from_mean.transpose() / n;
  const Eigen::VectorXd shares =
      1 + (from_mean.transpose() * S.inverse() * (cell_centroid(x) - mean)).array();
  const double equal = equal_nodal_volume(x);
  std::vector<double> volumes(static_cast<std::size_t>(x.cols()), equal);
  if ((shares.array() > 0).all())
    std::ranges::transform(shares, volumes.begin(),
                           [&](double share) { return equal * share; });
  return volumes;
}

double equal_nodal_volume(const CornerPositions& x) {
  return cell_volume(x) / static_cast<double>(x.cols());
}

double volume_of_tetrahedra(const CornerPositions& x) {
  double six_volumes = 0;
  for (const auto& [a, b, c, d] :
       tetrahedra(type_with(static_cast<std::size_t>(x.cols())))) {
    const Vector3 o = x.col(a), to_b = x.col(b) - o, to_c = x.col(c) - o,
                  to_d = x.col(d) - o;
    six_volumes += to_b.cross(to_c).dot(to_d);
  }
  return six_volumes / 6;
}

}  // namespace springcheck::mss
