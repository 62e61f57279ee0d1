#include "comparisons/tables/tissue/rates_table.hpp"

#include <fmt/format.h>

#include <array>

#include "comparisons/tables/plans/planned_requests.hpp"
#include "comparisons/tables/tissue/sheared_tissue.hpp"
#include "tissue/maxwell_fit.hpp"

namespace springcheck {
namespace {

constexpr std::array final_strains{0.1, 0.3, 1.};
// [1/s] The range of the fit, and what is a guess on both sides of it.
constexpr std::array swept_rates{0.001, 0.004, 0.0151, 0.05, 0.133, 0.3,
                                 0.67,  2.,    5.,     10.,  20.,   50.};

Table rates_table(std::span<const CaseResult> results) {
  const tissue::FitRange range;
  Table table{
      .columns = {{"organ", "organ"},
                  {"strain", "strain", "{:g}"},
                  {"rate", "rate [1/s]", "{:g}"},
                  {"in_range", "in the range of the fit"},
                  {"law", "law [Pa]", "{:.5g}"},
                  {"branches", "branches [Pa]", "{:.5g}"},
                  {"branches_off", "off [%]", "{:.2f}"},
                  {"springs", "mss-tissue [Pa]", "{:.5g}"},
                  {"springs_off", "off [%]", "{:.2f}"}},
      .notes = {fmt::format(
          "Law: Golec 2018, Eq. 4.2, a power of the rate. The {} Maxwell branches are "
          "fitted to rates of {:g} to {:g} 1/s; beyond, to {:g} 1/s, they are to stay "
          "within a fifth of the law, and nothing is asked of slower rates. mss-tissue: "
          "2 x 2 x 2 cells, 100 steps of time.",
          tissue::default_branches, range.rates.from, range.rates.to,
          range.fastest_guess)}};
  std::size_t next = 0;
  for (const tissue::Organ& organ : tissue::organs()) {
    const tissue::MaxwellModel model = tissue::fit_maxwell_model(organ.law).model;
    for (const double strain : final_strains)
      for (const double rate : swept_rates) {
        const CaseResult& result = results[next++];
        const double law = tissue::constant_rate_stress(organ.law, strain, rate).total();
        const auto off = [&](double stress) { return 100 * (stress / law - 1); };
        const double branches = tissue::constant_rate_stress(model, strain, rate);
        const auto& found = result.measures.mean_stress;
        const auto springs = found ? std::optional((*found)(0, 2)) : std::nullopt;
        table.rows.push_back(
            {.cells = {organ.name, strain, rate,
                       range.rates.contains(rate) ? "yes" : "no", law, branches,
                       off(branches), value_or_status(springs, result),
                       springs ? Cell(off(*springs)) : Cell()},
             .cases = {result.key}});
      }
  }
  return table;
}

}  // namespace

TablePlan plan_tissue_rates_table() {
  PlannedRequests planned;
  for (const tissue::Organ& organ : tissue::organs())
    for (const double strain : final_strains)
      for (const double rate : swept_rates)
        planned.add(sheared_tissue(organ.name, rate, strain));
  return {.requests = planned.take(),
          .make = [](std::span<const CaseResult> results, MeshStore&) {
            return rates_table(results);
          }};
}

}  // namespace springcheck
