#pragma once

#include <vector>

#include "tissue/bipower_law.hpp"
#include "tissue/maxwell_branches.hpp"

namespace springcheck::tissue {

/// A shear strain through time: 0 before the first time, straight between the times, held
/// after the last. A first strain that is not 0 is a jump.
struct StrainHistory {
  std::vector<double> times;    // [s], increasing
  std::vector<double> strains;  // one at each time
};

/// Throws InputError where there are no times, another number of strains, times that do
/// not increase, or numbers that are not finite.
void check(const StrainHistory& history);

double strain_at(const StrainHistory& history, double time);

/// The stress of the law for any such history, loading or not [Pa]; time [s], after the
/// first one if there is a jump. With t counted from the first time
///
///     sigma(t) = G0(t) h(gamma(t)) + int_0^t m(t-t') h(gamma(t) - gamma(t')) dt'
///
/// G0 the linear relaxation modulus, m = -dG0/dt = n G0/t, h the hardened strain: Eq. 4.1
/// integrated by parts, with |gamma|^p for (gamma)^p, which the thesis leaves undefined
/// where strains fall. The piece that reaches t, where m is singular, is taken in closed
/// form; the others by tanh-sinh quadrature over ln(t-t'), cut where gamma(t) - gamma(t')
/// changes its sign; 1e-10.
double stress(const BipowerLaw& law, const StrainHistory& history, double time);

/// The stress of branches for such a history [Pa]. Along a piece of the rate r, from a
/// and b at its begin,
///
///     <D>   = r tau + (a - r tau) exp(-t/tau)
///     <D^2> = 2 (r tau)^2 (1 - exp(-t/tau)) + (b + 2 r (a - r tau) t) exp(-t/tau)
///
/// which solve a' = r - a/tau and b' = 2 r a - b/tau: the means' definition
/// (MaxwellModel) by t. The dashpot has the rate before `time`.
double stress(const MaxwellModel& model, const StrainHistory& history, double time);

}  // namespace springcheck::tissue
