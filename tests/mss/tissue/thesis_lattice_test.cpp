#include "mss/tissue/thesis_lattice.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "tests/referee/figures.hpp"

using namespace springcheck;
using tissue::Elongation;

BOOST_AUTO_TEST_SUITE(thesis_lattice_test)

namespace {

constexpr double cell_edge = 0.005;  // [m] of the thesis's cube

mss::ThesisTissue lattice(const std::string& organ, Elongation elongation,
                          double edge = cell_edge) {
  return mss::thesis_tissue(tissue::law_of_organ(organ), tissue::hand_fitted_limit(organ),
                            elongation, edge);
}

/// Root mean square of ln(lattice/law), strains of .01 to 1 evenly in ln.
double rms_of_ln(const std::string& organ, double rate) {
  const mss::ThesisTissue springs = lattice(organ, Elongation::in_metres);
  constexpr int intervals = 60;
  double squares = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double strain = 0.01 * std::pow(100, i / static_cast<double>(intervals));
    const double law =
        tissue::constant_rate_stress(tissue::law_of_organ(organ), strain, rate).total();
    squares += std::pow(std::log(mss::shear_stress(springs, strain) / law), 2);
  }
  return std::sqrt(squares / (intervals + 1));
}

}  // namespace

// Both sides have closed forms.
BOOST_AUTO_TEST_CASE(the_thesis_s_force_is_as_far_off_as_the_referee_has_it,
                     *boost::unit_test::tolerance(1e-9)) {
  for (const std::string organ : {"spleen", "liver", "kidney"}) {
    for (const char* strain : {"0.01", "0.1", "1"})
      BOOST_TEST(
          mss::shear_stress(lattice(organ, Elongation::in_metres), std::stod(strain)) ==
          referee::figure("thesis_springs", organ + " sheared by " + strain, "stress"));
    for (const char* rate : {"0.0151", "0.133", "0.67"})
      BOOST_TEST(rms_of_ln(organ, std::stod(rate)) ==
                 referee::figure("thesis_springs", organ + " at " + rate,
                                 "root mean square of ln"));
  }
}

// With n -> 0 and a limit out of reach the springs are linear: sigma = mu gamma at small
// strain, with mu = K/2.998. The error is of second order in gamma = 1e-4 and of first in
// n = 1e-9.
BOOST_AUTO_TEST_CASE(without_its_powers_it_is_hooke_s_lattice) {
  for (const Elongation elongation : {Elongation::in_metres, Elongation::relative}) {
    const mss::ThesisTissue springs =
        mss::thesis_tissue({1000, 1e-9, 1, 3}, 1e6, elongation, cell_edge);
    BOOST_TEST(mss::shear_stress(springs, 1e-4) == 1e-4 * 1000 / 2.998,
               boost::test_tools::tolerance(1e-6));
  }
}

// What is printed makes another material of each size of cells, h^-n; the repair one. The
// tolerance is round-off.
BOOST_AUTO_TEST_CASE(only_the_repaired_force_is_a_material,
                     *boost::unit_test::tolerance(1e-12)) {
  const double n = tissue::law_of_organ("liver").linear_index;
  const auto stress = [](Elongation elongation, double edge) {
    return mss::shear_stress(lattice("liver", elongation, edge), 0.3);
  };
  BOOST_TEST(stress(Elongation::relative, 0.005) == stress(Elongation::relative, 0.02));
  BOOST_TEST(stress(Elongation::in_metres, 0.02) ==
             stress(Elongation::in_metres, 0.005) * std::pow(4, -n));
}

// The lattice is the same to and fro.
BOOST_AUTO_TEST_CASE(its_stress_is_odd, *boost::unit_test::tolerance(1e-12)) {
  for (const Elongation elongation : {Elongation::in_metres, Elongation::relative})
    BOOST_TEST(mss::shear_stress(lattice("kidney", elongation), -0.4) ==
               -mss::shear_stress(lattice("kidney", elongation), 0.4));
}

BOOST_AUTO_TEST_SUITE_END()
