#pragma once

#include <array>

#include "comparisons/names/named.hpp"

namespace springcheck {

/// How the deformed state is found: at once, or through time.
enum class Solver {
  static_equilibrium,
  path_limit,  // static too: to where the path loses its stability
  explicit_euler,
  semi_implicit_euler,
  verlet,
  implicit_euler
};

template <>
inline constexpr std::array value_names<Solver>{
    Named{Solver::static_equilibrium, "static"},
    Named{Solver::path_limit, "limit"},
    Named{Solver::explicit_euler, "explicit"},
    Named{Solver::semi_implicit_euler, "semi-implicit"},
    Named{Solver::verlet, "verlet"},
    Named{Solver::implicit_euler, "implicit"}};

}  // namespace springcheck
