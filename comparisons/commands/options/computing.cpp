#include "comparisons/commands/options/computing.hpp"

#include <fmt/format.h>

#include <cmath>

#include "comparisons/system/blas.hpp"
#include "comparisons/system/memory.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

/// Refuses an address space that OpenBLAS could not work in, and takes what it needs.
void make_room_for_blas(int calls) {
  constexpr double for_all_else = 50e6;
  const double room = room_of_address_space();
  if (std::isinf(room)) return;
  const double needed = calls * blas_buffer_bytes + for_all_else;
  if (room < needed)
    throw InputError("springcheck", "address space (ulimit -v)",
                     fmt::format("{:.2g} GB more for {} threads (see --help for fewer)",
                                 needed / 1e9, calls),
                     fmt::format("{:.2g} GB", room / 1e9));
  reserve_blas_buffers(calls);
}

}  // namespace

Computing::Computing(int threads, int calls) : in_use_(threads) {
  make_room_for_blas(calls);
}

}  // namespace springcheck
