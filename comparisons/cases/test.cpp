#include "comparisons/cases/test.hpp"

#include <fmt/format.h>

#include <numbers>

namespace springcheck {

std::string deformation_text(Test test, double deformation) {
  return entry_of(test).turns
             ? fmt::format("{:g} deg", deformation * 180 / std::numbers::pi)
             : fmt::format("{:g} %", 100 * deformation);
}

}  // namespace springcheck
