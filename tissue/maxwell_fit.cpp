#include "tissue/maxwell_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "meshing/basics/input_error.hpp"
#include "tissue/checks.hpp"
#include "tissue/non_negative_least_squares.hpp"

namespace springcheck::tissue {
namespace {

using Eigen::Index;

/// The two ends of a range, and points between them at equal ratios.
std::vector<double> points_in(const Range& range, double per_decade) {
  const double decades = std::log10(range.to / range.from);
  if (decades == 0) return {range.from};
  const int intervals = static_cast<int>(std::ceil(per_decade * decades));
  std::vector<double> points;
  for (int i = 0; i <= intervals; ++i)
    points.push_back(range.from * std::pow(10, decades * i / intervals));
  return points;
}

struct Ramp {
  double strain, rate, time_held, stress;  // [-], [1/s], [s], [Pa] of the law
};
struct Oscillation {
  double angular_frequency;  // [rad/s]
  ComplexModulus moduli;     // [Pa] of the law
};
struct Samples {
  std::vector<Ramp> constant_rate, held, faster;
  std::vector<Oscillation> oscillations;
};

Samples samples_of(const BipowerLaw& law, const FitRange& range, int density) {
  Samples samples;
  const auto at_constant_rate = [&](double rate, double strain) {
    return Ramp{strain, rate, 0, constant_rate_stress(law, strain, rate).total()};
  };
  for (const double rate : points_in(range.rates, 1.2 * density))
    for (const double strain : points_in(range.strains, 8 * density))
      samples.constant_rate.push_back(at_constant_rate(rate, strain));
  if (range.fastest_guess > range.rates.to)
    for (const double rate :
         points_in({range.rates.to, range.fastest_guess}, 3 * density))
      for (const double strain : points_in(range.strains, 4 * density))
        samples.faster.push_back(at_constant_rate(rate, strain));
  for (const double rate : points_in(range.rates, 1.2 * density))
    for (const double strain : points_in(range.strains, 1.5 * density))
      for (const double time : points_in(range.times_held, 1.5 * density))
        samples.held.push_back(
            {strain, rate, time, ramp_and_hold_stress(law, strain, rate, time).total()});
  for (const double omega : points_in(range.angular_frequencies, 4 * density))
    samples.oscillations.push_back({omega, small_oscillation(law, omega)});
  return samples;
}

constexpr double weight_of_loss = 0.4;

/// Moduli in the order of the unknowns: G_inf, B_inf, G_1, B_1, ..., eta.
MaxwellModel model_of(const BipowerLaw& law, const std::vector<double>& times,
                      const Eigen::VectorXd& x) {
  MaxwellModel model{.elastic = {x[0], x[1]},
                     .viscosity = x[x.size() - 1],
                     .linear_limit = law.linear_limit,
                     .hardening_index = law.hardening_index};
  for (Index i = 0; i < std::ssize(times); ++i)
    model.branches.push_back(
        {times[static_cast<std::size_t>(i)], {x[2 * i + 2], x[2 * i + 3]}});
  return model;
}

/// The model of a law that has K = 1, for one that has another.
MaxwellModel scaled(MaxwellModel model, double consistency) {
  const auto scale = [&](BranchModuli& moduli) {
    moduli.linear *= consistency;
    moduli.hardening *= consistency;
  };
  scale(model.elastic);
  for (MaxwellBranch& branch : model.branches) scale(branch.moduli);
  model.viscosity *= consistency;
  return model;
}

/// What each unknown gives of each sample, over the law's value and times a weight: the
/// sum over the unknowns is the weight where the model follows the law.
class Equations {
 public:
  Equations(const BipowerLaw& law, const Samples& samples, double weight_of_faster,
            const std::vector<double>& times)
      : law_(law), times_(times) {
    const auto unknowns = static_cast<Index>(2 * times.size() + 3);
    const auto rows =
        static_cast<Index>(samples.constant_rate.size() + samples.held.size() +
                           samples.faster.size() + 2 * samples.oscillations.size());
    A_ = Eigen::MatrixXd::Zero(rows, unknowns);
    b_ = Eigen::VectorXd::Ones(rows);
    for (const Ramp& ramp : samples.constant_rate) add(ramp, ramp.rate, 1);
    for (const Ramp& ramp : samples.held) add(ramp, 0, 1);
    for (const Ramp& ramp : samples.faster) add(ramp, ramp.rate, weight_of_faster);
    for (const Oscillation& oscillation : samples.oscillations) add(oscillation);
  }

  /// x and the residual's norm.
  [[nodiscard]] std::pair<Eigen::VectorXd, double> solution() const {
    const Eigen::VectorXd x = non_negative_least_squares(A_, b_);
    return {x, (A_ * x - b_).norm()};
  }

 private:
  void add(const Ramp& ramp, double dashpot_rate, double weight) {
    const double whole = ramp.stress / weight;  // [Pa]
    const auto put = [&](Index unknown, const BranchStrain& strain) {
      const auto stress = [&](const BranchModuli& unit) {
        return strain.mean * branch_stiffness(unit, strain.mean_square, law_.linear_limit,
                                              law_.hardening_index);
      };
      A_(row_, unknown) = stress({1, 0}) / whole;
      A_(row_, unknown + 1) = stress({0, 1}) / whole;
    };
    put(0, {ramp.strain, ramp.strain * ramp.strain});
    for (std::size_t i = 0; i < times_.size(); ++i)
      put(static_cast<Index>(2 * i + 2),
          branch_strain_after_ramp(times_[i], ramp.strain, ramp.rate, ramp.time_held));
    A_(row_, A_.cols() - 1) = dashpot_rate / whole;
    b_[row_] = weight;
    ++row_;
  }

  void add(const Oscillation& oscillation) {
    const auto& [omega, moduli] = oscillation;
    const double loss = moduli.loss / weight_of_loss;
    A_(row_, 0) = 1 / moduli.storage;
    for (std::size_t i = 0; i < times_.size(); ++i) {
      const double x = omega * times_[i];
      A_(row_, static_cast<Index>(2 * i + 2)) = x * x / (1 + x * x) / moduli.storage;
      A_(row_ + 1, static_cast<Index>(2 * i + 2)) = x / (1 + x * x) / loss;
    }
    A_(row_ + 1, A_.cols() - 1) = omega / loss;
    b_[row_ + 1] = weight_of_loss;
    row_ += 2;
  }

  const BipowerLaw& law_;
  const std::vector<double>& times_;
  Eigen::MatrixXd A_;
  Eigen::VectorXd b_;
  Index row_ = 0;
};

/// The ranges in which the first and the last relaxation time may lie. A dashpot and a
/// spring stand for what is faster and slower, which lets both lie inside the range's
/// times.
struct Ends {
  Range first, last;
};
Ends ends_of(const FitRange& range) {
  const double shortest =
      std::min({range.strains.from / range.rates.to, range.times_held.from,
                1 / range.angular_frequencies.to});
  const double longest =
      std::max({range.strains.to / range.rates.from, range.times_held.to,
                1 / range.angular_frequencies.from});
  return {{shortest, 30 * shortest}, {longest / 10, 3 * longest}};
}

void check(const FitRange& range) {
  const auto check_range = [](const std::string& name, const Range& numbers) {
    check_positive("lower end of " + name, numbers.from);
    check_positive("upper end of " + name, numbers.to);
    if (numbers.to < numbers.from)
      throw InputError(
          "tissue", "range of " + name, "a lower end below the upper end",
          std::to_string(numbers.from) + " to " + std::to_string(numbers.to));
  };
  check_range("strains", range.strains);
  check_range("strain rates [1/s]", range.rates);
  check_range("times held [s]", range.times_held);
  check_range("angular frequencies [rad/s]", range.angular_frequencies);
  check_positive("fastest guess [1/s]", range.fastest_guess);
}

/// The best model of all relaxation times.
MaxwellModel best_model(const BipowerLaw& law, const Samples& samples, const Ends& ends,
                        double weight_of_faster, int branches) {
  constexpr double candidates_per_decade = 8;
  double least = std::numeric_limits<double>::infinity();
  MaxwellModel best;
  for (const double first : points_in(ends.first, candidates_per_decade))
    for (const double last : points_in(ends.last, candidates_per_decade)) {
      if (last <= first) continue;
      std::vector<double> times;
      for (int i = 0; i < branches; ++i)
        times.push_back(first * std::pow(last / first, i / (branches - 1.)));
      const auto [x, residual] =
          Equations(law, samples, weight_of_faster, times).solution();
      if (residual < least) {
        least = residual;
        best = model_of(law, times, x);
      }
    }
  return best;
}

}  // namespace

MaxwellFit fit_maxwell_model(const BipowerLaw& law, const FitRange& range, int branches) {
  check(law);
  check(range);
  if (branches < 2 || branches > most_branches)
    throw InputError("tissue", "number of Maxwell branches",
                     "2 to " + std::to_string(most_branches), std::to_string(branches));
  BipowerLaw unit = law;
  unit.consistency =
      1;  // [Pa s^n]; so that no column of the equations under- or overflows
  const Samples samples = samples_of(unit, range, 1);
  const Ends ends = ends_of(range);
  for (double weight_of_faster = 0.05;; weight_of_faster *= 2) {
    const MaxwellModel model =
        best_model(unit, samples, ends, weight_of_faster, branches);
    const FitErrors errors = errors_of(model, unit, range);
    if (errors.guess <= largest_error_of_guess || weight_of_faster >= 0.8)
      return {scaled(model, law.consistency), range, errors};
  }
}

FitErrors errors_of(const MaxwellModel& model, const BipowerLaw& law,
                    const FitRange& range) {
  check(range);
  const Samples samples = samples_of(law, range, 4);
  FitErrors errors{};
  const auto raise = [](double& largest, double value, double expected) {
    largest = std::max(largest, std::abs(value / expected - 1));
  };
  for (const auto& [strain, rate, time, stress] : samples.constant_rate) {
    const double ours = constant_rate_stress(model, strain, rate);
    raise(errors.constant_rate, ours, stress);
    const double log_ratio = std::log(ours / stress);
    errors.constant_rate_rms += log_ratio * log_ratio;
  }
  errors.constant_rate_rms = std::sqrt(errors.constant_rate_rms /
                                       static_cast<double>(samples.constant_rate.size()));
  for (const auto& [strain, rate, time, stress] : samples.held)
    raise(errors.ramp_and_hold, ramp_and_hold_stress(model, strain, rate, time), stress);
  for (const auto& [strain, rate, time, stress] : samples.faster)
    raise(errors.guess, constant_rate_stress(model, strain, rate), stress);
  for (const auto& [omega, moduli] : samples.oscillations) {
    const ComplexModulus ours = small_oscillation(model, omega);
    raise(errors.storage, ours.storage, moduli.storage);
    raise(errors.loss, ours.loss, moduli.loss);
  }
  return errors;
}

}  // namespace springcheck::tissue
