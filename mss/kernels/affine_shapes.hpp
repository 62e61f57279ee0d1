#pragma once

#include "dynamics/blocks/cell_packs.hpp"
#include "mss/kernels/affine_block.hpp"
#include "mss/kernels/pack_deformation.hpp"

// The shapes of cells that affine springs lead through: included, like pack.hpp, by files
// compiled once per instruction set.
namespace springcheck::mss::SPRINGCHECK_PATH {

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
class AffineShapes {
  using P = Pack<Real>;
  using P3 = Pack3<Real>;

 public:
  explicit AffineShapes(const AffineBlock<Real>& block) : block_(block) {}

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

  /// The edge X_k of alike cells; grad xi_k follows.
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

  /// Adds the forces of alike cells. With S = V P - sum c F r (x) r and G_a = sum +-grad
  /// xi_k/4 they are f_a = -sum +-S grad xi_k/4, where r.grad xi_k is 0, 1 or -1.
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

}  // namespace springcheck::mss::SPRINGCHECK_PATH
