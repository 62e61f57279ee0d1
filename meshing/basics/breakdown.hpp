#pragma once

#include <stdexcept>

namespace springcheck {

/// A numerical method that cannot go on. It is the answer of a simulation, and stored as
/// such; what else goes wrong, memory above all, says nothing about the case and is not.
class Breakdown : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace springcheck
