#pragma once

#include <initializer_list>

#include "dynamics/blocks/pack.hpp"

// Powers of packs of doubles: included, like pack.hpp, by files compiled once per
// instruction set.
namespace springcheck::dynamics::SPRINGCHECK_PATH {

typedef std::uint64_t Bits __attribute__((vector_size(register_bytes)));

/// log2(x) of positive normal numbers, x = 2^e m with m from sqrt(1/2) to sqrt(2):
/// e + 2/ln 2 artanh(t), t = (m-1)/(m+1), by its series up to t^15, to 4e-14 of log2(m).
/// Of 0 below -1022.
[[gnu::always_inline]] inline Pack<double> log2(Pack<double> x) {
  constexpr std::uint64_t root_of_half = 0x3fe6a09e667f3bcd, bias = 1023;
  const Bits bits = (Bits)x;
  const Bits exponent = (bits - root_of_half + (bias << 52)) >> 52;  // + bias
  const Pack<double> m = (Pack<double>)(bits - ((exponent - bias) << 52));
  // A small whole number as the last bits of 2^52.
  constexpr std::uint64_t bits_of_2_52 = 0x4330000000000000;
  const Pack<double> e =
      (Pack<double>)(exponent | bits_of_2_52) - (0x1p52 + static_cast<double>(bias));
  const Pack<double> t = (m - 1) * reciprocal<double>(m + 1), s = t * t;
  Pack<double> sum = all(1. / 15);
  for (int k = 13; k > 0; k -= 2) sum = sum * s + 1. / k;
  constexpr double two_over_ln_2 = 2.885390081777926814719849362003784070;
  return e + two_over_ln_2 * t * sum;
}

/// 2^y, y cut to -1000 and 1000: the series of e^(f ln 2), |f| <= 1/2, up to its 11th
/// power, to 9e-15, and the whole part as an exponent.
[[gnu::always_inline]] inline Pack<double> exp2(Pack<double> y) {
  y = y > 1000. ? all(1000.) : y;
  y = y < -1000. ? all(-1000.) : y;
  constexpr double to_whole = 0x1.8p52;  // its last bit counts as 1
  const Pack<double> shifted = y + to_whole;
  constexpr double ln_2 = 0.693147180559945309417232121458176568;
  const Pack<double> f = (y - (shifted - to_whole)) * ln_2;
  Pack<double> sum = all(1. / 39916800);  // 1/11!
  for (const double coefficient : {1. / 3628800, 1. / 362880, 1. / 40320, 1. / 5040,
                                   1. / 720, 1. / 120, 1. / 24, 1. / 6, 1. / 2, 1., 1.})
    sum = sum * f + coefficient;
  return (Pack<double>)((Bits)sum + ((Bits)shifted << 52));
}

/// x^q of positive normal numbers, to 1e-14 + 2e-14 q + 2e-16 |log2 x^q|;
/// of 0, with q > 0, less than 2^(-1000 min(q, 1)).
[[gnu::always_inline]] inline Pack<double> power(Pack<double> x, double q) {
  return exp2(q * log2(x));
}

}  // namespace springcheck::dynamics::SPRINGCHECK_PATH
