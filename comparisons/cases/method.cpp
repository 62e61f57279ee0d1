#include "comparisons/cases/method.hpp"

#include <algorithm>

#include "comparisons/cases/case.hpp"

namespace springcheck {
namespace {

bool has(const std::vector<std::string_view>& keys, std::string_view key) {
  return std::ranges::find(keys, key) != keys.end();
}

}  // namespace

bool reads(const Method& method, std::string_view key) {
  return has(method.reads, key);
}

bool reads(const CaseSettings& settings, std::string_view key) {
  return reads(settings.method, key) ||
         (reads(settings.method, "lattice") && has(settings.elements.lattice.reads, key));
}

}  // namespace springcheck
