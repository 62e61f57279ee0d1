#include "meshing/basics/random_numbers.hpp"

namespace springcheck {

std::mutex& random_numbers() {
  static std::mutex the_only_one;
  return the_only_one;
}

}  // namespace springcheck
