#include "comparisons/tables/studies/locking_table.hpp"

#include <fmt/format.h>

#include <array>

#include "comparisons/measures/measure_list.hpp"
#include "comparisons/settings/scene_file.hpp"

namespace springcheck {
namespace {

const std::vector<std::string> laws_that_lock{"fem-hooke", "fem-hencky"};
const std::array<double, 3> ratios{0.49, 0.499, 0.4999};
const std::vector<std::string> element_names{"q1", "q1-sri", "q2"};

std::optional<double> ratio(const std::optional<double>& a,
                            const std::optional<double>& b) {
  if (!a || !b) return std::nullopt;
  return *a / *b;
}

Table locking_table(std::span<const CaseResult> results) {
  Table table{
      .columns = {{"law", "law"},
                  {"nu", "nu", "{}"},
                  {"element", "element"},
                  {"plate_force", heading_of(*find_measure("plate_force")), "{:.6g}"},
                  {"over_q1_sri", "over q1-sri's", "{:.3f}"},
                  {"over_q2", "over q2's", "{:.3f}"},
                  {"volume_error", "e [%]", "{:.4f}"},
                  {"status", "status"}},
      .notes = {
          "All on the same mesh of 10 x 10 x 10 cells. q1 integrates the volumetric part "
          "of the law at 2 x 2 x 2 points and locks: its force grows like 1/(1 - 2 nu). "
          "The volume change e = |V - V0|/V0 hardly shows it. Neither q1-sri nor q2 is "
          "the exact "
          "solution; that they agree is what speaks for both."}};
  for (std::size_t first = 0; first < results.size(); first += element_names.size()) {
    const auto same_problem = results.subspan(first, element_names.size());
    const auto force_of = [&](std::size_t i) {
      return same_problem[i].measures.plate_force;
    };
    for (std::size_t i = 0; i < same_problem.size(); ++i) {
      const CaseResult& result = same_problem[i];
      const CaseSettings& settings = result.request.settings;
      const auto& e = result.measures.volume_error;
      table.rows.push_back(
          {.cells = {settings.method.name, settings.material.poisson_ratio,
                     element_names[i], value_or_status(force_of(i), result),
                     ratio(force_of(i), force_of(1)), ratio(force_of(i), force_of(2)),
                     e ? std::optional(100 * *e) : std::nullopt, name_of(result.status)},
           .cases = {result.key}});
    }
  }
  return table;
}

}  // namespace

TablePlan plan_locking_table() {
  TablePlan plan{.make = [](std::span<const CaseResult> results, MeshStore&) {
    return locking_table(results);
  }};
  for (const std::string& law : laws_that_lock)
    for (const double nu : ratios)
      for (const std::string& element : element_names)
        // Iterations of q2 grow as nu nears 1/2: at .4999 a factor takes a sixth of the
        // time.
        plan.requests.push_back(
            {.settings = case_of_scene(
                 "compression",
                 GivenSettings{{"method", law},
                               {"nu", nu},
                               {"deformation", 0.05},
                               {"element", element}} +
                     (element == "q2" ? GivenSettings{{"linear-solver", "direct"}}
                                      : GivenSettings{}))});
  return plan;
}

}  // namespace springcheck
