#include "dynamics/blocks/block_state.hpp"

#include <cstring>
#include <new>

namespace springcheck::dynamics {
namespace {

constexpr std::size_t alignment = 64;

}  // namespace

template <class Real>
void BlockState<Real>::Free::operator()(void* memory) const {
  ::operator delete (memory, std::align_val_t{alignment});
}

template <class Real>
BlockState<Real>::BlockState(const Block& block, std::size_t lanes,
                             OptionalArrays wanted) {
  const std::size_t rows = block.nodes.size() / lanes;
  const std::size_t ghosts = block.is_grid() ? block.layer + block.row + 2 : 0;
  // An odd number of cache lines, so that the arrays do not share places in the cache;
  // one spare line behind the last row, where unaligned reads end.
  constexpr std::size_t line = alignment / sizeof(Real);
  stride_ = ((rows + ghosts) * lanes / line + 2) * line;
  if (stride_ / line % 2 == 0) stride_ += line;
  const std::size_t count = 10 + (wanted.load ? 3 : 0) + (wanted.nodal_sum ? 1 : 0);
  const std::size_t bytes = count * stride_ * sizeof(Real);
  memory_.reset(::operator new (bytes, std::align_val_t{alignment}));
  std::memset(memory_.get(), 0, bytes);
  Real* next = static_cast<Real*>(memory_.get());
  const auto take = [&] {
    Real* const array = next;
    next += stride_;
    return array;
  };
  arrays_ = {.rows = rows,
             .lanes = lanes,
             .ghosts = ghosts,
             .displacement = {take(), take(), take()},
             .velocity = {take(), take(), take()},
             .force = {take(), take(), take()},
             .load = {nullptr, nullptr, nullptr},
             .inverse_mass = take(),
             .nodal_sum = nullptr};
  if (wanted.load) arrays_.load = {take(), take(), take()};
  if (wanted.nodal_sum) arrays_.nodal_sum = take();
}

template <class Real>
void BlockState<Real>::clear_forces() {
  // The three lie one behind the other.
  std::memset(arrays_.force[0], 0, 3 * stride_ * sizeof(Real));
}

template <class Real>
void BlockState<Real>::clear_nodal_sum() {
  std::memset(arrays_.nodal_sum, 0, stride_ * sizeof(Real));
}

template class BlockState<float>;
template class BlockState<double>;

}  // namespace springcheck::dynamics
