#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/settings/named_values.hpp"

namespace springcheck {

// Settings that are more than a number or a name (named), read from what the user
// gave. All throw InputError.

std::vector<Status> statuses_of(const Given& given);

/// A value whose names are digits, which read as a number where no quotes say otherwise.
template <class T>
T numbered(const Given& given) {
  return value_named<T>(given,
                        given.is_text() ? given.text() : std::to_string(given.integer()));
}

std::array<double, 3> size_of(const Given& given);
std::array<int, 3> cells_of(const Given& given);
double poisson_ratio_of(const Given& given);
std::array<double, 3> stiffness_of(const Given& given);  // none negative, not all 0
double not_negative_of(const Given& given);
std::optional<double> time_step_of(const Given& given);  // none: auto
unsigned seed_of(const Given& given);

/// An integer in these bounds.
template <int least, int most>
int count_of(const Given& given) {
  const std::int64_t count = given.integer();
  if (count < least || count > most)
    given.refuse("an integer in [" + std::to_string(least) + ", " + std::to_string(most) +
                 "]");
  return static_cast<int>(count);
}

/// K, n, gamma_lim and p of a law.
std::array<double, 4> law_of(const Given& given);

/// The number of steps of tissue's static solver; none: auto.
std::optional<int> time_steps_of(const Given& given);

/// Times above 0, ascending, as a path without its fractions; and the fractions, one for
/// each time and not all 0.
dynamics::LoadPath load_times_of(const Given& given);
void set_fractions(dynamics::LoadPath& path, const Given& given);
double cycles_of(const Given& given);

/// Whether the body is turned inside out somewhere on the way from 0 to the gradient H of
/// u = H X.
bool turns_inside_out(const Eigen::Matrix3d& gradient);

/// A strain or, in torsion, an angle: positive but in uniaxial, whose sign is free.
double deformation_of(const Given& given, const CaseSettings& settings);

/// An acceleration [m/s^2] other than zero.
Vector3 gravity_of(const Given& given);

/// A traction [Pa] other than zero, along z where the body slides on its plate.
Vector3 traction_of(const Given& given, const CaseSettings& settings);

/// A displacement gradient H other than zero that turns nothing inside out on the way:
/// I + s H is regular for s in [0, 1].
Eigen::Matrix3d gradient_of(const Given& given);

}  // namespace springcheck
