#include "comparisons/cases/method.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/cases/case.hpp"

namespace springcheck {
namespace {

bool has(const std::vector<std::string_view>& keys, std::string_view key) {
  return std::ranges::find(keys, key) != keys.end();
}

}  // namespace

bool has_poisson_ratio(const Method& method, double poisson_ratio) {
  constexpr double three_digits = 1e-3;
  return !method.own_poisson_ratio ||
         std::abs(*method.own_poisson_ratio - poisson_ratio) < three_digits;
}

bool reads(const Method& method, std::string_view key) {
  return has(method.reads, key);
}

bool reads(const CaseSettings& settings, std::string_view key) {
  return reads(settings.method, key) ||
         (reads(settings.method, "lattice") && has(settings.elements.lattice.reads, key));
}

}  // namespace springcheck
