#pragma once

#include <limits>

#include "dynamics/blocks/pack_vectors.hpp"

// What the kernels of springs share: included, like pack.hpp, by files compiled once per
// instruction set.
namespace springcheck::mss::SPRINGCHECK_PATH {

/// The number added to a length's square [m^2]: it is nothing beside any length, and with
/// it a length of zero is no division by zero and pulls nowhere.
template <class Real>
inline constexpr Real tiny_square = Real(1e-36);

/// c = 2 zeta sqrt(k/inverse_masses), inverse_masses the sum 1/m_a + 1/m_b, written so
/// that k = 0 is no division by 0.
template <class Real>
[[gnu::always_inline]] inline dynamics::SPRINGCHECK_PATH::Pack<Real> dashpot(
    const dynamics::SPRINGCHECK_PATH::Pack<Real>& k,
    const dynamics::SPRINGCHECK_PATH::Pack<Real>& inverse_masses,
    Real twice_damping_ratio) {
  using namespace dynamics::SPRINGCHECK_PATH;
  return twice_damping_ratio * k *
         reciprocal_root<Real>(
             larger<Real>(k * inverse_masses, all(std::numeric_limits<Real>::min())));
}

/// A matrix by columns, as everywhere in kernels.
template <class Real>
using PackMatrix = std::array<dynamics::SPRINGCHECK_PATH::Pack3<Real>, 3>;

template <class Real>
struct PackVolume {
  PackMatrix<Real> cofactor;                      // cof F
  dynamics::SPRINGCHECK_PATH::Pack<Real> change;  // det F - 1
};

/// The same numbers for squared lengths: F in place of cof F, and tr E = tr H + |H|^2/2.
template <class Real>
[[gnu::always_inline]] inline PackVolume<Real> trace_of(const PackMatrix<Real>& h) {
  using dynamics::SPRINGCHECK_PATH::dot;
  PackMatrix<Real> f = h;
  for (std::size_t i = 0; i < 3; ++i) f[i][i] += Real(1);
  return {f, h[0][0] + h[1][1] + h[2][2] +
                 Real(0.5) * (dot<Real>(h[0], h[0]) + dot<Real>(h[1], h[1]) +
                              dot<Real>(h[2], h[2]))};
}

/// The cofactor and the change of volume of F = I + H. With the columns f of F and h of
/// H, det F - 1 = h1.(f2 x f3) + h2.(f3 x e1) + h3.(e1 x e2), which keeps the digits of
/// small changes.
template <class Real>
[[gnu::always_inline]] inline PackVolume<Real> volume_of(const PackMatrix<Real>& h) {
  using dynamics::SPRINGCHECK_PATH::cross;
  PackMatrix<Real> f = h;
  for (std::size_t i = 0; i < 3; ++i) f[i][i] += Real(1);
  const PackMatrix<Real> cofactor{cross<Real>(f[1], f[2]), cross<Real>(f[2], f[0]),
                                  cross<Real>(f[0], f[1])};
  return {cofactor, dynamics::SPRINGCHECK_PATH::dot<Real>(h[0], cofactor[0]) +
                        (h[1][1] * f[2][2] - h[1][2] * f[2][1]) + h[2][2]};
}

}  // namespace springcheck::mss::SPRINGCHECK_PATH
