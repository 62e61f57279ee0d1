#include "mss/networks/strain_measure.hpp"

#include <cmath>
#include <limits>

namespace springcheck::mss {

double spring_energy(StrainMeasure measure, double stiffness, double rest_length,
                     double length) {
  double e = length - rest_length;
  if (measure != StrainMeasure::engineering) {
    if (length == 0 && measure == StrainMeasure::logarithmic)
      return std::numeric_limits<double>::infinity();
    e = elongation(measure, rest_length, e * (length + rest_length), length, rest_length);
  }
  return stiffness / 2 * e * e;
}

SpringPull spring_pull(StrainMeasure measure, double rest_length, double length) {
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

double elongation(StrainMeasure measure, double rest_length, double difference_of_squares,
                  double length, double other) {
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

ElongationSlopes elongation_slopes(StrainMeasure measure, double rest_length,
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

double volume_energy(StrainMeasure measure, double volume_modulus, double change) {
  if (measure != StrainMeasure::logarithmic) return volume_modulus / 2 * change * change;
  if (!(change > -1)) return std::numeric_limits<double>::infinity();
  const double logarithm = std::log1p(change);
  return volume_modulus / 2 * logarithm * logarithm;
}

VolumePull volume_pull(StrainMeasure measure, double change) {
  if (measure != StrainMeasure::logarithmic) return {.first = change, .second = 1};
  if (!(change > -1)) return {.first = 0, .second = 0};
  const double J = 1 + change, logarithm = std::log1p(change);
  return {.first = logarithm / J, .second = (1 - logarithm) / (J * J)};
}

}  // namespace springcheck::mss
