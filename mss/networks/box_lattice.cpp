#include "mss/networks/box_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "mss/networks/cell_springs.hpp"

namespace springcheck::mss {
namespace {

constexpr std::array<std::size_t, 3> directions{0, 1, 2};

double length(const CornerPositions& x, const LocalEdge& pair) {
  return (x.col(static_cast<Eigen::Index>(pair[1])) -
          x.col(static_cast<Eigen::Index>(pair[0])))
      .norm();
}

}  // namespace

std::optional<std::array<double, 3>> box_edges(const CornerPositions& x) {
  constexpr CellType type = CellType::hexahedron;
  if (type_with(static_cast<std::size_t>(x.cols())) != type) return std::nullopt;
  const std::array<double, 3> size{length(x, {0, 1}), length(x, {0, 3}),
                                   length(x, {0, 4})};
  const double close = 1e-6 * std::cbrt(cell_volume(x));
  const auto all_are = [&](const auto& pairs, const auto& expected) {
    return std::ranges::all_of(pairs, [&](const LocalEdge& pair) {
      return std::abs(length(x, pair) - expected(pair)) <= close;
    });
  };
  const bool is_box =
      all_are(edges(type),
              [&](const LocalEdge& edge) { return size[edge_direction(edge)]; }) &&
      all_are(face_diagonals(type),
              [&](const LocalEdge& diagonal) {
                const std::size_t across = face_direction(diagonal);
                return std::hypot(size[(across + 1) % 3], size[(across + 2) % 3]);
              }) &&
      all_are(inner_diagonals(type),
              [&](const LocalEdge&) { return std::hypot(size[0], size[1], size[2]); });
  return is_box ? std::optional(size) : std::nullopt;
}

bool is_cube(const std::array<double, 3>& edges) {
  const double h = std::cbrt(edges[0] * edges[1] * edges[2]);
  return std::ranges::all_of(edges,
                             [&](double edge) { return std::abs(edge - h) <= 1e-6 * h; });
}

std::optional<BoxLattice> box_lattice(double shear_modulus,
                                      const std::array<double, 3>& edges) {
  const double whole = shear_modulus * edges[0] * edges[1] * edges[2] / 4;
  std::array<double, 3> square{};
  for (const std::size_t i : directions) square[i] = edges[i] * edges[i];
  const double diagonal_square = square[0] + square[1] + square[2];

  // Every q without its q_d, which edges add and face diagonals take away.
  BoxLattice q{};
  double lowest = 0, highest = INFINITY;  // q_d without a negative q
  double highest_in_ratio = INFINITY;     // and k_f/k_c at least 1
  for (const std::size_t i : directions) {
    const double b2 = square[(i + 1) % 3], c2 = square[(i + 2) % 3];
    q.edge[i] =
        3 * whole / (square[i] * square[i]) - whole / square[i] * (1 / b2 + 1 / c2);
    q.face_diagonal[i] = whole / (b2 * c2);
    lowest = std::max(lowest, -q.edge[i]);
    highest = std::min(highest, q.face_diagonal[i]);
    highest_in_ratio = std::min(highest_in_ratio, 2 * q.face_diagonal[i] * (b2 + c2) /
                                                      (diagonal_square + 2 * (b2 + c2)));
  }
  if (lowest > highest) return std::nullopt;
  double q_d = (lowest + highest) / 2;
  if (lowest <= highest_in_ratio) q_d = std::min(q_d, highest_in_ratio);

  q.inner_diagonal = q_d;
  for (const std::size_t i : directions) {
    q.edge[i] += q_d;
    q.face_diagonal[i] -= q_d;
  }
  return q;
}

}  // namespace springcheck::mss
