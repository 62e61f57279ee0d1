#include "tissue/checks.hpp"

#include <cmath>
#include <sstream>

#include "meshing/basics/input_error.hpp"

namespace springcheck::tissue {
namespace {

[[noreturn]] void refuse(std::string_view name, std::string_view expected, double value) {
  std::ostringstream got;
  got << value;
  throw InputError("tissue", name, expected, got.str());
}

}  // namespace

void check_positive(std::string_view name, double value) {
  if (!(value > 0 && std::isfinite(value)))
    refuse(name, "a finite number above 0", value);
}

void check_not_negative(std::string_view name, double value) {
  if (!(value >= 0 && std::isfinite(value)))
    refuse(name, "a finite number, 0 or above", value);
}

}  // namespace springcheck::tissue
