#include "comparisons/stability/failure.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/measures/hourglassing.hpp"

namespace springcheck {
namespace {

constexpr double wrinkle = 4;      // cells: longer modes buckle
constexpr double tolerated = 1.1;  // plate force over that of a control

bool has_flag(const CaseResult& result, Status flag) {
  return result.status == flag || std::ranges::count(result.flags, flag) > 0;
}

}  // namespace

const std::vector<Failure>& all_failures() {
  using enum Failure;
  static const std::vector<Failure> all{none,      not_covered,  solver,
                                        blow_up,   inversion,    limit_point,
                                        wrinkling, hourglassing, loss_of_definiteness,
                                        locking};
  return all;
}

std::string_view name_of(Failure failure) {
  switch (failure) {
    case Failure::none:
      return "none";
    case Failure::not_covered:
      return "not covered";
    case Failure::solver:
      return "solver failure";
    case Failure::blow_up:
      return "blow-up";
    case Failure::inversion:
      return "inversion";
    case Failure::limit_point:
      return "limit point";
    case Failure::wrinkling:
      return "wrinkling";
    case Failure::hourglassing:
      return "hourglassing";
    case Failure::loss_of_definiteness:
      return "loss of definiteness";
    case Failure::locking:
      return "locking";
  }
  return {};
}

std::string_view description_of(Failure failure) {
  switch (failure) {
    case Failure::none:
      return "equilibrium, tangent positive definite, nothing of what follows";
    case Failure::not_covered:
      return "the method refuses the scene";
    case Failure::solver:
      return "the solver gave up on a path that was stable as far as it came: says "
             "nothing "
             "of the body";
    case Failure::blow_up:
      return "a motion left all bounds";
    case Failure::inversion:
      return "a cell is turned inside out at a corner";
    case Failure::limit_point:
      return "no equilibrium beyond some part of the load";
    case Failure::wrinkling:
      return "a free face zigzags from cell to cell; of a path's limit, the mode that "
             "becomes unstable is shorter than four cells";
    case Failure::hourglassing:
      return "the inside of hexahedra alternates from cell to cell in modes that the "
             "cells' mean strain does not see: more than half of their hourglass "
             "displacement, higher than .05 of edge times strain";
    case Failure::loss_of_definiteness:
      return "equilibrium, but no minimum of the energy; finite elements also where the "
             "path there lost it";
    case Failure::locking:
      return "with --locking: plate force or torque more than 10 % above that of the "
             "same "
             "law on q1-sri (fem-cauchy-born, for lattices); on hexahedra alone";
  }
  return {};
}

char letter_of(Failure failure) {
  switch (failure) {
    case Failure::none:
      return '.';
    case Failure::not_covered:
      return '-';
    case Failure::solver:
      return '?';
    case Failure::blow_up:
      return 'B';
    case Failure::inversion:
      return 'I';
    case Failure::limit_point:
      return 'P';
    case Failure::wrinkling:
      return 'W';
    case Failure::hourglassing:
      return 'H';
    case Failure::loss_of_definiteness:
      return 'D';
    case Failure::locking:
      return 'L';
  }
  return ' ';
}

bool refuses(const CaseResult& result) {
  return result.status == Status::refused;
}

bool solver_fails(const CaseResult& result) {
  return result.status == Status::not_converged &&
         !result.measures.definite_up_to_deformation;
}

bool blows_up(const CaseResult& result) {
  return result.status == Status::diverged;
}

bool inverts(const CaseResult& result) {
  return has_flag(result, Status::inverted);
}

bool ends_in_limit_point(const CaseResult& result) {
  return result.status == Status::no_equilibrium;
}

bool wrinkles(const CaseResult& result) {
  const auto length = result.measures.critical_wavelength;
  return has_flag(result, Status::wrinkled) ||
         (length && *length < wrinkle && result.status == Status::indefinite);
}

bool hourglasses(const CaseResult& result) {
  const auto& alternation = result.measures.hourglass_alternation;
  const auto& amplitude = result.measures.hourglass_amplitude;
  return alternation && amplitude &&
         is_hourglassing({.alternation = *alternation, .amplitude = *amplitude});
}

bool loses_definiteness(const CaseResult& result) {
  return has_flag(result, Status::indefinite) ||
         result.measures.definite_up_to_deformation.has_value();
}

bool locks(const CaseResult& result, const CaseResult& control) {
  const auto exceeds = [](const Measures::Value& value, const Measures::Value& bound) {
    return value && bound && std::abs(*value) > tolerated * std::abs(*bound);
  };
  if (control.status != Status::ok) return false;
  // Beside a force the torque is round-off.
  return result.measures.plate_force
             ? exceeds(result.measures.plate_force, control.measures.plate_force)
             : exceeds(result.measures.plate_torque, control.measures.plate_torque);
}

Failure failure_of(const CaseResult& result) {
  if (refuses(result)) return Failure::not_covered;
  if (solver_fails(result)) return Failure::solver;
  if (blows_up(result)) return Failure::blow_up;
  if (inverts(result)) return Failure::inversion;
  if (ends_in_limit_point(result)) return Failure::limit_point;
  if (wrinkles(result)) return Failure::wrinkling;
  if (hourglasses(result)) return Failure::hourglassing;
  if (loses_definiteness(result)) return Failure::loss_of_definiteness;
  return Failure::none;
}

}  // namespace springcheck
