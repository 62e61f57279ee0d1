#pragma once

#include <limits>

#include "mss/kernels/affine_block.hpp"
#include "mss/kernels/pack_deformation.hpp"

// The stress of virtual springs: included, like pack.hpp, by files compiled once per
// instruction set.
namespace springcheck::mss::SPRINGCHECK_PATH {

using namespace dynamics::SPRINGCHECK_PATH;

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

/// Adds F S of the virtual springs to the stress, where S = sum modulus (1 - 1/|F n|) n
/// (x) n over the axes of the icosahedron and, where they have a modulus, of the
/// dodecahedron dual to it.
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

}  // namespace springcheck::mss::SPRINGCHECK_PATH
