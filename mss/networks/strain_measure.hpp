#pragma once

#include <cmath>
#include <limits>
#include <numbers>

namespace springcheck::mss {

/// The strain s that a spring's energy W = k L^2/2 s^2 is quadratic in, of its length l
/// and that at rest, L, lambda = l/L; and the volume change t, energy U per volume, that
/// goes with it in the volume correction:
///
///     engineering  s = lambda - 1        t = det F - 1   U = kappa/2 t^2    Golec 2018
///     green        s = (lambda^2 - 1)/2  t = tr E        U = kappa/2 t^2
///     logarithmic  s = ln lambda         t = det F - 1   U = kappa/2 ln^2(1 + t)
///
/// with Green's strain E = (F^T F - I)/2. At small strain all are the same. Since
/// l^2 - L^2 = 2 r . E r is linear in E, a lattice whose small-strain tensor is isotropic
/// is with green St-Venant-Kirchhoff's material in every homogeneous state.
///
///     hencky       lambda dW/dlambda = k L^2 (u - 1)/(2 u (a + b u)), u = lambda^2
///                  a = .7, b = .3; d2W/dlambda^2 > 0 to lambda = 1.427
///                  t = det F - 1   U = kappa/2 ln^2(1 + t) + G C(ln(1 + t))
///                  C(q) = q^3/3 down to J = 1/2 (CubicVolume)
///
/// is of another kind: springs that make lattices follow Hencky's law in large strain.
/// With G = sum k L^2/(15 V), the shear modulus of an isotropic lattice, a lattice's
/// stress differs from Hencky's over random principal stretches of +-20 % by a root mean
/// square of 7.5, 4.4, 1.8, .9 % (A = 1), 5.6, 3.4, 1.4, .7 % (A = 16/9) at nu = 0, .25,
/// .4, .499, where engineering strain's differs by 37, 29, 38, 5 %. b is fitted; the pull
/// needs no root and no logarithm. Other springs have other functions with it: virtual
/// springs those of IsochoricSprings, hourglass springs s = ln lambda.
///
/// Source: own. Biquadratic springs: Delingette, Triangular springs for modeling
/// nonlinear membranes (2008), of membranes; Kikuuwe, Tabuchi and Yamamoto, An edge-based
/// computationally efficient formulation of Saint Venant-Kirchhoff tetrahedral finite
/// elements (2009).
enum class StrainMeasure { engineering, green, logarithmic, hencky };

/// L s(l/L) - L s(a/L) [m], by which springs whose length at rest follows a deformation
/// are longer than that: W = k/2 elongation^2.
///
/// difference_of_squares  l^2 - a^2 [m^2], to the digits of small strains
/// length, other          l, a > 0 [m]
inline double elongation(StrainMeasure measure, double rest_length,
                         double difference_of_squares, double length, double other) {
  switch (measure) {
    case StrainMeasure::green:
      return difference_of_squares / (2 * rest_length);
    case StrainMeasure::logarithmic:
    case StrainMeasure::hencky:
      return rest_length * std::log1p(difference_of_squares / ((length + other) * other));
    case StrainMeasure::engineering:
      break;
  }
  return difference_of_squares / (length + other);
}

/// a and b of hencky's springs.
inline constexpr double hencky_constant = 0.7, hencky_slope = 0.3;

/// W/(k L^2) of hencky's springs, of x = lambda^2 - 1 > -1 to the digits of small ones:
///
///     (1/4) [x^2/((1 + x)(1 + b x)) + (ln(1 + y) - y)/a^2],   y = a x/(1 + b x)
double hencky_energy(double x);

/// W [J], infinite for zero length with logarithmic and hencky.
inline double spring_energy(StrainMeasure measure, double stiffness, double rest_length,
                            double length) {
  double e = length - rest_length;
  if (measure == StrainMeasure::hencky) {
    if (length == 0) return std::numeric_limits<double>::infinity();
    return stiffness * rest_length * rest_length *
           hencky_energy(e * (length + rest_length) / (rest_length * rest_length));
  }
  if (measure != StrainMeasure::engineering) {
    if (length == 0 && measure == StrainMeasure::logarithmic)
      return std::numeric_limits<double>::infinity();
    e = elongation(measure, rest_length, e * (length + rest_length), length, rest_length);
  }
  return stiffness / 2 * e * e;
}

/// The pull of a spring of stiffness 1: its tension T over its length, and dT/dl, for
/// length > 0.
struct SpringPull {
  double over_length;
  double slope;
};
inline SpringPull spring_pull(StrainMeasure measure, double rest_length, double length) {
  const double ratio = length / rest_length, square = ratio * ratio;
  switch (measure) {
    case StrainMeasure::green:
      return {.over_length = (square - 1) / 2, .slope = (3 * square - 1) / 2};
    case StrainMeasure::logarithmic:
      return {.over_length = std::log(ratio) / square,
              .slope = (1 - std::log(ratio)) / square};
    case StrainMeasure::hencky: {
      constexpr double a = hencky_constant, b = hencky_slope;
      const double fall = a + b * square;
      const double over_length = (square - 1) / (2 * square * square * fall);
      return {.over_length = over_length,
              .slope = 1 / (square * fall) - over_length * (3 + 2 * b * square / fall)};
    }
    case StrainMeasure::engineering:
      break;
  }
  return {.over_length = 1 - rest_length / length, .slope = 1};
}

/// The first and second derivative of L s(l/L) by l: without unit, and [1/m]. length > 0.
struct ElongationSlopes {
  double first;
  double second;
};
inline ElongationSlopes elongation_slopes(StrainMeasure measure, double rest_length,
                                          double length) {
  switch (measure) {
    case StrainMeasure::green:
      return {.first = length / rest_length, .second = 1 / rest_length};
    case StrainMeasure::logarithmic:
    case StrainMeasure::hencky:
      return {.first = rest_length / length, .second = -rest_length / (length * length)};
    case StrainMeasure::engineering:
      break;
  }
  return {.first = 1, .second = 0};
}

/// Moduli of the volume correction [Pa].
struct VolumeModuli {
  double kappa = 0;
  double cubic = 0;  // G of hencky

  [[nodiscard]] bool act() const { return kappa != 0 || cubic != 0; }
};

/// C of hencky's volume term, of q = ln J, and its derivatives:
///
///     C' = q^2, q >= -p;   2 p^2 - (q + 2 p)^2 below,   p = ln 2
///
/// q^3/3 alone would fall without bound, and pull cells to nothing, as J goes to 0. Below
/// J = 1/2 the parabola of C' is turned round: with any kappa, U grows there without
/// bound, as Hencky's does.
struct CubicVolume {
  double value, first, second;
};
inline CubicVolume cubic_volume(double q) {
  constexpr double p = std::numbers::ln2;
  if (q >= -p) return {.value = q * q * q / 3, .first = q * q, .second = 2 * q};
  const double turned = q + 2 * p;
  return {.value = 2 * p * p * (q + p) - turned * turned * turned / 3,
          .first = 2 * p * p - turned * turned,
          .second = -2 * turned};
}

/// U [Pa] of a volume change t. With logarithmic and hencky it is infinite for t <= -1,
/// that is, for a cell pressed to nothing or turned inside out; with logarithmic and
/// kappa < 0 (nu < 1/4) it falls without bound before.
inline double volume_energy(StrainMeasure measure, const VolumeModuli& moduli,
                            double change) {
  if (measure == StrainMeasure::engineering || measure == StrainMeasure::green)
    return moduli.kappa / 2 * change * change;
  if (!(change > -1)) return std::numeric_limits<double>::infinity();
  const double logarithm = std::log1p(change);
  return moduli.kappa / 2 * logarithm * logarithm +
         moduli.cubic * cubic_volume(logarithm).value;
}

/// U' = modulus first, U'' = modulus second [Pa]; both 0 where U is infinite.
struct VolumePull {
  double modulus;
  double first;
  double second;
};
inline VolumePull volume_pull(StrainMeasure measure, const VolumeModuli& moduli,
                              double change) {
  if (measure == StrainMeasure::engineering || measure == StrainMeasure::green)
    return {.modulus = moduli.kappa, .first = change, .second = 1};
  if (!(change > -1)) return {.modulus = 0, .first = 0, .second = 0};
  const double J = 1 + change, logarithm = std::log1p(change);
  const CubicVolume cube = cubic_volume(logarithm);
  const double first = moduli.kappa * logarithm + moduli.cubic * cube.first,
               second = moduli.kappa + moduli.cubic * cube.second;
  return {.modulus = 1, .first = first / J, .second = (second - first) / (J * J)};
}

}  // namespace springcheck::mss
