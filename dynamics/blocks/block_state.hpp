#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>

#include "dynamics/blocks/blocks.hpp"

namespace springcheck::dynamics {

/// The arrays of a block's numbers, one per component. The slots are dealt out to lanes
/// in consecutive runs of `rows`, and the lanes stand side by side: slot s is the element
/// (s mod rows) lanes + s / rows. A step of n slots thus is a step of n rows for all
/// lanes at once, from registers to registers, whatever n; only at the end of the runs it
/// leads into the next lane. There every array goes on for `ghosts` rows more, in which
/// each lane finds again what the next lanes have: see fill_ghosts and fold_ghosts.
template <class Real>
struct BlockArrays {
  std::size_t rows, lanes, ghosts;
  std::array<Real*, 3> displacement;  // u [m]; 0 in empty slots
  std::array<Real*, 3> velocity;      // [m/s]
  std::array<Real*, 3> force;         // [N]
  std::array<Real*, 3> load;          // [N] at the full load; null where there is none
  Real* inverse_mass;                 // [1/kg]; 0 in empty slots
  Real* nodal_sum;                    // see BlockForces; null where it is not used

  [[nodiscard]] std::size_t element(std::size_t slot) const {
    return slot % rows * lanes + slot / rows;
  }
};

/// Arrays that not every body needs.
struct OptionalArrays {
  bool load = false;
  bool nodal_sum = false;
};

/// Memory of a block's arrays, aligned to registers and filled with zeros.
template <class Real>
class BlockState {
 public:
  BlockState(const Block& block, std::size_t lanes, OptionalArrays wanted = {});

  [[nodiscard]] const BlockArrays<Real>& arrays() const { return arrays_; }
  void clear_forces();
  void clear_nodal_sum();

 private:
  struct Free {
    void operator()(void* memory) const;
  };
  std::size_t stride_;
  std::unique_ptr<void, Free> memory_;
  BlockArrays<Real> arrays_;
};

extern template class BlockState<float>;
extern template class BlockState<double>;

/// The internal forces of a block's cells, springs or others. The functions are called
/// for different blocks at the same time.
template <class Real>
struct BlockForces {
  using OnBlock = std::function<void(std::size_t block, const BlockArrays<Real>& arrays)>;
  std::size_t lanes;  // of the arrays it takes
  /// Writes the forces from displacements and velocities; they are zero before.
  OnBlock add;
  /// Writes what the block's cells contribute to nodal_sum, which is zero before, from
  /// the displacements, where cells act on each other through a number of the nodes
  /// between them. `add` then finds there the sum over all blocks. The function is empty
  /// where there is no such number.
  OnBlock add_nodal_sums{};
};

}  // namespace springcheck::dynamics
