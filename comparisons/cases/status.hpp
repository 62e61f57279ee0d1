#pragma once

#include <array>
#include <string_view>

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

/// A status by its name.
struct StatusName {
  Status value;
  std::string_view name;
  std::string_view description;
  std::string_view said{};  // of a method, behind its name: "blew up in time"
};

template <>
inline constexpr std::array value_names<Status>{
    StatusName{
        Status::ok, "ok",
        "equilibrium, and stable: its tangent is positive definite. In dynamics: the end "
        "was reached",
        "holds to the full load"},
    StatusName{Status::wrinkled, "wrinkled",
               "equilibrium whose free faces zigzag from cell to cell",
               "wrinkles: free faces zigzag from cell to cell"},
    StatusName{
        Status::inverted, "inverted",
        "equilibrium with a cell turned inside out at a corner; or a motion in which "
        "the body "
        "went through itself, so that it shows another turn than its plates",
        "turns cells inside out"},
    StatusName{Status::indefinite, "indefinite", "equilibrium that is not stable",
               "ends in an equilibrium that is not stable"},
    StatusName{Status::no_equilibrium, "no_equilibrium",
               "the path of equilibria from rest ends before the full load; the fraction "
               "reached is reported",
               "has no equilibrium at the full load"},
    StatusName{Status::diverged, "diverged", "the dynamics blew up", "blew up in time"},
    StatusName{Status::not_converged, "not_converged",
               "the solver gave up before the full load", "was given up by the solver"},
    StatusName{Status::refused, "refused",
               "the method does not cover this mesh, material or time step",
               "does not cover the mesh, material or time step"},
    StatusName{
        Status::error, "error",
        "the program failed, not the body, as where memory ends: nothing is stored, and "
        "the case is computed again when it is next asked for",
        "was ended by a failure of the program"},
    StatusName{
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
