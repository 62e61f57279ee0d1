#include "comparisons/tables/tissue/tissue_table.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "comparisons/tables/plans/planned_requests.hpp"
#include "comparisons/tables/tissue/sheared_tissue.hpp"
#include "mss/tissue/thesis_lattice.hpp"
#include "tissue/maxwell_fit.hpp"

namespace springcheck {
namespace {

constexpr std::array rates{0.0151, 0.133, 0.67};  // [1/s] Golec 2018, section 4.4
constexpr std::array strains{0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.};
constexpr double thesis_edge = 0.005;  // [m] of its cells

/// What deviates from a law, and by how much over all strains.
struct Deviations {
  double squares = 0, largest = 0;
  int count = 0;

  /// Adds one, and returns it in percent.
  double add(double stress, double law) {
    const double ln = std::log(stress / law);
    squares += ln * ln;
    largest = std::max(largest, std::abs(stress / law - 1));
    ++count;
    return 100 * (stress / law - 1);
  }
  [[nodiscard]] std::string text() const {
    const auto percent = [](double part) {
      return part < 1 ? fmt::format("{:.2g} %", 100 * part)
                      : fmt::format("{:.0f} %", 100 * part);
    };
    return fmt::format("{} ({})", percent(std::sqrt(squares / count)), percent(largest));
  }
};

std::string errors_note(std::string_view organ, const tissue::FitErrors& errors) {
  return fmt::format(
      "The branches of {} are off the law by at most {:.2g} % at constant rate (RMS of "
      "ln {:.2g} %), {:.2g} % up to 100 s after a ramp, and {:.2g} and {:.2g} % in G' "
      "and G'' from 0.1 to 100 rad/s; beyond the range, up to {:g} 1/s, by {:.2g} %.",
      organ, 100 * errors.constant_rate, 100 * errors.constant_rate_rms,
      100 * errors.ramp_and_hold, 100 * errors.storage, 100 * errors.loss,
      tissue::FitRange{}.fastest_guess, 100 * errors.guess);
}

/// Rows of an organ at a rate, and the note of their deviations.
void add_rows(Table& table, const tissue::Organ& organ, const tissue::MaxwellModel& model,
              double rate, std::span<const CaseResult> results) {
  using tissue::Elongation;
  const auto thesis = [&](Elongation elongation) {
    return mss::thesis_tissue(organ.law, tissue::hand_fitted_limit(organ.name),
                              elongation, thesis_edge);
  };
  const mss::ThesisTissue printed = thesis(Elongation::in_metres),
                          repaired = thesis(Elongation::relative);
  Deviations of_branches, of_springs, of_printed, of_repaired;
  for (std::size_t i = 0; i < strains.size(); ++i) {
    const double strain = strains[i];
    const tissue::ShearStress law = tissue::constant_rate_stress(organ.law, strain, rate);
    TableRow row{
        .cells = {organ.name, rate, strain, strain / rate, law.total(), law.hardening},
        .cases = {results[i].key}};
    const auto add = [&](double stress, Deviations& deviations) {
      row.cells.push_back(stress);
      row.cells.push_back(deviations.add(stress, law.total()));
    };
    add(tissue::constant_rate_stress(model, strain, rate), of_branches);
    if (const auto& stress = results[i].measures.mean_stress)
      add((*stress)(0, 2), of_springs);
    else
      row.cells.resize(row.cells.size() + 2, name_of(results[i].status));
    add(mss::shear_stress(printed, strain), of_printed);
    add(mss::shear_stress(repaired, strain), of_repaired);
    table.rows.push_back(std::move(row));
  }
  table.notes.push_back(fmt::format(
      "{} at {:g} 1/s, RMS of ln and largest deviation over these strains: branches {}, "
      "mss-tissue {}, Eq. 4.4 as printed {}, repaired {}.",
      organ.name, rate, of_branches.text(),
      of_springs.count > 0 ? of_springs.text() : "-", of_printed.text(),
      of_repaired.text()));
}

Table tissue_table(std::span<const CaseResult> results) {
  Table table{
      .columns = {{"organ", "organ"},
                  {"rate", "rate [1/s]", "{:g}"},
                  {"strain", "strain", "{:g}"},
                  {"time", "time [s]", "{:.4g}"},
                  {"law", "law [Pa]", "{:.5g}"},
                  {"hardening", "of it hardening [Pa]", "{:.4g}"},
                  {"branches", "branches [Pa]", "{:.5g}"},
                  {"off", "off [%]", "{:.2f}"},
                  {"springs", "mss-tissue [Pa]", "{:.5g}"},
                  {"springs_off", "off [%]", "{:.2f}"},
                  {"thesis", "Eq. 4.4 as printed [Pa]", "{:.4g}"},
                  {"thesis_off", "off [%]", "{:.1f}"},
                  {"repaired", "repaired [Pa]", "{:.4g}"},
                  {"repaired_off", "off [%]", "{:.1f}"}},
      .notes = {
          fmt::format(
              "Law: Golec 2018, Eq. 4.1 and 4.2, with Table 4.1's parameters. "
              "Branches: {} of Maxwell's, an elastic one and a dashpot, fitted to "
              "the law with nothing set by hand; mss-tissue: springs with them, "
              "2 x 2 x 2 cells, 100 steps of time.",
              tissue::default_branches),
          "Eq. 4.4: the thesis's spring force on its lattice, with Table 4.2's "
          "hand-fitted limits; repaired: |l - l0|^(1-n) as a strain times l0, which as "
          "printed depends on the unit of length. Neither knows the rate."}};
  std::span<const CaseResult> left = results;
  for (const tissue::Organ& organ : tissue::organs()) {
    const tissue::MaxwellFit fit = tissue::fit_maxwell_model(organ.law);
    for (const double rate : rates) {
      add_rows(table, organ, fit.model, rate, left.first(strains.size()));
      left = left.subspan(strains.size());
    }
    table.notes.push_back(errors_note(organ.name, fit.errors));
  }
  return table;
}

}  // namespace

TablePlan plan_tissue_table() {
  PlannedRequests planned;
  for (const tissue::Organ& organ : tissue::organs())
    for (const double rate : rates)
      for (const double strain : strains)
        planned.add(sheared_tissue(organ.name, rate, strain));
  return {.requests = planned.take(),
          .make = [](std::span<const CaseResult> results, MeshStore&) {
            return tissue_table(results);
          }};
}

}  // namespace springcheck
