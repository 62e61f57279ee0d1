#pragma once

#include <random>

namespace springcheck {

/// Uniform in [0, 1), the same everywhere: std::uniform_real_distribution is left to the
/// library.
inline double uniform_number(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11U) * 0x1p-53;
}

}  // namespace springcheck
