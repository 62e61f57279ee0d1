#include "mss/networks/hourglass.hpp"

#include <algorithm>
#include <cmath>

#include "mss/networks/cell_springs.hpp"

namespace springcheck::mss {
namespace {

std::vector<CellSpring> of_hexahedron_or_pyramid(CellType type, const CornerPositions& x,
                                                 double V, const Material& material) {
  const double E = material.young_modulus;
  const double m = 0.843 / (2 * (1 + material.poisson_ratio));
  std::vector<CellSpring> springs;
  const auto add = [&](const LocalEdge& ends, double eta) {
    const Vector3 r = along(x, ends);
    springs.push_back(
        {.ends = ends, .stiffness = eta * E * V / r.squaredNorm(), .rest = r});
  };
  for (const LocalEdge& edge : edges(type))
    add(edge, ((1 + std::sqrt(1 + 4 * m * m)) / 2 - m) / 12);
  for (const LocalEdge& diagonal : face_diagonals(type)) add(diagonal, m / 3);
  return springs;
}

std::vector<CellSpring> of_prism(const CornerPositions& x, double V,
                                 const Material& material) {
  const double E = material.young_modulus, mu = lame_constants(material).mu;
  const auto is_upright = [](const LocalEdge& edge) { return edge[1] == edge[0] + 3; };
  double a = 0, h = 0;
  for (const LocalEdge& edge : edges(CellType::prism))
    (is_upright(edge) ? h : a) += along(x, edge).norm() / (is_upright(edge) ? 3 : 6);

  std::vector<CellSpring> springs;
  const auto add = [&](const LocalEdge& ends, double stiffness) {
    if (stiffness > 0)
      springs.push_back({.ends = ends, .stiffness = stiffness, .rest = along(x, ends)});
  };
  for (const LocalEdge& edge : edges(CellType::prism))
    add(edge, is_upright(edge) ? E * V / (12 * h * h) - 0.05 * mu * V / (a * a)
                               : E * V / (6 * along(x, edge).squaredNorm()));
  for (const LocalEdge& diagonal : face_diagonals(CellType::prism))
    add(diagonal, 0.6 * mu * V * along(x, diagonal).squaredNorm() / (6 * h * h * a * a));
  return springs;
}

}  // namespace

std::vector<CellSpring> hourglass_springs(const CornerPositions& x, double volume,
                                          const Material& material) {
  switch (const CellType type = type_with(static_cast<std::size_t>(x.cols()))) {
    case CellType::tetrahedron:
      return {};
    case CellType::prism:
      return of_prism(x, volume, material);
    case CellType::pyramid:
    case CellType::hexahedron:
      return of_hexahedron_or_pyramid(type, x, volume, material);
  }
  return {};
}

}  // namespace springcheck::mss
