// Compiled once per instruction set.
#include "dynamics/blocks/cell_packs.hpp"
#include "dynamics/blocks/pack_vectors.hpp"
#include "fem_reference/explicit/hexahedron_forces_paths.hpp"

namespace springcheck::fem_reference::SPRINGCHECK_PATH {
namespace {

using namespace dynamics::SPRINGCHECK_PATH;

/// m_s = sum_a phi_s(a) u_a of all modes s (hexahedra.hpp), coordinate by coordinate.
template <class Real>
[[gnu::always_inline]] inline CornerPacks<Real> modes_of(CornerPacks<Real> u) {
  for (std::size_t bit = 1; bit < 8; bit *= 2)
    for (std::size_t c = 0; c < 8; ++c)
      if ((c & bit) == 0) {
        const Pack<Real> low = u[c], high = u[c + bit];
        u[c] = high + low;
        u[c + bit] = high - low;
      }
  return u;
}

/// f_a = sum_s phi_s(a) g_s.
template <class Real>
[[gnu::always_inline]] inline CornerPacks<Real> corners_of(CornerPacks<Real> g) {
  for (std::size_t bit = 1; bit < 8; bit *= 2)
    for (std::size_t s = 0; s < 8; ++s)
      if ((s & bit) == 0) {
        const Pack<Real> even = g[s], odd = g[s + bit];
        g[s] = even - odd;
        g[s + bit] = even + odd;
      }
  return g;
}

/// Returns from the columns of H those of -(I + H)(half_lambda tr(T) I + mu T), where T =
/// H + H^T + H^T H = 2 E. The moduli have the point's volume in them. No sum with I is
/// formed, so that the digits of small strains are kept.
template <class Real>
[[gnu::always_inline]] inline std::array<Pack3<Real>, 3> minus_stress(
    const std::array<Pack3<Real>, 3>& h, Pack<Real> half_lambda, Pack<Real> mu) {
  std::array<Pack3<Real>, 3> s;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = j; k < 3; ++k)
      s[j][k] =
          h[j][k] + h[k][j] + h[j][0] * h[k][0] + h[j][1] * h[k][1] + h[j][2] * h[k][2];
  const Pack<Real> pressure = -half_lambda * (s[0][0] + s[1][1] + s[2][2]);
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = j; k < 3; ++k) s[j][k] *= -mu;
  for (std::size_t j = 0; j < 3; ++j) s[j][j] += pressure;
  s[1][0] = s[0][1];
  s[2][0] = s[0][2];
  s[2][1] = s[1][2];
  std::array<Pack3<Real>, 3> p;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 3; ++i)
      p[j][i] = s[j][i] + h[0][i] * s[0][j] + h[1][i] * s[1][j] + h[2][i] * s[2][j];
  return p;
}

/// The cells' constants, see HexahedronBlock.
template <class Real, CellShapes shapes>
class Constants {
 public:
  explicit Constants(const HexahedronBlock<Real>& block) : block_(block) {}

  [[gnu::always_inline]] Pack<Real> operator()(std::size_t n, std::size_t cell) const {
    if constexpr (shapes == CellShapes::hexahedra)
      return load(block_.constants.data() + n * block_.cells.count + cell);
    else
      return all(block_.constants[n]);
  }

  /// Returns 1, or 0 where no cell is. For hexahedra it is always 1, since the constants
  /// are 0 where no cell is.
  [[gnu::always_inline]] Pack<Real> is_cell(std::size_t cell) const {
    if constexpr (shapes == CellShapes::hexahedra)
      return all(Real(1));
    else
      return from_bytes<Real>(block_.is_cell.data() + cell);
  }

 private:
  const HexahedronBlock<Real>& block_;
};

template <class Real, CellShapes shapes>
class OnePoint {
  using P = Pack<Real>;
  using P3 = Pack3<Real>;

 public:
  explicit OnePoint(const HexahedronBlock<Real>& block)
      : block_(block), constant_(block) {}

  /// Works component by component, and unrolled, so that registers hold what the next
  /// lines need.
  template <class Cells>
  [[gnu::always_inline]] void operator()(std::size_t cell, Cells& cells) const {
    std::array<P3, 3> h{};  // columns of H = sum_s m_s (x) b_s
    std::array<std::array<P, 4>, 3> q;
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
      const CornerPacks<Real> m = modes_of<Real>(cells.at_corners(i));
      for_each_b(cell, [&](std::size_t s, std::size_t j, P b) { h[j][i] += m[s] * b; });
      for (std::size_t n = 0; n < 4; ++n) q[i][n] = m[hourglass_modes[n]];
    }
    const P is_cell = constant_.is_cell(cell);
    const P volume = is_cell * constant_(0, cell);
    std::array<P3, 3> p =
        minus_stress<Real>(h, volume * block_.half_lambda, volume * block_.mu);
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
      hourglass(cell, i, is_cell, h, q[i], p);
      CornerPacks<Real> g{};
      for (std::size_t n = 0; n < 4; ++n) g[hourglass_modes[n]] = -q[i][n];
      for_each_b(cell, [&](std::size_t s, std::size_t j, P b) { g[s] += p[j][i] * b; });
      cells.add_at_corners(i, corners_of<Real>(g));
    }
  }

 private:
  static constexpr std::size_t after_stiffness = 5, after_positions = 17;
  static constexpr std::array<std::size_t, 4> hourglass_modes{3, 5, 6, 7};

  /// Calls visit(s, j, b_s,j).
  template <class Visit>
  [[gnu::always_inline]] void for_each_b(std::size_t cell, const Visit& visit) const {
    for (std::size_t j = 0; j < 3; ++j)
      if constexpr (shapes == CellShapes::boxes)
        visit(std::size_t{1} << j, j, constant_(after_stiffness + j, cell));
      else if constexpr (shapes == CellShapes::parallelepipeds)
        for (std::size_t k = 0; k < 3; ++k)
          visit(std::size_t{1} << k, j, constant_(after_stiffness + 3 * k + j, cell));
      else
        for (std::size_t s = 1; s < 7; ++s)
          visit(s, j, constant_(after_positions + 3 * (s - 1) + j, cell));
  }

  /// Makes of the modes m_s the forces k 8 q, 8 q = m_s - H Y_s and k = mu k_s/64, which
  /// act on the mode the other way round, and of H on P: P += k 8 q (x) Y_s.
  [[gnu::always_inline]] void hourglass(std::size_t cell, std::size_t i, P is_cell,
                                        const std::array<P3, 3>& h, std::array<P, 4>& q,
                                        std::array<P3, 3>& p) const {
    for (std::size_t n = 0; n < 4; ++n) {
      const auto y = [&](std::size_t j) {
        return constant_(after_stiffness + 3 * n + j, cell);
      };
      if constexpr (shapes == CellShapes::hexahedra)
        q[n] -= h[0][i] * y(0) + h[1][i] * y(1) + h[2][i] * y(2);
      q[n] *= is_cell * constant_(1 + n, cell);
      if constexpr (shapes == CellShapes::hexahedra)
        for (std::size_t j = 0; j < 3; ++j) p[j][i] += q[n] * y(j);
    }
  }

  const HexahedronBlock<Real>& block_;
  Constants<Real, shapes> constant_;
};

/// The derivative by xi_k is bilinear in the other two coordinates: of the eight points
/// it has four values, of which each is the sum of four modes.
template <class Real, CellShapes shapes>
class EightPoints {
  using P = Pack<Real>;
  using P3 = Pack3<Real>;
  /// The derivatives by each direction k, at the places (0 to 3) that a point has among
  /// the other two directions.
  using Derivatives = std::array<std::array<P3, 4>, 3>;

 public:
  explicit EightPoints(const HexahedronBlock<Real>& block)
      : block_(block), constant_(block) {}

  template <class Cells>
  [[gnu::always_inline]] void operator()(std::size_t cell, Cells& cells) const {
    Derivatives d;
    for (std::size_t i = 0; i < 3; ++i) {
      const CornerPacks<Real> m = modes_of<Real>(cells.at_corners(i));
      for (std::size_t k = 0; k < 3; ++k) find_derivatives(cell, k, i, m, d[k]);
    }
    const P is_cell = constant_.is_cell(cell);
    Derivatives sums{};
    for (std::size_t point = 0; point < 8; ++point) {
      const std::array<std::size_t, 3> place{
          point >> 1U, (point & 1U) + (point >> 2U) * 2, point & 3U};
      std::array<P3, 3> at;  // filled one by one: whole ones would be copied in memory
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 3; ++i) at[k][i] = d[k][place[k]][i];
      const std::size_t first = shapes == CellShapes::hexahedra ? 10 * point : 0;
      const P volume = is_cell * constant_(first, cell);
      const std::array<P3, 3> p = by_coordinates(
          cell, first,
          minus_stress<Real>(by_position(cell, first, at), volume * block_.half_lambda,
                             volume * block_.mu));
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 3; ++i) sums[k][place[k]][i] += p[k][i];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      CornerPacks<Real> g{};
      for (std::size_t k = 0; k < 3; ++k) add_conjugate(cell, k, i, sums[k], g);
      cells.add_at_corners(i, corners_of<Real>(g));
    }
  }

 private:
  static constexpr Real root = Real(0.577350269189625764509148780501957456);  // 1/sqrt(3)

  /// The four modes that have xi_k, and what they are multiplied with at the points.
  struct Terms {
    std::array<std::size_t, 4> modes;
    std::array<P, 4> factors;
  };
  [[gnu::always_inline]] Terms terms(std::size_t cell, std::size_t k) const {
    const std::size_t s = std::size_t{1} << k, low = k == 0 ? 2 : 1,
                      high = k == 2 ? 2 : 4;
    P scale = all(Real(.125));
    if constexpr (shapes == CellShapes::boxes) scale *= constant_(1 + k, cell);
    return {{s, s + low, s + high, 7},
            {scale, root * scale, root * scale, root * root * scale}};
  }

  [[gnu::always_inline]] void find_derivatives(std::size_t cell, std::size_t k,
                                               std::size_t i, const CornerPacks<Real>& m,
                                               std::array<P3, 4>& values) const {
    const Terms by = terms(cell, k);
    const P a = by.factors[0] * m[by.modes[0]], b = by.factors[1] * m[by.modes[1]],
            c = by.factors[2] * m[by.modes[2]], d = by.factors[3] * m[by.modes[3]];
    values[0][i] = (a - b) - (c - d);
    values[1][i] = (a + b) - (c + d);
    values[2][i] = (a - b) + (c - d);
    values[3][i] = (a + b) + (c + d);
  }

  /// Does the same the other way round, from the points to the modes.
  [[gnu::always_inline]] void add_conjugate(std::size_t cell, std::size_t k,
                                            std::size_t i, const std::array<P3, 4>& sums,
                                            CornerPacks<Real>& g) const {
    const Terms by = terms(cell, k);
    const P a = sums[1][i] + sums[0][i], b = sums[1][i] - sums[0][i],
            c = sums[3][i] + sums[2][i], d = sums[3][i] - sums[2][i];
    g[by.modes[0]] += by.factors[0] * (c + a);
    g[by.modes[1]] += by.factors[1] * (d + b);
    g[by.modes[2]] += by.factors[2] * (c - a);
    g[by.modes[3]] += by.factors[3] * (d - b);
  }

  /// Derivatives by X_j from those by xi_k; those of boxes have been multiplied before.
  [[gnu::always_inline]] std::array<P3, 3> by_position(std::size_t cell,
                                                       std::size_t first,
                                                       const std::array<P3, 3>& d) const {
    if constexpr (shapes == CellShapes::boxes) return d;
    std::array<P3, 3> h{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j) {
        const P factor = constant_(first + 1 + 3 * k + j, cell);
        for (std::size_t i = 0; i < 3; ++i) h[j][i] += d[k][i] * factor;
      }
    return h;
  }

  [[gnu::always_inline]] std::array<P3, 3> by_coordinates(
      std::size_t cell, std::size_t first, const std::array<P3, 3>& p) const {
    if constexpr (shapes == CellShapes::boxes) return p;
    std::array<P3, 3> sums{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j) {
        const P factor = constant_(first + 1 + 3 * k + j, cell);
        for (std::size_t i = 0; i < 3; ++i) sums[k][i] += p[j][i] * factor;
      }
    return sums;
  }

  const HexahedronBlock<Real>& block_;
  Constants<Real, shapes> constant_;
};

template <class Real>
void add_drag(const HexahedronBlock<Real>& block,
              const dynamics::BlockArrays<Real>& arrays) {
  for (std::size_t s = 0; s < arrays.rows * arrays.lanes; s += width<Real>)
    for (std::size_t i = 0; i < 3; ++i)
      store(arrays.force[i] + s,
            load(arrays.force[i] + s) -
                load(block.drag.data() + s) * load(arrays.velocity[i] + s));
}

template <class Real, HexahedronKind kind>
void forces(const HexahedronBlock<Real>& block,
            const dynamics::BlockArrays<Real>& arrays) {
  using Cells = std::conditional_t<kind.one_point, OnePoint<Real, kind.shapes>,
                                   EightPoints<Real, kind.shapes>>;
  if (!block.drag.empty()) add_drag(block, arrays);
  CellFields<Real, 3, 3> fields;
  for (std::size_t i = 0; i < 3; ++i) {
    fields.from[i] = arrays.displacement[block.axes[i]];
    fields.to[i] = arrays.force[block.axes[i]];
  }
  for_each_cell_pack<kind.in_grid>(block.cells, arrays, fields, Cells(block));
}

template <class Real, bool one_point>
HexahedronForces<Real> choose(const HexahedronKind& kind) {
  if (!kind.in_grid)
    return forces<Real, HexahedronKind{one_point, false, CellShapes::hexahedra}>;
  switch (kind.shapes) {
    case CellShapes::boxes:
      return forces<Real, HexahedronKind{one_point, true, CellShapes::boxes}>;
    case CellShapes::parallelepipeds:
      return forces<Real, HexahedronKind{one_point, true, CellShapes::parallelepipeds}>;
    case CellShapes::hexahedra:
      break;
  }
  return forces<Real, HexahedronKind{one_point, true, CellShapes::hexahedra}>;
}

}  // namespace

HexahedronForces<double> hexahedron_forces(const HexahedronKind& kind, double) {
  return kind.one_point ? choose<double, true>(kind) : choose<double, false>(kind);
}
HexahedronForces<float> hexahedron_forces(const HexahedronKind& kind, float) {
  return kind.one_point ? choose<float, true>(kind) : choose<float, false>(kind);
}

}  // namespace springcheck::fem_reference::SPRINGCHECK_PATH
