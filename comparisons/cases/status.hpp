#pragma once

#include "comparisons/names/named.hpp"

namespace springcheck {

/// How a case ended, and the last what else is to be known of it: a flag beside any of
/// the others, never how a case ended. The words are those of the command-line interface.
enum class Status {
  ok,
  wrinkled,
  inverted,
  indefinite,
  no_equilibrium,
  diverged,
  not_converged,
  refused,
  error,
  extrapolated
};

template <>
inline constexpr std::array value_names<Status>{
    Named{
        Status::ok, "ok",
        "equilibrium, and stable: its tangent is positive definite. In dynamics: the end "
        "was reached"},
    Named{Status::wrinkled, "wrinkled",
          "equilibrium whose free faces zigzag from cell to cell"},
    Named{Status::inverted, "inverted",
          "equilibrium with a cell turned inside out at a corner; or a motion in which "
          "the body "
          "went through itself, so that it shows another turn than its plates"},
    Named{Status::indefinite, "indefinite", "equilibrium that is not stable"},
    Named{Status::no_equilibrium, "no_equilibrium",
          "the path of equilibria from rest ends before the full load; the fraction "
          "reached is reported"},
    Named{Status::diverged, "diverged", "the dynamics blew up"},
    Named{Status::not_converged, "not_converged",
          "the solver gave up before the full load"},
    Named{Status::refused, "refused",
          "the method does not cover this mesh, material or time step"},
    Named{
        Status::error, "error",
        "the program failed, not the body, as where memory ends: nothing is stored, and "
        "the case is computed again when it is next asked for"},
    Named{
        Status::extrapolated, "extrapolated",
        "never alone, a flag beside one of the others: strains or rates leave the range "
        "to which the law of tissue was fitted"}};

/// Whether a case of this status ended in an equilibrium, or at the end of its motion,
/// and so has all measures and fields; but those of solver limit, which end where a path
/// does.
constexpr bool has_equilibrium(Status status) {
  return status == Status::ok || status == Status::wrinkled ||
         status == Status::inverted || status == Status::indefinite;
}

}  // namespace springcheck
