#include "comparisons/stability/atlas_limits.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "comparisons/methods/methods.hpp"
#include "comparisons/stability/atlas_cases.hpp"
#include "statics/last_stable_equilibrium.hpp"

namespace springcheck {
namespace {

constexpr double precision = 0.01;  // of limits

/// A method at a value of the second axis: what has one limit along the first.
struct Line {
  std::size_t method;                       // place among the methods
  std::vector<std::string> others;          // value of the second axis, if there is one
  std::vector<const AtlasPoint*> points{};  // along the first
};

/// Whether it tells of the body: a solver's failure and a refusal do not.
bool is_of_the_body(Failure failure) {
  return fails(failure) && failure != Failure::solver && failure != Failure::not_covered;
}

AtlasLimit unknown_limit(const Line& line) {
  return {.method = line.points.front()->method,
          .other = line.others.empty() ? std::nullopt : std::optional(line.others[0]),
          .failure = Failure::none};
}

void take_failure(AtlasLimit& limit, const CaseResult& result, Failure failure) {
  limit.failure = failure;
  limit.reason = result.reason;
  limit.wavelength = result.measures.critical_wavelength;
  limit.cases = {result.key};
}

/// The limit by a static case that tells how far its path was stable; none where it does
/// not tell.
std::optional<AtlasLimit> limit_on_path(const Line& line, const CaseResult& result,
                                        double unit) {
  AtlasLimit limit = unknown_limit(line);
  const double whole = unit * std::abs(*result.request.settings.deformation);
  take_failure(limit, result, failure_of(result));
  if (!fails(limit.failure)) {
    limit.low = whole;
    return limit;
  }
  const bool is_limit = solver_of(result.request.settings) == Solver::path_limit;
  if (!is_limit || !result.measures.definite_up_to_deformation) return std::nullopt;
  limit.low = unit * std::abs(*result.measures.definite_up_to_deformation);
  limit.high = *limit.low / (1 - statics::limit_resolution);
  return limit;
}

/// Two values of the first axis, of which a line holds at one and fails at the other.
struct Bracket {
  AtlasLimit limit;
  Line line;
  std::string holding, failing;
  double floor;           // width that is narrow next to 0 too
  bool is_stuck = false;  // between them something fails that is not the body
  [[nodiscard]] bool is_wide() const {
    const double a = number_of(holding), b = number_of(failing);
    return !is_stuck &&
           std::abs(a - b) >
               std::max(floor, precision * std::max(std::abs(a), std::abs(b)));
  }
};

std::vector<std::string> with_others(const std::string& value, const Line& line) {
  std::vector<std::string> values{value};
  values.insert(values.end(), line.others.begin(), line.others.end());
  return values;
}

/// Halves every bracket until all are narrow, a batch of cases at a time.
void bisect(const AtlasPlan& plan, CaseRunner& runner, std::vector<Bracket>& brackets) {
  while (true) {
    std::vector<Bracket*> wide;
    std::vector<CaseSettings> cases;
    for (Bracket& bracket : brackets) {
      if (!bracket.is_wide()) continue;
      wide.push_back(&bracket);
      cases.push_back(cases_at(plan, with_others(middle(bracket.holding, bracket.failing),
                                                 bracket.line))[bracket.line.method]);
    }
    if (wide.empty()) return;
    const std::vector<CaseResult> results = runner.run(cases);
    const std::vector<Failure> failures = failures_of(plan, runner, results);
    for (std::size_t i = 0; i < wide.size(); ++i) {
      Bracket& bracket = *wide[i];
      const Failure failure = failures[i];
      bracket.is_stuck = fails(failure) && !is_of_the_body(failure);
      if (bracket.is_stuck) continue;
      (fails(failure) ? bracket.failing : bracket.holding) =
          middle(bracket.holding, bracket.failing);
      if (fails(failure)) take_failure(bracket.limit, results[i], failure);
    }
  }
}

std::vector<Line> lines_of(const Atlas& atlas) {
  std::map<std::pair<std::string, std::vector<std::string>>, std::size_t> places;
  std::vector<Line> lines;
  std::vector<std::string> methods;
  for (const AtlasPoint& point : atlas.points) {
    if (std::ranges::count(methods, point.method) == 0) methods.push_back(point.method);
    const std::vector<std::string> others(point.values.begin() + 1, point.values.end());
    const auto [place, is_new] = places.try_emplace({point.method, others}, lines.size());
    if (is_new)
      lines.push_back({.method = static_cast<std::size_t>(
                           std::ranges::find(methods, point.method) - methods.begin()),
                       .others = others});
    lines[place->second].points.push_back(&point);
  }
  return lines;
}

/// Cases of solver limit at the end of each line in statics whose method has it; none
/// with noise, which no path has.
std::map<std::size_t, CaseResult> path_limits(CaseRunner& runner,
                                              const std::vector<Line>& lines) {
  std::vector<std::size_t> places;
  std::vector<CaseSettings> cases;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const CaseSettings& settings = lines[i].points.back()->result.request.settings;
    const auto& solvers = settings.method.solvers;
    if (std::ranges::find(solvers, Solver::path_limit) == solvers.end() ||
        solver_of(settings) != Solver::static_equilibrium || settings.search.noise > 0)
      continue;
    places.push_back(i);
    cases.push_back(settings);
    cases.back().solver = Solver::path_limit;
  }
  const std::vector<CaseResult> results = runner.run(cases);
  std::map<std::size_t, CaseResult> found;
  for (std::size_t i = 0; i < places.size(); ++i) found.emplace(places[i], results[i]);
  return found;
}

/// Neighbouring values of which the line holds at one and fails, by the body, at the
/// other: the places of both, nearest to the first value.
std::optional<std::pair<std::size_t, std::size_t>> change_along(const Line& line) {
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const Failure here = line.points[i]->failure, next = line.points[i + 1]->failure;
    if (!fails(here) && is_of_the_body(next)) return std::pair(i, i + 1);
    if (is_of_the_body(here) && !fails(next)) return std::pair(i + 1, i);
  }
  return std::nullopt;
}

/// The limit of a line that does not change between holding and failing.
AtlasLimit limit_without_change(const Line& line, const Axis& axis) {
  AtlasLimit limit = unknown_limit(line);
  const auto first = std::ranges::find_if(
      line.points, [](const AtlasPoint* point) { return fails(point->failure); });
  const auto place = static_cast<std::size_t>(first - line.points.begin());
  if (place > 0) limit.low = number_of(axis.values[place - 1]);
  if (first == line.points.end()) return limit;
  take_failure(limit, (*first)->result, (*first)->failure);
  if (is_of_the_body(limit.failure)) limit.high = number_of(axis.values[place]);
  return limit;
}

}  // namespace

std::vector<AtlasLimit> limits_of(const Atlas& atlas, const AtlasPlan& plan,
                                  CaseRunner& runner) {
  constexpr double next_to_zero = 1e-4;  // of the axis: a width that is narrow there
  const std::vector<Line> lines = lines_of(atlas);
  const Axis& axis = plan.axes[0];
  const double start = number_of(axis.values.front()),
               end = number_of(axis.values.back());
  // Paths lead from rest to the last value: those to negative ones are bisected.
  const bool has_paths = axis.key == "deformation" && start >= 0;
  const double unit = units_per_one(unit_of(axis.values.front()));
  std::map<std::size_t, CaseResult> on_path;
  if (has_paths) on_path = path_limits(runner, lines);
  std::vector<AtlasLimit> limits(lines.size());
  std::vector<Bracket> brackets;
  std::vector<std::size_t> bracketed;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Line& line = lines[i];
    const auto first = std::ranges::find_if(
        line.points, [](const AtlasPoint* point) { return fails(point->failure); });
    const bool locks_first =
        first != line.points.end() && (*first)->failure == Failure::locking;
    const auto known = on_path.find(i);
    const CaseResult* path = known != on_path.end()                    ? &known->second
                             : has_paths && first != line.points.end() ? &(*first)->result
                                                                       : nullptr;
    if (path != nullptr && !locks_first)
      if (const auto found = limit_on_path(line, *path, unit)) {
        limits[i] = *found;
        continue;
      }
    const auto change = change_along(line);
    if (!change) {
      limits[i] = limit_without_change(line, axis);
      continue;
    }
    const auto& [holding, failing] = *change;
    Bracket bracket{.limit = unknown_limit(line),
                    .line = line,
                    .holding = axis.values[holding],
                    .failing = axis.values[failing],
                    .floor = next_to_zero * (end - start)};
    take_failure(bracket.limit, line.points[failing]->result,
                 line.points[failing]->failure);
    brackets.push_back(std::move(bracket));
    bracketed.push_back(i);
  }
  bisect(plan, runner, brackets);
  for (std::size_t b = 0; b < brackets.size(); ++b) {
    AtlasLimit& limit = limits[bracketed[b]] = brackets[b].limit;
    limit.low = number_of(brackets[b].holding);
    limit.high = number_of(brackets[b].failing);
  }
  return limits;
}

}  // namespace springcheck
