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
