#pragma once

#include <cmath>
#include <limits>

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
/// Source: own. Biquadratic springs: Delingette, Triangular springs for modeling
/// nonlinear membranes (2008), of membranes; Kikuuwe, Tabuchi and Yamamoto, An edge-based
/// computationally efficient formulation of Saint Venant-Kirchhoff tetrahedral finite
/// elements (2009).
enum class StrainMeasure { engineering, green, logarithmic };

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
      return rest_length * std::log1p(difference_of_squares / ((length + other) * other));
    case StrainMeasure::engineering:
      break;
  }
  return difference_of_squares / (length + other);
}

/// W [J]. Of zero length infinite with logarithmic.
inline double spring_energy(StrainMeasure measure, double stiffness, double rest_length,
                            double length) {
  double e = length - rest_length;
  if (measure != StrainMeasure::engineering) {
    if (length == 0 && measure == StrainMeasure::logarithmic)
      return std::numeric_limits<double>::infinity();
    e = elongation(measure, rest_length, e * (length + rest_length), length, rest_length);
  }
  return stiffness / 2 * e * e;
}

/// Of a spring of stiffness 1: its tension T over its length, and dT/dl. length > 0.
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
    case StrainMeasure::engineering:
      break;
  }
  return {.over_length = 1 - rest_length / length, .slope = 1};
}

/// First and second derivative of L s(l/L) by l: without unit, and [1/m]. length > 0.
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
      return {.first = rest_length / length, .second = -rest_length / (length * length)};
    case StrainMeasure::engineering:
      break;
  }
  return {.first = 1, .second = 0};
}

/// U [Pa] of a volume change t. Infinite with logarithmic for t <= -1, of a cell pressed
/// to nothing or turned inside out.
inline double volume_energy(StrainMeasure measure, double volume_modulus, double change) {
  if (measure != StrainMeasure::logarithmic) return volume_modulus / 2 * change * change;
  if (!(change > -1)) return std::numeric_limits<double>::infinity();
  const double logarithm = std::log1p(change);
  return volume_modulus / 2 * logarithm * logarithm;
}

/// U'/kappa and U''/kappa; both 0 where U is infinite.
struct VolumePull {
  double first;
  double second;
};
inline VolumePull volume_pull(StrainMeasure measure, double change) {
  if (measure != StrainMeasure::logarithmic) return {.first = change, .second = 1};
  if (!(change > -1)) return {.first = 0, .second = 0};
  const double J = 1 + change, logarithm = std::log1p(change);
  return {.first = logarithm / J, .second = (1 - logarithm) / (J * J)};
}

}  // namespace springcheck::mss
