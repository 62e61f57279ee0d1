#include "dynamics/block_state.hpp"

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
std::size_t BlockState<Real>::reach(const Block& block) {
  const std::size_t furthest = block.is_grid() ? block.layer + block.row + 1 : 0;
  return (furthest / block_granularity + 2) * block_granularity;
}

template <class Real>
BlockState<Real>::BlockState(const Block& block, Load load) : reach_(reach(block)) {
  const std::size_t slots = block.nodes.size();
  stride_ = slots + 2 * reach_;
  const std::size_t count = load == Load::some ? 13 : 10;
  bytes_ = count * stride_ * sizeof(Real);
  memory_.reset(::operator new (bytes_, std::align_val_t{alignment}));
  std::memset(memory_.get(), 0, bytes_);
  Real* next = static_cast<Real*>(memory_.get()) + reach_;
  const auto take = [&] {
    Real* const array = next;
    next += stride_;
    return array;
  };
  arrays_ = {.slots = slots,
             .displacement = {take(), take(), take()},
             .velocity = {take(), take(), take()},
             .force = {take(), take(), take()},
             .load = {nullptr, nullptr, nullptr},
             .inverse_mass = take()};
  if (load == Load::some) arrays_.load = {take(), take(), take()};
}

template <class Real>
void BlockState<Real>::clear_forces() {
  // The three lie one behind the other.
  std::memset(arrays_.force[0] - reach_, 0, 3 * stride_ * sizeof(Real));
}

template class BlockState<float>;
template class BlockState<double>;

}  // namespace springcheck::dynamics
