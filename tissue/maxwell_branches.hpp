#pragma once

#include <vector>

#include "tissue/bipower_law.hpp"

namespace springcheck::tissue {

/// Moduli of a branch [Pa], both at least 0, or it would give off energy: it is as stiff
/// as M = G + B (I/gamma_lim^2)^(p/2)/(p+1), I the branch's mean square strain.
struct BranchModuli {
  double linear, hardening;  // G, B
};

struct MaxwellBranch {
  double relaxation_time;  // tau [s], above 0
  BranchModuli moduli;
};

/// A bi-power law as a sum of branches whose state at a time is all that they need of the
/// past. In simple shear, where the branch's mean over the past is
///
///     <f> = exp(-t/tau) f(gamma(t)) + int_0^t exp(-(t-t')/tau) f(gamma(t)-gamma(t'))
///     dt'/tau
///
/// the stress is
///
///     sigma = sum M_i <D>_i + eta gamma',    M_i as in BranchModuli with I = <D^2>_i
///
/// The elastic branch has tau = infinity. memory.hpp is the same in any deformation.
struct MaxwellModel {
  BranchModuli elastic;
  std::vector<MaxwellBranch> branches{};
  double viscosity;        // eta [Pa s], at least 0
  double linear_limit;     // gamma_lim [-], above 0
  double hardening_index;  // p [-], above 0
};

/// Throws InputError where a parameter is out of its range.
void check(const MaxwellModel& model);

/// M = G + B (I/gamma_lim^2)^(p/2)/(p+1) [Pa], mean_square_strain I >= 0.
double branch_stiffness(const BranchModuli& moduli, double mean_square_strain,
                        double linear_limit, double hardening_index);

/// Means of D and of its square, of a branch.
struct BranchStrain {
  double mean, mean_square;
};

/// The mean strains of a branch at a time s >= 0 after a ramp from rest to the strain
/// gamma at the rate r, of the duration T = gamma/r:
///
///     <D>   = r tau (1 - exp(-T/tau)) exp(-s/tau)
///     <D^2> = 2 (r tau)^2 (1 - (1 + T/tau) exp(-T/tau)) exp(-s/tau)
BranchStrain branch_strain_after_ramp(double relaxation_time, double strain, double rate,
                                      double time_held);

/// The model's stresses [Pa], as the law's functions of the same names have them. Where
/// the strain is held the dashpot has let go.
double constant_rate_stress(const MaxwellModel& model, double strain, double rate);
double ramp_and_hold_stress(const MaxwellModel& model, double strain, double rate,
                            double time_held);

/// G' + i G'' = G_inf + sum G_i i omega tau_i/(1 + i omega tau_i) + i omega eta.
ComplexModulus small_oscillation(const MaxwellModel& model, double angular_frequency);

}  // namespace springcheck::tissue
