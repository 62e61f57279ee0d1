#include "comparisons/tables/tissue/oscillation_table.hpp"

#include <fmt/format.h>

#include <array>

#include "comparisons/tables/plans/planned_requests.hpp"
#include "tissue/maxwell_fit.hpp"

namespace springcheck {
namespace {

constexpr std::array frequencies{0.1, 1., 10., 100.};  // [rad/s]
constexpr double amplitude = 0.001;

/// Stress xz over the amplitude [Pa].
std::optional<double> modulus(const CaseResult& result) {
  const auto& stress = result.measures.mean_stress;
  return stress ? std::optional((*stress)(0, 2) / amplitude) : std::nullopt;
}

CaseSettings swinging(std::string_view organ, double frequency, double cycles) {
  return case_of_scene("tissue-oscillation",
                       {{"organ", organ},
                        {"angular-frequency", frequency},
                        {"cycles", cycles},
                        {"gradient", std::array<double, 9>{0, 0, amplitude}},
                        {"history", 0}});
}

Cell off(const std::optional<double>& value, double law) {
  return {value ? std::optional(100 * (*value / law - 1)) : std::nullopt};
}

Table oscillation_table(std::span<const CaseResult> results) {
  Table table{
      .columns = {{"organ", "organ"},
                  {"angular_frequency", "omega [rad/s]", "{:g}"},
                  {"storage", "G' of the law [Pa]", "{:.5g}"},
                  {"storage_branches", "branches [Pa]", "{:.5g}"},
                  {"storage_springs", "mss-tissue [Pa]", "{:.5g}"},
                  {"storage_off", "off [%]", "{:.2f}"},
                  {"loss", "G'' of the law [Pa]", "{:.5g}"},
                  {"loss_branches", "branches [Pa]", "{:.5g}"},
                  {"loss_springs", "mss-tissue [Pa]", "{:.5g}"},
                  {"loss_off", "off [%]", "{:.2f}"}},
      .notes = {
          "Law: K (i omega)^n, Golec 2018, Eq. 4.3. mss-tissue: a shear of 0.1 % that "
          "swings from rest, 64 steps in a cycle; G' is the stress after 10 1/4 cycles, "
          "at the largest strain, and G'' after 10, at none, over the amplitude."}};
  std::size_t next = 0;
  for (const tissue::Organ& organ : tissue::organs()) {
    const tissue::MaxwellFit fit = tissue::fit_maxwell_model(organ.law);
    for (const double frequency : frequencies) {
      const CaseResult &at_peak = results[next], &at_rest = results[next + 1];
      next += 2;
      const tissue::ComplexModulus law = small_oscillation(organ.law, frequency),
                                   branches = small_oscillation(fit.model, frequency);
      const auto storage = modulus(at_peak), loss = modulus(at_rest);
      table.rows.push_back(
          {.cells = {organ.name, frequency, law.storage, branches.storage,
                     value_or_status(storage, at_peak), off(storage, law.storage),
                     law.loss, branches.loss, value_or_status(loss, at_rest),
                     off(loss, law.loss)},
           .cases = {at_peak.key, at_rest.key}});
    }
  }
  return table;
}

}  // namespace

TablePlan plan_tissue_oscillation_table() {
  PlannedRequests planned;
  for (const tissue::Organ& organ : tissue::organs())
    for (const double frequency : frequencies)
      for (const double cycles : {10.25, 10.})
        planned.add(swinging(organ.name, frequency, cycles));
  return {.requests = planned.take(),
          .make = [](std::span<const CaseResult> results, MeshStore&) {
            return oscillation_table(results);
          }};
}

}  // namespace springcheck
