#pragma once

#include <array>

#include "dynamics/blocks/pack.hpp"

// Vectors in space of packs: included, like pack.hpp, by files compiled once per
// instruction set.
namespace springcheck::dynamics::SPRINGCHECK_PATH {

template <class Real>
using Pack3 = std::array<Pack<Real>, 3>;

template <class Real>
[[gnu::always_inline]] inline Pack<Real> dot(const Pack3<Real>& a, const Pack3<Real>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Real>
[[gnu::always_inline]] inline Pack3<Real> cross(const Pack3<Real>& a,
                                                const Pack3<Real>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}

}  // namespace springcheck::dynamics::SPRINGCHECK_PATH
