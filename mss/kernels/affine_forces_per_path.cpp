// Compiled once per instruction set.
#include <limits>

#include "dynamics/blocks/cell_packs.hpp"
#include "mss/kernels/affine_forces_paths.hpp"
#include "mss/kernels/pack_deformation.hpp"

namespace springcheck::mss::SPRINGCHECK_PATH {
namespace {

using namespace dynamics::SPRINGCHECK_PATH;

/// Vectors at the corners, by component.
template <class Real>
using Corners = std::array<CornerPacks<Real>, 3>;

/// F r of an affine spring's rest vector r, H r and |F r|^2.
template <class Real>
struct AffineRest {
  Pack3<Real> vector, move;
  Pack<Real> square;
};

template <class Real>
[[gnu::always_inline]] inline AffineRest<Real> affine_rest(const Pack3<Real>& r,
                                                           const Pack3<Real>& move) {
  AffineRest<Real> rest{.vector = {}, .move = move, .square = {}};
  for (std::size_t i = 0; i < 3; ++i) rest.vector[i] = r[i] + move[i];
  rest.square = dot<Real>(rest.vector, rest.vector) + tiny_square<Real>;
  return rest;
}

/// The cells' constants, see AffineBlock, and what is made of them.
template <class Real, bool alike>
class Shapes {
  using P = Pack<Real>;
  using P3 = Pack3<Real>;

 public:
  explicit Shapes(const AffineBlock<Real>& block) : block_(block) {}

  [[gnu::always_inline]] P volume(std::size_t cell) const {
    return is_cell(cell) * constant(0, cell);
  }

  [[gnu::always_inline]] PackMatrix<Real> displacement_gradient(
      std::size_t cell, const Corners<Real>& u) const {
    PackMatrix<Real> h{};
    if constexpr (alike) {
      for (std::size_t k = 0; k < 3; ++k) {
        const P3 move = mean_move(k, u), g = gradient(k, cell);
        for (std::size_t j = 0; j < 3; ++j)
          for (std::size_t i = 0; i < 3; ++i) h[j][i] += move[i] * g[j];
      }
    } else {
      for (std::size_t a = 1; a < 8; ++a) {
        const P3 g = constants(3 * a - 2, cell);
        for (std::size_t i = 0; i < 3; ++i) {
          const P move = u[i][a] - u[i][0];
          for (std::size_t j = 0; j < 3; ++j) h[j][i] += move * g[j];
        }
      }
    }
    return h;
  }

  /// Calls pull(spring, k, rest) for every spring, which adds its pull to the forces on
  /// the corners and returns what times F r (x) r its affine rest takes from the stress;
  /// then adds to the forces those of the stress [J], f_a -= V P G_a.
  template <class Pull>
  [[gnu::always_inline]] void add_forces(std::size_t cell, const PackMatrix<Real>& h,
                                         PackMatrix<Real>& stress, const Corners<Real>& u,
                                         Corners<Real>& f, const Pull& pull) const {
    if constexpr (alike)
      add_forces_alike(cell, stress, u, f, pull);
    else
      add_forces_varied(cell, h, stress, f, pull);
  }

 private:
  [[gnu::always_inline]] P constant(std::size_t n, std::size_t cell) const {
    if constexpr (alike)
      return all(block_.constants[n]);
    else
      return load(block_.constants.data() + n * block_.cells.count + cell);
  }
  [[gnu::always_inline]] P3 constants(std::size_t n, std::size_t cell) const {
    return {constant(n, cell), constant(n + 1, cell), constant(n + 2, cell)};
  }
  [[gnu::always_inline]] P is_cell(std::size_t cell) const {
    if constexpr (alike)
      return from_bytes<Real>(block_.is_cell.data() + cell);
    else
      return all(Real(1));
  }

  /// X_k and grad xi_k of alike cells.
  [[gnu::always_inline]] P3 edge(std::size_t k, std::size_t cell) const {
    return constants(1 + 6 * k, cell);
  }
  [[gnu::always_inline]] P3 gradient(std::size_t k, std::size_t cell) const {
    return constants(4 + 6 * k, cell);
  }

  /// H X_k of alike cells: the mean of what happens to the edges.
  [[gnu::always_inline]] static P3 mean_move(std::size_t k, const Corners<Real>& u) {
    P3 move{};
    for (std::size_t s = 4 * k; s < 4 * k + 4; ++s)
      for (std::size_t i = 0; i < 3; ++i)
        move[i] += u[i][affine_springs[s][1]] - u[i][affine_springs[s][0]];
    for (P& m : move) m *= Real(.25);
    return move;
  }

  /// With S = V P - sum c F r (x) r and G_a = sum +-grad xi_k/4: f_a = -sum +-S grad
  /// xi_k/4, and r.grad xi_k is 0, 1 or -1.
  template <class Pull>
  [[gnu::always_inline]] void add_forces_alike(std::size_t cell,
                                               const PackMatrix<Real>& stress,
                                               const Corners<Real>& u, Corners<Real>& f,
                                               const Pull& pull) const {
    const P exists = is_cell(cell);
    std::array<P3, 3> x, move, push;  // push: S grad xi_k
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = edge(k, cell);
      move[k] = mean_move(k, u);
      const P3 g = gradient(k, cell);
      for (std::size_t i = 0; i < 3; ++i)
        push[k][i] = stress[0][i] * g[0] + stress[1][i] * g[1] + stress[2][i] * g[2];
    }
#pragma GCC unroll 3
    for (std::size_t k = 0; k < 3; ++k) {
      const AffineRest<Real> rest = affine_rest<Real>(x[k], move[k]);
      const P stiffness = exists * constant(19 + k, cell);
      P taken{};
      for (std::size_t s = 4 * k; s < 4 * k + 4; ++s) taken += pull(s, stiffness, rest);
      for (std::size_t i = 0; i < 3; ++i) push[k][i] -= taken * rest.vector[i];
    }
#pragma GCC unroll 3
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      const auto add_diagonals = [&](std::size_t first, const P& sign) {
        P3 r, m;
        for (std::size_t i = 0; i < 3; ++i) {
          r[i] = x[a][i] + sign * x[b][i];
          m[i] = move[a][i] + sign * move[b][i];
        }
        const AffineRest<Real> rest = affine_rest<Real>(r, m);
        const P stiffness = exists * constant(22 + (first - 12) / 2, cell);
        const P taken = pull(first, stiffness, rest) + pull(first + 1, stiffness, rest);
        for (std::size_t i = 0; i < 3; ++i) {
          push[a][i] -= taken * rest.vector[i];
          push[b][i] -= sign * taken * rest.vector[i];
        }
      };
      add_diagonals(12 + 4 * k, all(Real(1)));
      add_diagonals(14 + 4 * k, all(Real(-1)));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const P p = Real(.25) * push[0][i], q = Real(.25) * push[1][i],
              r = Real(.25) * push[2][i];
      const std::array<P, 4> sums{p + q + r, q + r - p, p + r - q, r - p - q};
      for (std::size_t c = 0; c < 4; ++c) {  // opposite corners have opposite signs
        f[i][c] += sums[c];
        f[i][7 - c] -= sums[c];
      }
    }
  }

  template <class Pull>
  [[gnu::always_inline]] void add_forces_varied(std::size_t cell,
                                                const PackMatrix<Real>& h,
                                                PackMatrix<Real>& stress,
                                                Corners<Real>& f,
                                                const Pull& pull) const {
    const auto place = [&](std::size_t a) {
      return a == 0 ? P3{} : constants(19 + 3 * a, cell);
    };
#pragma GCC unroll 24
    for (std::size_t s = 0; s < 24; ++s) {
      const P3 from = place(affine_springs[s][0]), to = place(affine_springs[s][1]);
      P3 r, move;
      for (std::size_t i = 0; i < 3; ++i) r[i] = to[i] - from[i];
      for (std::size_t i = 0; i < 3; ++i)
        move[i] = h[0][i] * r[0] + h[1][i] * r[1] + h[2][i] * r[2];
      const AffineRest<Real> rest = affine_rest<Real>(r, move);
      const P taken = pull(s, constant(43 + s, cell), rest);
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i) stress[j][i] -= taken * r[j] * rest.vector[i];
    }
    for (std::size_t a = 1; a < 8; ++a) {
      const P3 g = constants(3 * a - 2, cell);
      for (std::size_t i = 0; i < 3; ++i) {
        const P push = stress[0][i] * g[0] + stress[1][i] * g[1] + stress[2][i] * g[2];
        f[i][a] -= push;
        f[i][0] += push;
      }
    }
  }

  const AffineBlock<Real>& block_;
};

/// 2 E = H + H^T + H^T H, which keeps the digits of small strains.
template <class Real>
[[gnu::always_inline]] inline PackMatrix<Real> twice_green(const PackMatrix<Real>& h) {
  PackMatrix<Real> e;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i <= j; ++i)
      e[j][i] = e[i][j] = h[j][i] + h[i][j] + dot<Real>(h[i], h[j]);
  return e;
}

/// Adds F S to the stress, S symmetric.
template <class Real>
[[gnu::always_inline]] inline void add_product(const PackMatrix<Real>& h,
                                               const PackMatrix<Real>& s,
                                               PackMatrix<Real>& stress) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 3; ++i)
      stress[j][i] +=
          s[j][i] + (h[0][i] * s[j][0] + h[1][i] * s[j][1] + h[2][i] * s[j][2]);
}

/// 1 - 1/|F n| of an axis with |F n|^2 - 1 = e: e over |F n|^2 + |F n|. Below the lengths
/// that rounding leaves of F n it stays as it is.
template <class Real>
[[gnu::always_inline]] inline Pack<Real> strain_over_length(const Pack<Real>& e) {
  const Pack<Real> square =
      larger<Real>(all(Real(1)) + e, all(16 * std::numeric_limits<Real>::epsilon()));
  return e * reciprocal<Real>(square + square * reciprocal_root<Real>(square));
}

/// Adds modulus sum (1 - 1/|F n|) n (x) n to s, over the axes n = (a, +-b, 0) and cyclic.
template <class Real>
[[gnu::always_inline]] inline void add_rectangles(const PackMatrix<Real>& e, Real a,
                                                  Real b, const Pack<Real>& modulus,
                                                  PackMatrix<Real>& s) {
#pragma GCC unroll 3
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const Pack<Real> mean = a * a * e[k][k] + b * b * e[next][next],
                     shear = 2 * a * b * e[k][next];
    const Pack<Real> one = strain_over_length<Real>(mean + shear),
                     other = strain_over_length<Real>(mean - shear);
    const Pack<Real> sum = modulus * (one + other);
    s[k][k] += a * a * sum;
    s[next][next] += b * b * sum;
    s[k][next] += a * b * (modulus * (one - other));
  }
}

/// The same over the axes (1, 1, 1)/sqrt 3 and its reflections.
template <class Real>
[[gnu::always_inline]] inline void add_diagonals(const PackMatrix<Real>& e,
                                                 const Pack<Real>& modulus,
                                                 PackMatrix<Real>& s) {
  constexpr Real third = Real(1) / 3;
  const Pack<Real> mean = third * (e[0][0] + e[1][1] + e[2][2]);
  std::array<Pack<Real>, 4> pull;
  for (std::size_t d = 0; d < 4; ++d) {
    const Real x = d & 1U ? -1 : 1, y = d & 2U ? -1 : 1;
    pull[d] = strain_over_length<Real>(
        mean + 2 * third * (x * y * e[0][1] + y * e[1][2] + x * e[2][0]));
  }
  const Pack<Real> part = third * modulus;
  const Pack<Real> sum = part * (pull[0] + pull[1] + pull[2] + pull[3]);
  for (std::size_t i = 0; i < 3; ++i) s[i][i] += sum;
  s[0][1] += part * (pull[0] - pull[1] - pull[2] + pull[3]);
  s[1][2] += part * (pull[0] + pull[1] - pull[2] - pull[3]);
  s[2][0] += part * (pull[0] - pull[1] + pull[2] - pull[3]);
}

/// Of the virtual springs: adds F S, S = sum modulus (1 - 1/|F n|) n (x) n over the axes
/// of the icosahedron, and where they have a modulus of the dodecahedron dual to it.
template <class Real>
[[gnu::always_inline]] inline void add_axis_stress(const PackMatrix<Real>& h,
                                                   const Pack<Real>& volume,
                                                   const AffineBlock<Real>& block,
                                                   PackMatrix<Real>& stress) {
  // phi/sqrt(1 + phi^2), 1/sqrt(1 + phi^2); phi/sqrt 3, 1/(phi sqrt 3).
  constexpr Real phi = Real(0.850650808352039932181540497063011072),
                 one = Real(0.525731112119133606025669084847876607),
                 long_side = Real(0.934172358962715696451118623548450529),
                 short_side = Real(0.356822089773089931941969843046087873);
  const PackMatrix<Real> e = twice_green<Real>(h);
  PackMatrix<Real> s{};  // above the diagonal, cyclic
  add_rectangles<Real>(e, phi, one, volume * block.axis_modulus, s);
  if (block.dual_axis_modulus != 0) {
    const Pack<Real> modulus = volume * block.dual_axis_modulus;
    add_rectangles<Real>(e, short_side, long_side, modulus, s);
    add_diagonals<Real>(e, modulus, s);
  }
  for (std::size_t k = 0; k < 3; ++k) s[(k + 1) % 3][k] = s[k][(k + 1) % 3];
  add_product<Real>(h, s, stress);
}

/// The same in squared lengths: S = modulus (2 E + tr E I), which is what their sum is
/// along the axes of any isotropic rule.
template <class Real>
[[gnu::always_inline]] inline void add_st_venant_stress(const PackMatrix<Real>& h,
                                                        const Pack<Real>& modulus,
                                                        PackMatrix<Real>& stress) {
  PackMatrix<Real> s = twice_green<Real>(h);
  const Pack<Real> trace = Real(.5) * (s[0][0] + s[1][1] + s[2][2]);
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 3; ++i) s[j][i] *= modulus;
  for (std::size_t i = 0; i < 3; ++i) s[i][i] += modulus * trace;
  add_product<Real>(h, s, stress);
}

template <class Real, AffineKind kind>
class CellForces {
  using P = Pack<Real>;
  using P3 = Pack3<Real>;

 public:
  explicit CellForces(const AffineBlock<Real>& block) : block_(block), shapes_(block) {}

  /// Of what the cells read: displacements, velocities, pressures.
  static constexpr std::size_t velocity = 3, pressure = kind.dashpots ? 6 : 3,
                               read =
                                   pressure + (kind.correction == Correction::of_patches);

  template <class Cells>
  [[gnu::always_inline]] void operator()(std::size_t cell, Cells& cells) const {
    Corners<Real> u, v, f{};
    for (std::size_t i = 0; i < 3; ++i) {
      u[i] = cells.at_corners(i);
      if constexpr (kind.dashpots) v[i] = cells.at_corners(velocity + i);
    }
    const PackMatrix<Real> h = shapes_.displacement_gradient(cell, u);
    PackMatrix<Real> stress{};  // V P
    const P volume = shapes_.volume(cell);
    if constexpr (kind.squared)
      add_st_venant_stress<Real>(h, volume * block_.axis_modulus, stress);
    else
      add_axis_stress<Real>(h, volume, block_, stress);
    if constexpr (kind.correction != Correction::none) {
      const auto [cofactor, change] =
          kind.squared ? trace_of<Real>(h) : volume_of<Real>(h);
      P push{};
      if constexpr (kind.correction == Correction::of_patches) {
        for (const P part : cells.at_corners(pressure)) push += part;
      } else {
        push = block_.volume_modulus * change;
      }
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i)
          stress[j][i] += volume * push * cofactor[j][i];
    }
    shapes_.add_forces(
        cell, h, stress, u, f,
        [&](std::size_t s, const P& stiffness, const AffineRest<Real>& rest)
            __attribute__((always_inline)) {
              return pull(cell, s, stiffness, rest, u, v, f);
            });
    for (std::size_t i = 0; i < 3; ++i) cells.add_at_corners(i, f[i]);
  }

 private:
  /// With the lengths l and L = |F r|: adds k (l - L) d/l to the forces and returns
  /// k (l - L)/L; in squared lengths adds t d and returns t = k/(2 r^2) (l^2 - L^2). l -
  /// L = w.(d + F r)/(l + L), w = d - F r, keeps the digits of small ones; 1/(l^2 + l L)
  /// and 1/(L^2 + l L) come of one reciprocal.
  [[gnu::always_inline]] P pull(std::size_t cell, std::size_t s, const P& stiffness,
                                const AffineRest<Real>& rest, const Corners<Real>& u,
                                const Corners<Real>& v, Corners<Real>& f) const {
    const auto [a, b] = affine_springs[s];
    P3 d;
    P excess{};
    for (std::size_t i = 0; i < 3; ++i) {
      const P w = u[i][b] - u[i][a] - rest.move[i];
      d[i] = rest.vector[i] + w;
      excess += w * (d[i] + rest.vector[i]);
    }
    constexpr Real least = std::numeric_limits<Real>::min();
    const P square = dot<Real>(d, d) + tiny_square<Real>;
    P factor, taken;
    if constexpr (kind.squared) {
      factor = taken = stiffness * excess;
    } else {
      const P squares = square * rest.square;
      const P both = squares * reciprocal_root<Real>(larger<Real>(squares, all(least)));
      const P first = square + both, second = rest.square + both;
      const P tension =
          stiffness * excess * reciprocal<Real>(larger<Real>(first * second, all(least)));
      factor = tension * second;
      taken = tension * first;
    }
    if constexpr (kind.dashpots)
      if (s < 12) {
        P approach{};
        for (std::size_t i = 0; i < 3; ++i) approach += (v[i][b] - v[i][a]) * d[i];
        factor += load(block_.dashpots.data() + s * block_.cells.count + cell) *
                  approach * reciprocal<Real>(square);
      }
    for (std::size_t i = 0; i < 3; ++i) {
      const P along = factor * d[i];
      f[i][a] += along;
      f[i][b] -= along;
    }
    return taken;
  }

  const AffineBlock<Real>& block_;
  Shapes<Real, kind.alike> shapes_;
};

template <class Real, AffineKind kind>
void forces(const AffineBlock<Real>& block, const dynamics::BlockArrays<Real>& arrays) {
  using Cells = CellForces<Real, kind>;
  CellFields<Real, Cells::read, 3> fields{.from = {}, .to = arrays.force};
  for (std::size_t i = 0; i < 3; ++i) {
    fields.from[i] = arrays.displacement[i];
    if constexpr (kind.dashpots) fields.from[Cells::velocity + i] = arrays.velocity[i];
  }
  if constexpr (kind.correction == Correction::of_patches) {
    for (std::size_t s = 0; s < arrays.rows * arrays.lanes; s += width<Real>)
      store(arrays.nodal_sum + s,
            load(arrays.nodal_sum + s) * load(block.pressure_per_sum.data() + s));
    fields.from[Cells::pressure] = arrays.nodal_sum;
  }
  for_each_cell_pack<kind.in_grid>(block.cells, arrays, fields, Cells(block));
}

/// The sums over cells of V t, t the change of volume.
template <class Real, bool in_grid, bool alike, bool squared>
void volume_sums(const AffineBlock<Real>& block,
                 const dynamics::BlockArrays<Real>& arrays) {
  const CellFields<Real, 3, 1> fields{.from = arrays.displacement,
                                      .to = {arrays.nodal_sum}};
  const Shapes<Real, alike> shapes(block);
  for_each_cell_pack<
      in_grid>(block.cells, arrays, fields, [&](std::size_t cell, auto& cells) {
    const Corners<Real> u{cells.at_corners(0), cells.at_corners(1), cells.at_corners(2)};
    const PackMatrix<Real> h = shapes.displacement_gradient(cell, u);
    CornerPacks<Real> change;
    change.fill(shapes.volume(cell) *
                (squared ? trace_of<Real>(h) : volume_of<Real>(h)).change);
    cells.add_at_corners(0, change);
  });
}

template <class Real, bool in_grid, bool alike, Correction correction, bool squared>
AffineFunctions<Real> chosen(bool dashpots) {
  return {.forces =
              dashpots
                  ? forces<Real, AffineKind{in_grid, alike, correction, squared, true}>
                  : forces<Real, AffineKind{in_grid, alike, correction, squared, false}>,
          .volume_sums = correction == Correction::of_patches
                             ? volume_sums<Real, in_grid, alike, squared>
                             : nullptr};
}

template <class Real, bool in_grid, bool alike, Correction correction>
AffineFunctions<Real> chosen(const AffineKind& kind) {
  return kind.squared ? chosen<Real, in_grid, alike, correction, true>(kind.dashpots)
                      : chosen<Real, in_grid, alike, correction, false>(kind.dashpots);
}

template <class Real, bool in_grid, bool alike>
AffineFunctions<Real> chosen(const AffineKind& kind) {
  switch (kind.correction) {
    case Correction::none:
      return chosen<Real, in_grid, alike, Correction::none>(kind);
    case Correction::of_cells:
      return chosen<Real, in_grid, alike, Correction::of_cells>(kind);
    case Correction::of_patches:
      break;
  }
  return chosen<Real, in_grid, alike, Correction::of_patches>(kind);
}

template <class Real>
AffineFunctions<Real> chosen(const AffineKind& kind) {
  if (kind.alike) return chosen<Real, true, true>(kind);
  return kind.in_grid ? chosen<Real, true, false>(kind)
                      : chosen<Real, false, false>(kind);
}

}  // namespace

AffineFunctions<double> affine_functions(const AffineKind& kind, double) {
  return chosen<double>(kind);
}
AffineFunctions<float> affine_functions(const AffineKind& kind, float) {
  return chosen<float>(kind);
}

}  // namespace springcheck::mss::SPRINGCHECK_PATH
