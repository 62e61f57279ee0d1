#include "comparisons/settings/setting_values.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <complex>
#include <limits>

#include "meshing/input_error.hpp"
#include "tissue/maxwell_fit.hpp"

namespace springcheck {
namespace {

/// The value whose name_of is `text`, which stands in what was given.
template <class Value>
Value one_of(const Given& given, const std::string& text,
             const std::vector<Value>& values) {
  std::string names;
  for (const Value value : values) {
    if (name_of(value) == text) return value;
    names += (names.empty() ? "" : ", ") + std::string(name_of(value));
  }
  given.refuse("one of " + names);
}

int count_of(const Given& given, int least, int most) {
  const std::int64_t count = given.integer();
  if (count < least || count > most)
    given.refuse(fmt::format("an integer in [{}, {}]", least, most));
  return static_cast<int>(count);
}

constexpr int million = 1'000'000;

}  // namespace

Test test_of(const Given& given) {
  return one_of(given, given.text(), all_tests());
}

Method method_named(const Given& given, const std::string& name) {
  const Method* method = find_method(name);
  if (method == nullptr)
    throw InputError(given.place(), "", "one of " + names_of(methods()),
                     "'" + name + "'");
  return *method;
}

ElementName element_named(const Given& given, const std::string& name) {
  const ElementName* element = find_element(name);
  if (element == nullptr)
    throw InputError(given.place(), "", "one of " + names_of(elements()),
                     "'" + name + "'");
  return *element;
}

ElementName element_of(const Given& given) {
  return element_named(given, given.text());
}

std::vector<Method> methods_of(const Given& given) {
  std::vector<Method> all;
  for (const std::string& name : given.texts()) {
    all.push_back(method_named(given, name));
    if (std::ranges::count(all, name, &Method::name) > 1)
      throw InputError(given.place(), "", "each name once", "'" + name + "' twice");
  }
  return all;
}

std::array<double, 3> size_of(const Given& given) {
  // Far beyond any body, and their cubes stay far from overflow.
  constexpr double shortest = 1e-9, longest = 1e9;
  const auto size = given.three_numbers();
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

tissue::BipowerLaw organ_of(const Given& given) {
  const std::string name = given.text();
  for (const tissue::Organ& organ : tissue::organs())
    if (organ.name == name) return organ.law;
  given.refuse("one of " + names_of(tissue::organs()));
}

tissue::BipowerLaw law_of(const Given& given) {
  const auto [K, n, limit, p] = given.four_numbers();
  if (!(K > 0 && n > 0 && n < 1 && limit > 0 && p > 0))
    given.refuse("K > 0, n between 0 and 1, GAMMA_LIM > 0 and p > 0");
  return {
      .consistency = K, .linear_index = n, .linear_limit = limit, .hardening_index = p};
}

int branch_count_of(const Given& given) {
  return count_of(given, 2, tissue::most_branches);
}

int time_steps_of(const Given& given) {
  return count_of(given, 1, million);
}

dynamics::LoadPath load_path_of(const Given& times, const Given& fractions) {
  const std::vector<double> at = times.numbers(), of = fractions.numbers();
  if (at.size() != of.size())
    fractions.refuse(fmt::format("a fraction for each of {} times", at.size()));
  dynamics::LoadPath path;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] <= (i == 0 ? 0 : at[i - 1])) times.refuse("times above 0 [s], ascending");
    if (std::abs(of[i]) > 1) fractions.refuse("fractions from -1 to 1");
    path.push_back({.time = at[i], .fraction = of[i]});
  }
  if (std::ranges::all_of(of, [](double fraction) { return fraction == 0; }))
    fractions.refuse("fractions that are not all 0");
  return path;
}

double cycles_of(const Given& given) {
  const double cycles = given.finite_number();
  if (!(cycles >= 0.01 && cycles <= 1000)) given.refuse("a number in [0.01, 1000]");
  return cycles;
}

double deformation_of(const Given& given, Test test) {
  constexpr double largest = 100;  // keeps squares of strains far from overflow
  const double deformation = test == Test::torsion ? given.angle() : given.strain();
  if (deformation > largest) given.refuse("a deformation of at most 100");
  if (test == Test::uniaxial) {
    if (deformation == 0 || deformation <= -1)
      given.refuse("a strain above -1 other than 0: positive pulls, negative presses");
    return deformation;
  }
  if (!(deformation > 0)) given.refuse("a positive number: the test gives its direction");
  if (test == Test::compression && deformation >= 1)
    given.refuse("a strain below 1: the plates would meet");
  return deformation;
}

double not_negative_of(const Given& given) {
  const double value = given.finite_number();
  if (value < 0) given.refuse("a number of at least 0");
  return value;
}

mss::LatticeStiffness stiffness_of(const Given& given) {
  const auto [edge, face_diagonal, inner_diagonal] = given.three_numbers();
  const double softest = std::min({edge, face_diagonal, inner_diagonal}),
               stiffest = std::max({edge, face_diagonal, inner_diagonal});
  if (softest < 0 || stiffest == 0)
    given.refuse("KE,KF,KC of at least 0 N/m, one of them above 0");
  return {.edge = edge, .face_diagonal = face_diagonal, .inner_diagonal = inner_diagonal};
}

std::optional<double> time_step_of(const Given& given) {
  if (!given.is_text()) return given.positive_number();
  if (given.text() != "auto") given.refuse("a positive time [s] or 'auto'");
  return std::nullopt;
}

unsigned seed_of(const Given& given) {
  const std::int64_t seed = given.integer();
  if (seed < 0 || seed > std::numeric_limits<unsigned>::max())
    given.refuse("an integer in [0, 4294967295]");
  return static_cast<unsigned>(seed);
}

mss::StiffnessForm stiffness_form_of(const Given& given) {
  using enum mss::StiffnessForm;
  return one_of<mss::StiffnessForm>(given, given.text(), {shear_modulus, young_modulus});
}

mss::VolumeCorrection correction_of(const Given& given) {
  using enum mss::VolumeCorrection;
  return one_of<mss::VolumeCorrection>(given, given.text(), {on, off});
}

std::optional<Solver> solver_named(const Given& given) {
  using enum Solver;
  return one_of<Solver>(given, given.text(),
                        {static_equilibrium, path_limit, explicit_euler,
                         semi_implicit_euler, verlet, implicit_euler});
}

mss::Precision precision_of(const Given& given) {
  using enum mss::Precision;
  return one_of<mss::Precision>(given, given.text(),
                                {double_precision, single_precision});
}

int sample_count_of(const Given& given) {
  return count_of(given, 0, million);
}

std::vector<Status> expect_of(const Given& given) {
  std::vector<Status> expected;
  for (const std::string& name : given.texts()) {
    const auto found =
        std::ranges::find(all_statuses(), name, [](Status s) { return name_of(s); });
    if (found == all_statuses().end()) {
      std::string names;
      for (const Status status : all_statuses())
        names += (names.empty() ? "" : ", ") + std::string(name_of(status));
      given.refuse("statuses among " + names);
    }
    expected.push_back(*found);
  }
  return expected;
}

PlateContact plates_of(const Given& given) {
  using enum PlateContact;
  return one_of<PlateContact>(given, given.text(), {glued, sliding});
}

fem_reference::LinearSolver linear_solver_of(const Given& given) {
  using enum fem_reference::LinearSolver;
  return one_of<fem_reference::LinearSolver>(given, given.text(),
                                             {automatic, direct, multigrid});
}

fem_reference::LatticeDirection lattice_direction_of(const Given& given) {
  using enum fem_reference::LatticeDirection;
  // Its names are digits, which read as a number where no quotes say otherwise.
  const std::string text =
      given.is_text() ? given.text() : std::to_string(given.integer());
  return one_of<fem_reference::LatticeDirection>(given, text, {d100, d110, d111});
}

LatticeName lattice_of(const Given& given) {
  const LatticeName* lattice = find_lattice(given.text());
  if (lattice == nullptr) given.refuse("one of " + names_of(lattices()));
  return *lattice;
}

Vector3 load_of(const Given& given, const char* unit) {
  const auto numbers = given.three_numbers();
  const Vector3 vector(numbers[0], numbers[1], numbers[2]);
  if (vector.isZero(0)) given.refuse(fmt::format("a vector other than zero [{}]", unit));
  return vector;
}

Vector3 traction_of(const Given& given, PlateContact plates) {
  const Vector3 traction = load_of(given, "Pa");
  if (plates == PlateContact::sliding && (traction.x() != 0 || traction.y() != 0))
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
  const auto numbers = given.nine_numbers();
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
