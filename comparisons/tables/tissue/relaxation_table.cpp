#include "comparisons/tables/tissue/relaxation_table.hpp"

#include <fmt/format.h>

#include <array>

#include "comparisons/tables/plans/planned_requests.hpp"
#include "tissue/strain_history.hpp"

namespace springcheck {
namespace {

constexpr std::array times_held{0.1, 1., 10., 100.};        // [s]
constexpr std::array strains_left{0.75, 0.5, 0.25, 0.};     // on the way back
constexpr double held_rate = 0.67, unloading_rate = 0.133;  // [1/s]

/// A strain through time that one case goes through.
struct Way {
  std::string_view what;
  tissue::StrainHistory strain;  // from 0 to 1, and on
};

std::vector<Way> ways() {
  std::vector<Way> all;
  constexpr double held = 1 / held_rate, loaded = 1 / unloading_rate;
  for (const double time : times_held)
    all.push_back({"held", {.times = {0, held, held + time}, .strains = {0, 1, 1}}});
  for (const double left : strains_left)
    all.push_back({"unloaded",
                   {.times = {0, loaded, loaded * (2 - left)}, .strains = {0, 1, left}}});
  return all;
}

CaseSettings sheared(std::string_view organ, const Way& way) {
  const auto& [times, strains] = way.strain;
  return case_of_scene("tissue-relaxation",
                       {{"organ", organ},
                        {"load-times", std::array{times[1], times[2]}},
                        {"load-fractions", std::array{strains[1], strains[2]}},
                        {"history", 0}});
}

TableRow row_of(const tissue::Organ& organ, const Way& way, const CaseResult& result) {
  const auto& [times, strains] = way.strain;
  const double law = tissue::stress(organ.law, way.strain, times[2]);
  const bool is_held = strains[2] == strains[1];
  // Back at rest there is nothing to be off by a part of.
  const double scale = is_held ? law : tissue::stress(organ.law, way.strain, times[1]);
  std::optional<double> springs, off;
  if (const auto& stress = result.measures.mean_stress) {
    springs = (*stress)(0, 2);
    off = 100 * (*springs - law) / scale;
  }
  TableRow row{.cells = {organ.name, way.what, strains[1] / times[1], times[2] - times[1],
                         strains[2], law, value_or_status(springs, result), off},
               .cases = {result.key}};
  if (!is_held)
    row.notes.push_back("Deviation in percent of the stress before the strain fell.");
  return row;
}

Table relaxation_table(std::span<const CaseResult> results) {
  Table table{
      .columns = {{"organ", "organ"},
                  {"then", "then"},
                  {"rate", "rate [1/s]", "{:.4g}"},
                  {"time", "time after the ramp [s]", "{:.4g}"},
                  {"strain", "strain", "{:g}"},
                  {"law", "law [Pa]", "{:.5g}"},
                  {"springs", "mss-tissue [Pa]", "{:.5g}"},
                  {"off", "off [%]", "{:.2f}"}},
      .notes = {
          "Law: Golec 2018, Eq. 4.1 and 4.2, with |gamma|^p where strains fall, which "
          "the thesis leaves undefined. mss-tissue: five Maxwell branches, 2 x 2 x 2 "
          "cells, 50 steps on the ramp and 50 after it. The branches are fitted to ramps "
          "and to strains that are held; of large strains that fall nothing is fitted."}};
  std::size_t next = 0;
  for (const tissue::Organ& organ : tissue::organs())
    for (const Way& way : ways())
      table.rows.push_back(row_of(organ, way, results[next++]));
  return table;
}

}  // namespace

TablePlan plan_tissue_relaxation_table() {
  PlannedRequests planned;
  for (const tissue::Organ& organ : tissue::organs())
    for (const Way& way : ways()) planned.add(sheared(organ.name, way));
  return {.requests = planned.take(),
          .make = [](std::span<const CaseResult> results, MeshStore&) {
            return relaxation_table(results);
          }};
}

}  // namespace springcheck
