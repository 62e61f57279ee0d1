#pragma once

#include <array>
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

/// The widest there is.
InstructionSet best_instruction_set();

}  // namespace springcheck::dynamics
