#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace springcheck::dynamics {

/// What the force kernels are compiled for. Each is one code path: its results are the
/// same on any number of threads; those of two paths differ by rounding.
enum class InstructionSet { portable, avx2, avx512 };

inline constexpr std::array all_instruction_sets{
    InstructionSet::portable, InstructionSet::avx2, InstructionSet::avx512};

std::string_view name_of(InstructionSet set);

/// Whether this processor and this build have it.
bool is_available(InstructionSet set);

/// How many numbers its registers hold.
template <class Real>
std::size_t lane_count(InstructionSet set) {
  constexpr std::array<std::size_t, 3> bytes{16, 32, 64};
  return bytes[static_cast<std::size_t>(set)] / sizeof(Real);
}

/// The widest there is.
InstructionSet best_instruction_set();

}  // namespace springcheck::dynamics
