#pragma once

#include <cstddef>

namespace springcheck::dynamics {

/// Numbers in a table of looked_up (pack.hpp): as many as the widest register has of the
/// narrowest, for whatever precision and instruction set reads it.
inline constexpr std::size_t largest_look_up = 16;

}  // namespace springcheck::dynamics
