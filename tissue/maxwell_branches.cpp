#include "tissue/maxwell_branches.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

#include "meshing/basics/input_error.hpp"
#include "tissue/checks.hpp"

namespace springcheck::tissue {
namespace {

double stress_of(const MaxwellModel& model, const BranchModuli& moduli,
                 const BranchStrain& strain) {
  return strain.mean * branch_stiffness(moduli, strain.mean_square, model.linear_limit,
                                        model.hardening_index);
}

double branches_stress(const MaxwellModel& model, double strain, double rate,
                       double time_held) {
  double sum = stress_of(model, model.elastic, {strain, strain * strain});
  for (const auto& [tau, moduli] : model.branches)
    sum +=
        stress_of(model, moduli, branch_strain_after_ramp(tau, strain, rate, time_held));
  return sum;
}

}  // namespace

void check(const MaxwellModel& model) {
  const auto check_moduli = [](const BranchModuli& moduli) {
    check_not_negative("modulus G of a branch [Pa]", moduli.linear);
    check_not_negative("modulus B of a branch [Pa]", moduli.hardening);
  };
  check_moduli(model.elastic);
  for (const auto& [tau, moduli] : model.branches) {
    check_positive("relaxation time of a branch [s]", tau);
    check_moduli(moduli);
  }
  check_not_negative("viscosity [Pa s]", model.viscosity);
  check_positive("linear limit gamma_lim", model.linear_limit);
  check_positive("hardening index p", model.hardening_index);
}

double branch_stiffness(const BranchModuli& moduli, double mean_square_strain,
                        double linear_limit, double hardening_index) {
  if (moduli.hardening == 0) return moduli.linear;
  const double p = hardening_index;
  return moduli.linear +
         moduli.hardening / (p + 1) *
             std::pow(mean_square_strain / (linear_limit * linear_limit), p / 2);
}

BranchStrain branch_strain_after_ramp(double relaxation_time, double strain, double rate,
                                      double time_held) {
  const double tau = relaxation_time, x = strain / (rate * tau);
  const double step = rate * tau, left = std::exp(-time_held / tau);
  // P(2, x) = 1 - (1+x) exp(-x), which keeps its digits at small x.
  return {step * -std::expm1(-x) * left,
          2 * step * step * boost::math::gamma_p(2, x) * left};
}

double constant_rate_stress(const MaxwellModel& model, double strain, double rate) {
  check(model);
  check_not_negative("strain", strain);
  check_positive("strain rate [1/s]", rate);
  return branches_stress(model, strain, rate, 0) + model.viscosity * rate;
}

double ramp_and_hold_stress(const MaxwellModel& model, double strain, double rate,
                            double time_held) {
  check(model);
  check_not_negative("strain", strain);
  check_positive("strain rate [1/s]", rate);
  check_not_negative("time held [s]", time_held);
  return branches_stress(model, strain, rate, time_held);
}

ComplexModulus small_oscillation(const MaxwellModel& model, double angular_frequency) {
  check(model);
  check_positive("angular frequency [rad/s]", angular_frequency);
  ComplexModulus sum{model.elastic.linear, model.viscosity * angular_frequency};
  for (const auto& [tau, moduli] : model.branches) {
    const double x = angular_frequency * tau;
    sum.storage += moduli.linear * x * x / (1 + x * x);
    sum.loss += moduli.linear * x / (1 + x * x);
  }
  return sum;
}

}  // namespace springcheck::tissue
