#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>

#include "dynamics/blocks.hpp"

namespace springcheck::dynamics {

/// Where a block's numbers are: one array per component, an entry per slot. Every array
/// may be read for reach() entries before and after it, where there are zeros; forces may
/// be written there, and mean nothing.
template <class Real>
struct BlockArrays {
  std::size_t slots;
  std::array<Real*, 3> displacement;  // u [m]; 0 in empty slots
  std::array<Real*, 3> velocity;      // [m/s]
  std::array<Real*, 3> force;         // [N]
  std::array<Real*, 3> load;          // [N] at the full load; null where there is none
  Real* inverse_mass;                 // [1/kg]; 0 in empty slots
};

enum class Load { none, some };

/// Memory of a block's arrays, aligned to registers and filled with zeros.
template <class Real>
class BlockState {
 public:
  BlockState(const Block& block, Load load);

  /// Slots between the furthest corners of a cell, in any direction, and a register more.
  static std::size_t reach(const Block& block);

  [[nodiscard]] const BlockArrays<Real>& arrays() const { return arrays_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  void clear_forces();

 private:
  struct Free {
    void operator()(void* memory) const;
  };
  std::size_t bytes_, stride_, reach_;
  std::unique_ptr<void, Free> memory_;
  BlockArrays<Real> arrays_;
};

extern template class BlockState<float>;
extern template class BlockState<double>;

/// Writes the internal forces of a block's cells, springs or other, from displacements
/// and velocities; the forces are zero before. Called for different blocks at the same
/// time.
template <class Real>
using BlockForces =
    std::function<void(std::size_t block, const BlockArrays<Real>& arrays)>;

}  // namespace springcheck::dynamics
