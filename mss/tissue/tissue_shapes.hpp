#pragma once

#include "dynamics/blocks/cell_packs.hpp"
#include "mss/kernels/pack_deformation.hpp"
#include "mss/tissue/tissue_block.hpp"

// The shapes of cells of living tissue: included, like pack.hpp, by files compiled once
// per instruction set.
namespace springcheck::mss::SPRINGCHECK_PATH {

using namespace dynamics::SPRINGCHECK_PATH;
using P = Pack<double>;
using P3 = Pack3<double>;
using Matrix = PackMatrix<double>;
using Corners = std::array<CornerPacks<double>, 3>;  // by component

/// Sums over the corners with signs: for each bit that an index has, corners whose bit is
/// 0 count negative. Sums 1, 2 and 4 are four times the mean edges, 3, 5, 6 and 7 the
/// hourglasses of a parallelepiped.
[[gnu::always_inline]] inline CornerPacks<double> sums_with_signs(CornerPacks<double> u) {
  for (std::size_t bit = 1; bit < 8; bit *= 2)
    for (std::size_t c = 0; c < 8; ++c) {
      if ((c & bit) != 0) continue;
      const P a = u[c], b = u[c + bit];
      u[c] = b + a;
      u[c + bit] = b - a;
    }
  return u;
}

/// The transpose of that.
[[gnu::always_inline]] inline CornerPacks<double> at_corners_with_signs(
    CornerPacks<double> sums) {
  for (std::size_t bit = 1; bit < 8; bit *= 2)
    for (std::size_t c = 0; c < 8; ++c) {
      if ((c & bit) != 0) continue;
      const P a = sums[c], b = sums[c + bit];
      sums[c] = a - b;
      sums[c + bit] = a + b;
    }
  return sums;
}

/// Cells of a grid that are all the same parallelepiped.
class AlikeShapes {
 public:
  explicit AlikeShapes(const TissueBlock& block) : block_(block) {}

  /// What a field at the corners is made of.
  using Parts = Corners;

  [[gnu::always_inline]] static Parts parts(std::size_t, const Corners& u) {
    return {sums_with_signs(u[0]), sums_with_signs(u[1]), sums_with_signs(u[2])};
  }

  /// sum u_a (x) G_a.
  [[gnu::always_inline]] Matrix gradient(std::size_t cell, const Parts& u) const {
    const P quarter = 0.25 * from_bytes<double>(block_.is_cell.data() + cell);
    Matrix h{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        const P move = quarter * u[i][std::size_t{1} << k];
        for (std::size_t j = 0; j < 3; ++j) h[j][i] += move * direction(k, j);
      }
    return h;
  }

  /// f = - V stress G_a - c/S_m mean (P u)_a.
  [[gnu::always_inline]] Corners forces(std::size_t cell, const Matrix& stress,
                                        const P& mean, const Parts& u) const {
    const P exists = from_bytes<double>(block_.is_cell.data() + cell);
    const P quarter = -0.25 * block_.constants[0] * exists;
    const P bending = -0.125 * block_.constants[1] * exists * mean;
    Corners f;
    for (std::size_t i = 0; i < 3; ++i) {
      CornerPacks<double> sums{};
      for (std::size_t k = 0; k < 3; ++k)
        sums[std::size_t{1} << k] =
            quarter * (stress[0][i] * direction(k, 0) + stress[1][i] * direction(k, 1) +
                       stress[2][i] * direction(k, 2));
      for (const std::size_t m : {3, 5, 6, 7}) sums[m] = bending * u[i][m];
      f[i] = at_corners_with_signs(sums);
    }
    return f;
  }

 private:
  [[nodiscard]] double direction(std::size_t k, std::size_t j) const {
    return block_.constants[2 + 3 * k + j];
  }

  const TissueBlock& block_;
};

/// Cells each of their own shape.
class OwnShapes {
 public:
  explicit OwnShapes(const TissueBlock& block) : block_(block) {}

  struct Parts {
    Corners from_first;                     // of corner 0
    std::array<std::array<P, 4>, 3> bends;  // along the four vectors
  };

  [[gnu::always_inline]] Parts parts(std::size_t cell, const Corners& u) const {
    Parts all{.from_first = u, .bends = {}};
    for (std::size_t i = 0; i < 3; ++i)
      for (P& move : all.from_first[i]) move -= u[i][0];
    for (std::size_t m = 0; m < 4; ++m)
      for (std::size_t a = 1; a < 8; ++a) {
        const P along = constant(23 + 8 * m + a, cell);
        for (std::size_t i = 0; i < 3; ++i)
          all.bends[i][m] += along * all.from_first[i][a];
      }
    return all;
  }

  [[gnu::always_inline]] Matrix gradient(std::size_t cell, const Parts& u) const {
    Matrix h{};
    for (std::size_t a = 1; a < 8; ++a)
      for (std::size_t j = 0; j < 3; ++j) {
        const P g = constant(3 * a - 1 + j, cell);
        for (std::size_t i = 0; i < 3; ++i) h[j][i] += u.from_first[i][a] * g;
      }
    return h;
  }

  [[gnu::always_inline]] Corners forces(std::size_t cell, const Matrix& stress,
                                        const P& mean, const Parts& u) const {
    const P volume = constant(0, cell), bending = constant(1, cell) * mean;
    Corners f{};
    for (std::size_t a = 1; a < 8; ++a)
      for (std::size_t j = 0; j < 3; ++j) {
        const P g = volume * constant(3 * a - 1 + j, cell);
        for (std::size_t i = 0; i < 3; ++i) {
          const P push = stress[j][i] * g;
          f[i][a] -= push;
          f[i][0] += push;
        }
      }
    for (std::size_t m = 0; m < 4; ++m)
      for (std::size_t a = 0; a < 8; ++a) {
        const P along = bending * constant(23 + 8 * m + a, cell);
        for (std::size_t i = 0; i < 3; ++i) f[i][a] -= along * u.bends[i][m];
      }
    return f;
  }

 private:
  [[gnu::always_inline]] P constant(std::size_t n, std::size_t cell) const {
    return load(block_.constants.data() + cell * own_tissue_constants +
                n * width<double>);
  }

  const TissueBlock& block_;
};

}  // namespace springcheck::mss::SPRINGCHECK_PATH
