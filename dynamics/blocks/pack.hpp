#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

// Why not Highway (libhwy-dev 1.0.3)? With its vectors in these functions, GCC 12 and
// AVX2, a step of springs took as long to the noise of 10 %, and one of explicit elements
// 2.4 (fem-explicit-8p) to 3.6 times as long (fem-explicit-1p), as GCC leaves arrays of
// its vectors, which are classes, in memory: medians of four runs of springcheck_bench,
// 27,000 cells, doubles, one thread, AMD EPYC without AVX-512. It has no approximate
// reciprocals of doubles besides.

// Vectors of the widest registers that a source file is compiled for. A file that uses
// them is compiled once per instruction set, with SPRINGCHECK_PATH naming it: functions
// of different sets must not share a name, or the linker would keep one of them for all.
// Only such files include this header.
namespace springcheck::dynamics::SPRINGCHECK_PATH {

#if defined(__AVX512F__) && defined(__AVX512DQ__)
inline constexpr std::size_t register_bytes = 64;
#elif defined(__AVX2__)
inline constexpr std::size_t register_bytes = 32;
#else
inline constexpr std::size_t register_bytes = 16;
#endif

template <class Real>
struct PackOf {
  typedef Real type __attribute__((vector_size(register_bytes)));
  typedef Real unaligned
      __attribute__((vector_size(register_bytes), aligned(sizeof(Real)), may_alias));
};
template <class Real>
using Pack = typename PackOf<Real>::type;
template <class Real>
inline constexpr std::size_t width = register_bytes / sizeof(Real);

/// `width` numbers from any address that a Real may have.
template <class Real>
inline Pack<Real> load(const Real* from) {
  return *reinterpret_cast<const typename PackOf<Real>::unaligned*>(from);
}
template <class Real>
inline void store(Real* to, Pack<Real> values) {
  *reinterpret_cast<typename PackOf<Real>::unaligned*>(to) = values;
}

template <class Real>
inline Pack<Real> all(Real value) {
  return Pack<Real>{} + value;
}

/// Small whole numbers, one byte each.
template <class Real>
inline Pack<Real> from_bytes(const std::uint8_t* from) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  if constexpr (sizeof(Real) == 8)
    return (Pack<Real>)_mm512_cvtepi32_pd(
        _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(from))));
  else
    return (Pack<Real>)_mm512_cvtepi32_ps(
        _mm512_cvtepu8_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from))));
#elif defined(__AVX2__)
  if constexpr (sizeof(Real) == 8)
    return (Pack<Real>)_mm256_cvtepi32_pd(_mm_cvtepu8_epi32(_mm_loadu_si32(from)));
  else
    return (Pack<Real>)_mm256_cvtepi32_ps(
        _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(from))));
#else
  Pack<Real> values{};
  for (std::size_t i = 0; i < width<Real>; ++i) values[i] = static_cast<Real>(from[i]);
  return values;
#endif
}

/// Numbers of a table {0, c, 2 c, ...} of largest_look_up by their places, one byte each,
/// below 8. With AVX-512 they are looked up, else c is multiplied.
template <class Real>
inline Pack<Real> looked_up(const Real* table, const std::uint8_t* places) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  if constexpr (sizeof(Real) == 8)
    return (Pack<Real>)_mm512_permutexvar_pd(
        _mm512_cvtepu8_epi64(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(places))),
        _mm512_loadu_pd(table));
  else
    return (Pack<Real>)_mm512_permutexvar_ps(
        _mm512_cvtepu8_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(places))),
        _mm512_loadu_ps(table));
#else
  return from_bytes<Real>(places) * table[1];
#endif
}

template <class Real>
inline Pack<Real> larger(Pack<Real> a, Pack<Real> b) {
  return a > b ? a : b;
}

/// 1/sqrt(x) of positive normal numbers, to 1 or 2 units in the last place of a double,
/// 3 of a float. With AVX-512 by the instruction good to 14 bits, y, and the series
/// y (1 + e/2 + 3/8 e^2 + 5/16 e^3 ...), e = 1 - x y^2.
template <class Real>
inline Pack<Real> reciprocal_root(Pack<Real> x) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  if constexpr (sizeof(Real) == 8) {
    const Pack<Real> y = (Pack<Real>)_mm512_rsqrt14_pd((__m512d)x);
    const Pack<Real> e = 1 - x * y * y;
    return y + y * e * (0.5 + e * (0.375 + e * 0.3125));
  } else {
    const Pack<Real> y = (Pack<Real>)_mm512_rsqrt14_ps((__m512)x);
    return y + y * (1 - x * y * y) * 0.5F;
  }
#elif defined(__AVX2__)
  if constexpr (sizeof(Real) == 8)
    return 1 / (Pack<Real>)_mm256_sqrt_pd((__m256d)x);
  else
    return 1 / (Pack<Real>)_mm256_sqrt_ps((__m256)x);
#elif defined(__SSE2__)
  if constexpr (sizeof(Real) == 8)
    return 1 / (Pack<Real>)_mm_sqrt_pd((__m128d)x);
  else
    return 1 / (Pack<Real>)_mm_sqrt_ps((__m128)x);
#else
  for (std::size_t i = 0; i < width<Real>; ++i) x[i] = 1 / std::sqrt(x[i]);
  return x;
#endif
}

/// 1/x of positive normal numbers, to 1 unit in the last place of a double, 2 of a float.
/// With AVX-512 by the instruction good to 14 bits, y, and y (1 + e + e^2 + e^3 ...),
/// e = 1 - x y.
template <class Real>
inline Pack<Real> reciprocal(Pack<Real> x) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  if constexpr (sizeof(Real) == 8) {
    const Pack<Real> y = (Pack<Real>)_mm512_rcp14_pd((__m512d)x);
    const Pack<Real> e = 1 - x * y;
    return y + y * e * (1 + e * (1 + e));
  } else {
    const Pack<Real> y = (Pack<Real>)_mm512_rcp14_ps((__m512)x);
    return y + y * (1 - x * y);
  }
#else
  return 1 / x;
#endif
}

}  // namespace springcheck::dynamics::SPRINGCHECK_PATH
