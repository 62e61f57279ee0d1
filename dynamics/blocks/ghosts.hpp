#pragma once

#include "dynamics/blocks/block_state.hpp"
#include "dynamics/blocks/pack.hpp"

namespace springcheck::dynamics::SPRINGCHECK_PATH {

/// Ghost row t, t = k rows + t', stands for row t' of the lanes k further on: lane l for
/// its lane l + k. Lanes that would need more than there are hold any finite number, and
/// add nothing.
template <class Real, class Visit>
inline void for_each_ghost(const BlockArrays<Real>& arrays, const Visit& visit) {
  std::size_t row = 0, further = 1;
  for (std::size_t t = arrays.rows; t < arrays.rows + arrays.ghosts; ++t) {
    visit(t * arrays.lanes, row * arrays.lanes + further);
    if (++row < arrays.rows) continue;
    row = 0;
    ++further;
  }
}

/// Copies what lanes need of the next ones; one register per row.
template <class Real, std::size_t components>
inline void fill_ghosts(const BlockArrays<Real>& arrays,
                        const std::array<Real*, components>& field) {
  for_each_ghost(arrays, [&](std::size_t ghost, std::size_t original) {
    for (Real* const component : field)
      store(component + ghost, load(component + original));
  });
}

/// Adds what lanes did to their ghosts to where it belongs.
template <class Real, std::size_t components>
inline void fold_ghosts(const BlockArrays<Real>& arrays,
                        const std::array<Real*, components>& field) {
  for_each_ghost(arrays, [&](std::size_t ghost, std::size_t original) {
    for (Real* const component : field)
      store(component + original, load(component + original) + load(component + ghost));
  });
}

}  // namespace springcheck::dynamics::SPRINGCHECK_PATH
