#include "dynamics/blocks/workers.hpp"

#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

namespace springcheck::dynamics {

struct Workers::Arena {
  explicit Arena(int threads) : arena(threads) {}
  tbb::task_arena arena;
  tbb::affinity_partitioner partitioner;
};

Workers::Workers(int threads)
    : arena_(threads > 1 ? std::make_unique<Arena>(threads) : nullptr) {}
Workers::~Workers() = default;
Workers::Workers(Workers&&) noexcept = default;
Workers& Workers::operator=(Workers&&) noexcept = default;

void Workers::run(std::size_t pieces, const std::function<void(std::size_t)>& work) {
  if (!arena_ || pieces < 2) {
    for (std::size_t i = 0; i < pieces; ++i) work(i);
    return;
  }
  arena_->arena.execute(
      [&] { tbb::parallel_for(std::size_t{0}, pieces, work, arena_->partitioner); });
}

}  // namespace springcheck::dynamics
