#pragma once

#include <string_view>

#include "tissue/bipower_law.hpp"

namespace springcheck::tissue {

/// gamma_lim_mss, which the thesis fitted by hand in place of the law's gamma_lim, of the
/// organ of that name; throws InputError for any other. Source: Golec 2018, Table 4.2.
double hand_fitted_limit(std::string_view organ);

/// The way in which Eq. 4.4 takes the elongation l - l0 in its elastic part.
enum class Elongation {
  in_metres,  // as printed: |l - l0|^(1-n)
  relative    // l0 |(l - l0)/l0|^(1-n)
};

/// The spring of Eq. 4.4. Its k [N/m] is that of a linear spring.
struct ThesisSpring {
  BipowerLaw law;       // n and p are used
  double strain_limit;  // gamma_lim_mss [-]
  Elongation elongation;
};

/// Tension [N] of a spring of the length l and the rest length l0 [m]:
///
///     {d dl/dt + k |l-l0|^(1-n) sgn(l-l0)} {1 + (|l-l0|/(gamma_lim l0))^(p-(1-n))}
///
/// stiffness          k      [N/m]
/// damping            d      [N s/m], of which the thesis gives no value
/// elongation_rate    dl/dt  [m/s]
///
/// As printed k |l-l0|^(1-n) is no force: k would be in N/m^(1-n), and its number a
/// force that depends on the unit of length. `relative` is that repaired, k l0 |e|^(1-n)
/// with the strain e: cells of any size have the same stress. Of what else is wrong it
/// repairs nothing: the elastic part does not depend on the rate, its tangent at rest is
/// infinite, and p - (1-n) must be positive for it to be 0 there.
///
/// Source: Golec 2018, Eq. 4.4.
double tension(const ThesisSpring& spring, double stiffness, double rest_length,
               double length, double damping = 0, double elongation_rate = 0);

/// What a spring without damping has stored [J], the integral of its tension from l0:
/// with the strain e = |l-l0|/l0 and c = k l0^(1-n), or repaired k l0,
///
///     c l0 {e^(2-n)/(2-n) + e^(p+1)/((p+1) gamma_lim^(p-(1-n)))}
double stored_energy(const ThesisSpring& spring, double stiffness, double rest_length,
                     double length);

/// The tension's derivative by the length [N/m],
///
///     c/l0 {(1-n) e^-n + p e^(p-1)/gamma_lim^(p-(1-n))}
///
/// with e of 1e-9 at least: at rest it has none.
double tangent_stiffness(const ThesisSpring& spring, double stiffness, double rest_length,
                         double length);

}  // namespace springcheck::tissue
