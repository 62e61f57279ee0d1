#include "comparisons/cost.hpp"

#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

namespace springcheck {
namespace {

double seconds(const CaseSettings& settings) {
  return 1;
}

}  // namespace

double estimated_seconds(const std::vector<Request>& requests) {
  double total = 0;
  std::set<std::string> seen;
  const auto add = [&](const CaseSettings& settings) {
    if (seen.insert(settings_json(settings).dump()).second) total += seconds(settings);
  };
  for (const Request& request : requests) {
    add(request.settings);
    for (const CaseSettings& reference : reference_cases(request)) add(reference);
  }
  return total;
}

}  // namespace springcheck
