#include "comparisons/settings/setting_values.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <complex>
#include <limits>
#include <numbers>

#include "meshing/basics/input_error.hpp"
#include "tissue/maxwell_fit.hpp"

namespace springcheck {
namespace {

/// A vector other than zero; `unit` is for messages.
Vector3 vector_of(const Given& given, const char* unit) {
  const auto numbers = given.numbers<3>();
  const Vector3 vector(numbers[0], numbers[1], numbers[2]);
  if (vector.isZero(0)) given.refuse(fmt::format("a vector other than zero [{}]", unit));
  return vector;
}

}  // namespace

std::array<double, 3> size_of(const Given& given) {
  // These are far beyond any body, and their cubes stay far from overflow.
  constexpr double shortest = 1e-9, longest = 1e9;
  const auto size = given.numbers<3>();
  if (std::ranges::any_of(
          size, [](double length) { return !(length >= shortest && length <= longest); }))
    given.refuse("three lengths between 1e-9 and 1e9 m");
  return size;
}

std::array<int, 3> cells_of(const Given& given) {
  std::array<int, 3> cells{};
  const auto counts = given.three_integers();
  for (std::size_t i = 0; i < 3; ++i) {
    if (counts[i] < 1 || counts[i] > std::numeric_limits<int>::max())
      given.refuse("three counts of at least 1");
    cells[i] = static_cast<int>(counts[i]);
  }
  return cells;
}

double poisson_ratio_of(const Given& given) {
  const double nu = given.finite_number();
  if (!(nu > -1 && nu < 0.5)) given.refuse("a number in (-1, 0.5)");
  return nu;
}

std::array<double, 4> law_of(const Given& given) {
  const auto law = given.numbers<4>();
  const auto [K, n, limit, p] = law;
  if (!(K > 0 && n > 0 && n < 1 && limit > 0 && p > 0))
    given.refuse("K > 0, n between 0 and 1, GAMMA_LIM > 0 and p > 0");
  return law;
}

std::optional<int> time_steps_of(const Given& given) {
  if (!given.is_text()) return count_of<1, 1'000'000>(given);
  if (given.text() != "auto") given.refuse("an integer of at least 1, or 'auto'");
  return std::nullopt;
}

dynamics::LoadPath load_times_of(const Given& given) {
  dynamics::LoadPath path;
  for (const double time : given.any_numbers()) {
    if (time <= (path.empty() ? 0 : path.back().time))
      given.refuse("times above 0 [s], ascending");
    path.push_back({.time = time, .fraction = 0});
  }
  return path;
}

void set_fractions(dynamics::LoadPath& path, const Given& given) {
  const std::vector<double> fractions = given.any_numbers();
  if (fractions.size() != path.size())
    given.refuse(fmt::format("a fraction for each of {} times", path.size()));
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (std::abs(fractions[i]) > 1) given.refuse("fractions from -1 to 1");
    path[i].fraction = fractions[i];
  }
  if (std::ranges::all_of(fractions, [](double fraction) { return fraction == 0; }))
    given.refuse("fractions that are not all 0");
}

double cycles_of(const Given& given) {
  const double cycles = given.finite_number();
  if (!(cycles >= 0.01 && cycles <= 1000)) given.refuse("a number in [0.01, 1000]");
  return cycles;
}

double deformation_of(const Given& given, const CaseSettings& settings) {
  const Test test = settings.test;
  constexpr double largest = 100;  // keeps squares of strains far from overflow
  const double deformation =
      entry_of(test).turns
          ? given.number("a finite angle, such as 0.785 (radians) or '45deg'")
          : given.number("a finite strain, such as 0.05 or '5%'");
  if (deformation > largest) given.refuse("a deformation of at most 100");
  if (test == Test::uniaxial) {
    if (deformation == 0 || deformation <= -1)
      given.refuse("a strain above -1 other than 0: positive pulls, negative presses");
    return deformation;
  }
  if (!(deformation > 0)) given.refuse("a positive number: the test gives its direction");
  // A plain number above a turn is more often one of degrees.
  if (entry_of(test).turns && deformation > 2 * std::numbers::pi && !given.had_units())
    given.refuse(
        "an angle of at most a turn, or one with a unit: degrees are written '45deg'");
  if (test == Test::compression && deformation >= 1)
    given.refuse("a strain below 1: the plates would meet");
  return deformation;
}

double not_negative_of(const Given& given) {
  const double value = given.finite_number();
  if (value < 0) given.refuse("a number of at least 0");
  return value;
}

std::array<double, 3> stiffness_of(const Given& given) {
  const auto stiffness = given.numbers<3>();
  const auto [softest, stiffest] = std::ranges::minmax(stiffness);
  if (softest < 0 || stiffest == 0)
    given.refuse("KE,KF,KC of at least 0 N/m, one of them above 0");
  return stiffness;
}

std::optional<double> time_step_of(const Given& given) {
  const std::string expected = "a positive time [s] or 'auto'";
  if (given.is_text() && given.text() == "auto") return std::nullopt;
  const double step = given.number(expected);
  if (!(step > 0)) given.refuse(expected);
  return step;
}

unsigned seed_of(const Given& given) {
  const std::int64_t seed = given.integer();
  if (seed < 0 || seed > std::numeric_limits<unsigned>::max())
    given.refuse("an integer in [0, 4294967295]");
  return static_cast<unsigned>(seed);
}

std::vector<Status> statuses_of(const Given& given) {
  std::vector<Status> statuses;
  for (const std::string& name : given.texts()) {
    statuses.push_back(value_named<Status>(given, name));
    if (statuses.back() == Status::extrapolated)
      given.refuse("how a case ends (extrapolated is a flag beside that)");
    if (statuses.back() == Status::error)
      given.refuse("what a body may do: the program's own faults are not forgiven");
  }
  return statuses;
}

Vector3 gravity_of(const Given& given) {
  return vector_of(given, "m/s^2");
}

Vector3 traction_of(const Given& given, const CaseSettings& settings) {
  const Vector3 traction = vector_of(given, "Pa");
  if (settings.plates == PlateContact::sliding &&
      (traction.x() != 0 || traction.y() != 0))
    given.refuse("a traction along z: the body slides on its plate");
  return traction;
}

bool turns_inside_out(const Eigen::Matrix3d& gradient) {
  // I + s H is singular where H has the real eigenvalue -1/s.
  return std::ranges::any_of(gradient.eigenvalues(), [](std::complex<double> eigenvalue) {
    return eigenvalue.imag() == 0 && eigenvalue.real() <= -1;
  });
}

Eigen::Matrix3d gradient_of(const Given& given) {
  const auto numbers = given.numbers<9>();
  const Eigen::Matrix3d H =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers.data());
  if (H.isZero(0)) given.refuse("a gradient other than zero");
  if (H.cwiseAbs().maxCoeff() > 100) given.refuse("components between -100 and 100");
  if (turns_inside_out(H))
    given.refuse(
        "a gradient H that turns no body inside out: no real eigenvalue at or below -1");
  return H;
}

}  // namespace springcheck
