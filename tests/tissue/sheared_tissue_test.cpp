#include <algorithm>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <ostream>

#include "tests/referee/figures.hpp"
#include "tests/tissue/shear.hpp"
#include "tissue/maxwell_fit.hpp"
#include "tissue/strain_history.hpp"

// The point of finite strain with five fitted branches, stepped in homogeneous simple
// shear, against the law itself. The bands are those that the tissue is to hold; the
// measured figures are beside them.

using namespace springcheck;
using namespace springcheck::tissue;
namespace data = boost::unit_test::data;

BOOST_AUTO_TEST_SUITE(sheared_tissue_test)

namespace {

constexpr std::array<double, 3> rates{0.0151, 0.133, 0.67};
const std::array<std::string, 3> names{"liver", "kidney", "spleen"};

const MaxwellModel& model_of(const std::string& organ) {
  static std::map<std::string, MaxwellModel> models;
  if (!models.contains(organ))
    models[organ] = fit_maxwell_model(law_of_organ(organ)).model;
  return models.at(organ);
}

}  // namespace

// Measured: .08 to .32 % root mean square of ln, 1.0 % at most (liver).
BOOST_DATA_TEST_CASE(it_follows_the_law_at_constant_rate, data::make(names), organ) {
  for (const double rate : rates) {
    ShearedPoint point(model_of(organ));
    constexpr int samples = 40;
    double squares = 0, largest = 0, strain = 0;
    for (int i = 0; i <= samples; ++i) {
      const double next = 0.01 * std::pow(100, i / static_cast<double>(samples));
      const double stress = point.move(strain, next, (next - strain) / rate, 20);
      strain = next;
      const double deviation = std::log(
          stress / constant_rate_stress(law_of_organ(organ), strain, rate).total());
      squares += deviation * deviation;
      largest = std::max(largest, std::abs(deviation));
    }
    const double rms = std::sqrt(squares / (samples + 1));
    BOOST_TEST_MESSAGE(organ << " at " << rate << ": rms " << rms << ", max " << largest);
    BOOST_TEST(rms < 0.01);
    BOOST_TEST(largest < 0.02);
  }
}

// Measured to 100 s: liver 2.6 %, kidney 2.2 %, spleen 1.7 %. At 1000 s, ten times the
// fitted times, 21 to 26 %: what the range is for.
BOOST_DATA_TEST_CASE(it_relaxes_as_the_law_within_the_fitted_times, data::make(names),
                     organ) {
  double within = 0, beyond = 0;
  for (const referee::Row& row : referee::rows("tissue_held")) {
    if (row.text("organ") != organ || row.text("rate") == "inf") continue;
    const double strain = row.number("strain"), rate = row.number("rate");
    const double held = row.number("held");
    ShearedPoint point(model_of(organ));
    point.move(0, strain, strain / rate, 400);
    const double deviation =
        std::abs(point.move(strain, strain, held, 1) / row.number("stress") - 1);
    double& largest = held <= FitRange{}.times_held.to ? within : beyond;
    largest = std::max(largest, deviation);
  }
  BOOST_TEST_MESSAGE(organ << ": " << within << " within, " << beyond << " beyond");
  BOOST_TEST(within > 0);
  BOOST_TEST(within < 0.03);
  BOOST_TEST(beyond > 0.1);
}

// Twenty periods from rest, the last one read; 400 steps a period.
// Measured: G' within .9 %, G'' within 4.9 %.
BOOST_DATA_TEST_CASE(small_oscillations_have_the_law_s_moduli, data::make(names), organ) {
  constexpr int steps = 400, periods = 20;
  constexpr double strain = 1e-4;
  double storage_deviation = 0, loss_deviation = 0;
  for (int i = 0; i <= 24; ++i) {
    const double omega = 0.1 * std::pow(10, i / 8.);
    const MaxwellModel& model = model_of(organ);
    const MemoryStep step =
        memory_step(sheared_solid(model), 2 * std::numbers::pi / omega / steps);
    ShearedPoint point(model);
    double storage = 0, loss = 0;
    for (int k = 1; k <= periods * steps; ++k) {
      const double phase = 2 * std::numbers::pi * k / steps;
      const double stress = point.step_to(strain * std::sin(phase), step);
      if (k <= (periods - 1) * steps) continue;
      storage += 2 * stress * std::sin(phase) / (strain * steps);
      loss += 2 * stress * std::cos(phase) / (strain * steps);
    }
    const ComplexModulus expected = small_oscillation(law_of_organ(organ), omega);
    storage_deviation =
        std::max(storage_deviation, std::abs(storage / expected.storage - 1));
    loss_deviation = std::max(loss_deviation, std::abs(loss / expected.loss - 1));
  }
  BOOST_TEST_MESSAGE(organ << ": G' " << storage_deviation << ", G'' " << loss_deviation);
  BOOST_TEST(storage_deviation < 0.02);
  BOOST_TEST(loss_deviation < 0.05);
}

namespace {

/// Norm of the difference from the law over that of the law, over a whole history.
double deviation_over(const std::string& organ, const StrainHistory& history) {
  constexpr int steps = 60;  // of each piece
  ShearedPoint point(model_of(organ));
  double difference = 0, norm = 0;
  for (std::size_t i = 1; i < history.times.size(); ++i) {
    const double begin = history.times[i - 1], dt = (history.times[i] - begin) / steps;
    const MemoryStep step = memory_step(sheared_solid(model_of(organ)), dt);
    for (int k = 1; k <= steps; ++k) {
      const double time = begin + k * dt;
      const double stress_of_point = point.step_to(strain_at(history, time), step);
      const double expected = stress(law_of_organ(organ), history, time);
      difference += std::pow(stress_of_point - expected, 2);
      norm += expected * expected;
    }
  }
  return std::sqrt(difference / norm);
}

}  // namespace

// Stored bands of what was measured, not of what is wanted: a branch that is strained and
// let go hardens by its mean square strain, the law by each strain of the past. To and
// fro, strains of the past reach twice the largest one: liver 13 to 15 %, kidney 14 to
// 17 % at half a strain. Once up to 1 and down it is 1 to 2.3 %, up to .1 below .6 %.
BOOST_AUTO_TEST_CASE(unloading_is_as_far_off_as_measured) {
  const auto triangle = [](double strain, double rate) -> StrainHistory {
    const double T = strain / rate;
    return {{0, T, 2 * T}, {0, strain, 0}};
  };
  const auto to_and_fro = [](double strain, double rate) -> StrainHistory {
    const double T = strain / rate;
    return {{0, T, 3 * T, 5 * T}, {0, strain, -strain, strain}};
  };
  struct Bands {
    std::string organ;
    Range small, once, half, whole;
  };
  const auto expect = [](double deviation, const Range& band, const std::string& what) {
    BOOST_TEST_MESSAGE(what << ": " << deviation);
    BOOST_TEST(band.contains(deviation), what << ": " << deviation);
  };
  for (const auto& [organ, small, once, half, whole] :
       {Bands{"liver", {0, 0.006}, {0.015, 0.025}, {0.13, 0.15}, {0.37, 0.43}},
        Bands{"kidney", {0, 0.006}, {0.015, 0.025}, {0.14, 0.17}, {0.15, 0.185}},
        Bands{"spleen", {0, 0.006}, {0.003, 0.012}, {0.005, 0.018}, {0.02, 0.045}}})
    for (const double rate : rates) {
      const std::string where = organ + " at " + std::to_string(rate);
      expect(deviation_over(organ, triangle(0.1, rate)), small, where + ", up to .1");
      expect(deviation_over(organ, triangle(1, rate)), once, where + ", up to 1");
      expect(deviation_over(organ, to_and_fro(0.5, rate)), half, where + ", +-.5");
      expect(deviation_over(organ, to_and_fro(1, rate)), whole, where + ", +-1");
    }
}

BOOST_AUTO_TEST_SUITE_END()
