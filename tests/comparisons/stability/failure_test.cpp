#include "comparisons/stability/failure.hpp"

#include <boost/test/unit_test.hpp>
#include <set>

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(failure_test)

namespace {

CaseResult with(Status status, const std::vector<Status>& flags = {}) {
  CaseResult result{};
  result.status = status;
  result.flags = flags;
  return result;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_failure_has_a_name_and_a_letter_of_its_own) {
  std::set<std::string_view> names;
  std::set<char> letters;
  for (const FailureName& failure : value_names<Failure>) {
    names.insert(failure.name);
    letters.insert(failure.letter);
  }
  BOOST_TEST(names.size() == value_names<Failure>.size());
  BOOST_TEST(letters.size() == value_names<Failure>.size());
}

BOOST_AUTO_TEST_CASE(a_case_fails_in_the_first_of_its_ways) {
  using enum Failure;
  const std::vector<std::pair<CaseResult, Failure>> cases{
      {with(Status::ok), none},
      {with(Status::refused), not_covered},
      {with(Status::not_converged), solver},
      {with(Status::diverged), blow_up},
      {with(Status::no_equilibrium), limit_point},
      {with(Status::wrinkled, {Status::wrinkled}), wrinkling},
      {with(Status::indefinite, {Status::indefinite}), loss_of_definiteness},
      {with(Status::inverted, {Status::inverted, Status::wrinkled}), inversion},
      {with(Status::wrinkled, {Status::wrinkled, Status::indefinite}), wrinkling}};
  for (const auto& [result, failure] : cases)
    BOOST_TEST(name_of(failure_of(result)) == name_of(failure));
}

BOOST_AUTO_TEST_CASE(an_inside_that_alternates_hourglasses) {
  CaseResult result = with(Status::ok);
  result.measures.hourglass_alternation = 0.9;
  BOOST_TEST(!hourglasses(result));  // its height is not known
  result.measures.hourglass_amplitude = 0.2;
  BOOST_TEST(name_of(failure_of(result)) == name_of(Failure::hourglassing));
  result.flags = {Status::indefinite};
  BOOST_TEST(name_of(failure_of(result)) == name_of(Failure::hourglassing));
  result.flags = {Status::wrinkled};
  BOOST_TEST(name_of(failure_of(result)) == name_of(Failure::wrinkling));
  result.flags = {};
  result.measures.hourglass_amplitude = 0.01;
  BOOST_TEST(name_of(failure_of(result)) == name_of(Failure::none));
}

// A path that was left because the tangent became indefinite is the body's failure, not
// the solver's, even where the solver then gave up.
BOOST_AUTO_TEST_CASE(a_solver_that_fails_behind_a_limit_is_not_to_blame) {
  CaseResult result = with(Status::not_converged);
  result.measures.definite_up_to_deformation = .3;
  BOOST_TEST(!solver_fails(result));
  BOOST_TEST(name_of(failure_of(result)) == name_of(Failure::loss_of_definiteness));
}

BOOST_AUTO_TEST_CASE(short_critical_modes_are_wrinkles) {
  CaseResult result = with(Status::indefinite, {Status::indefinite});
  result.measures.critical_wavelength = 2.4;
  BOOST_TEST(wrinkles(result));
  result.measures.critical_wavelength = 4.1;
  BOOST_TEST(!wrinkles(result));
  // The mode of a limit point or of an inversion is no wrinkle of the path.
  result = with(Status::no_equilibrium);
  result.measures.critical_wavelength = 2.4;
  BOOST_TEST(!wrinkles(result));
}

BOOST_AUTO_TEST_CASE(locking_is_a_force_a_tenth_above_the_control) {
  CaseResult control = with(Status::ok), result = with(Status::ok);
  control.measures.plate_force = -10;
  result.measures.plate_force = -10.9;
  BOOST_TEST(!locks(result, control));
  result.measures.plate_force = -11.1;
  BOOST_TEST(locks(result, control));
  control.status = Status::not_converged;  // no control
  BOOST_TEST(!locks(result, control));
  control = result = with(Status::ok);
  control.measures.plate_torque = 1;
  result.measures.plate_torque = 1.2;
  BOOST_TEST(locks(result, control));
}

BOOST_AUTO_TEST_SUITE_END()
