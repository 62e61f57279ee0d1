#include "comparisons/system/environment.hpp"

#include <fmt/format.h>

#include <thread>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/system/blas.hpp"
#include "comparisons/system/processor.hpp"

namespace springcheck {

using tbb::global_control;

Environment environment() {
  return {.processor = processor_name(),
          .machine = machine_digits(),
          .clock = clock_policy(),
          .instructions = instructions(),
          .blas = blas_name(),
          .compiler = build_info::compiler,
          .flags = build_info::flags,
          .cores = static_cast<int>(std::thread::hardware_concurrency()),
          .threads = static_cast<int>(
              global_control::active_value(global_control::max_allowed_parallelism))};
}

std::string text_of(const Environment& environment) {
  const auto& [processor, machine, clock, instructions, blas, compiler, flags, cores,
               threads] = environment;
  return fmt::format("{}{}, clock {}, {}, {}, {} {}", processor,
                     machine.empty() ? "" : " (machine " + machine + ")", clock,
                     instructions, blas, compiler, flags);
}

ThreadsInUse::ThreadsInUse(int threads)
    : limit_(global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {
  use_one_blas_thread();
}

}  // namespace springcheck
