#pragma once

#include <span>
#include <string_view>

namespace springcheck::tissue {

/// The strain-hardening bi-power law of soft tissue in simple shear,
///
///     sigma(t) = int G(t - t', gamma(t) - gamma(t')) gamma'(t') dt'
///     G(t, gamma) = K/Gamma(1-n) t^-n {1 + (gamma/gamma_lim)^p}
///
/// Source: Golec 2018, Eq. 4.1 and 4.2, after Nicolle et al. 2010, J. Biomech. 43, 927.
struct BipowerLaw {
  double consistency;      // K [Pa s^n], above 0
  double linear_index;     // n [-], between 0 and 1
  double linear_limit;     // gamma_lim [-], above 0
  double hardening_index;  // p [-], above 0

  friend bool operator==(const BipowerLaw&, const BipowerLaw&) = default;
};

/// Throws InputError where a parameter is out of its range.
void check(const BipowerLaw& law);

struct Organ {
  std::string_view name;
  BipowerLaw law;
};

/// Liver, kidney and spleen of pigs. Source: Golec 2018, Table 4.1.
std::span<const Organ> organs();

/// The law of the organ of that name; throws InputError for any other.
BipowerLaw law_of_organ(std::string_view name);

/// K/Gamma(1-n) t^-n [Pa], what the relaxation modulus is at small strain; t > 0 [s].
/// Source: Golec 2018, Eq. 4.3.
double linear_relaxation_modulus(const BipowerLaw& law, double time);

/// h(D) = D (1 + |D/gamma_lim|^p/(p+1)) [-], the strain that a jump D counts for: the
/// integral of {1 + |g/gamma_lim|^p} from 0 to D.
double hardened_strain(const BipowerLaw& law, double strain);

/// What of a shear stress [Pa] the linear part of the law gives, and what the hardening.
struct ShearStress {
  double linear, hardening;

  [[nodiscard]] double total() const { return linear + hardening; }
};

/// The stress when a strain gamma >= 0 is reached at the constant rate r > 0 [1/s] from
/// rest:
///
///     sigma = K r^n gamma^(1-n)/Gamma(2-n) {1 + (1-n)/(p+1-n) (gamma/gamma_lim)^p}
///
/// Source: Eq. 4.1 integrated. 0 at strain 0, where its tangent is infinite.
ShearStress constant_rate_stress(const BipowerLaw& law, double strain, double rate);

/// The stress at a time s >= 0 after a ramp to the strain gamma >= 0 at the rate r > 0,
/// of the duration T = gamma/r, when the strain is held:
///
///     linear     K r/Gamma(2-n) {(s+T)^(1-n) - s^(1-n)}
///     hardening  K r/Gamma(1-n) (r/gamma_lim)^p int_0^T u^p (u+s)^-n du
///
/// The integral is s^-n T^(p+1)/(p+1) 2F1(n, p+1; p+2; -T/s); taken by quadrature, to
/// 1e-10. Source: Eq. 4.1 integrated.
ShearStress ramp_and_hold_stress(const BipowerLaw& law, double strain, double rate,
                                 double time_held);

/// The stress at a time t > 0 after ever faster ramps to the strain gamma:
///
///     sigma = K/Gamma(1-n) t^-n h(gamma)
///
/// Not G(t, gamma) gamma: on the way, each part of the strain counts with the strain that
/// was still to come, so that the hardening is divided by p+1.
ShearStress ideal_step_stress(const BipowerLaw& law, double strain, double time);

/// Moduli of a small oscillation gamma_0 sin(omega t), long after its start [Pa].
struct ComplexModulus {
  double storage, loss;  // G', G''

  [[nodiscard]] double loss_tangent() const { return loss / storage; }
};

/// G' + i G'' = K (i omega)^n; omega > 0 [rad/s]. Holds for gamma_0 << gamma_lim. Source:
/// Eq. 4.3, transformed.
ComplexModulus small_oscillation(const BipowerLaw& law, double angular_frequency);

}  // namespace springcheck::tissue
