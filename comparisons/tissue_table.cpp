#include "comparisons/tissue_table.hpp"

#include <fmt/format.h>

#include <array>

#include "tissue/maxwell_fit.hpp"

namespace springcheck {
namespace {

constexpr std::array rates{0.0151, 0.133, 0.67};  // [1/s] Golec 2018, section 4.4
constexpr std::array strains{0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.};

std::string errors_note(std::string_view organ, const tissue::FitErrors& errors) {
  return fmt::format(
      "The branches of {} are off the law by at most {:.2g} % at constant rate (RMS of "
      "ln "
      "{:.2g} %), {:.2g} % up to 100 s after a ramp, and {:.2g} and {:.2g} % in G' and "
      "G'' "
      "from 0.1 to 100 rad/s.",
      organ, 100 * errors.constant_rate, 100 * errors.constant_rate_rms,
      100 * errors.ramp_and_hold, 100 * errors.storage, 100 * errors.loss);
}

Sheet tissue_sheet() {
  Sheet sheet{.name = "tissue",
              .title = "Bi-power tissue in simple shear at constant rate",
              .columns = {{"organ", "organ"},
                          {"rate", "rate [1/s]", "{:g}"},
                          {"strain", "strain", "{:g}"},
                          {"time", "time [s]", "{:.4g}"},
                          {"law", "law [Pa]", "{:.5g}"},
                          {"hardening", "of it hardening [Pa]", "{:.4g}"},
                          {"branches", "five branches [Pa]", "{:.5g}"},
                          {"off", "off [%]", "{:.2f}"}},
              .rows = {},
              .notes = {"Law: Golec 2018, Eq. 4.1 and 4.2, with Table 4.1's parameters. "
                        "Branches: five of Maxwell's, an elastic one and a dashpot, "
                        "fitted to the law with nothing set by hand."}};
  for (const tissue::Organ& organ : tissue::organs()) {
    const tissue::MaxwellFit fit = tissue::fit_maxwell_model(organ.law);
    for (const double rate : rates)
      for (const double strain : strains) {
        const tissue::ShearStress law =
            tissue::constant_rate_stress(organ.law, strain, rate);
        const double branches = tissue::constant_rate_stress(fit.model, strain, rate);
        sheet.rows.push_back({.cells = {{.text = std::string(organ.name)},
                                        {.number = rate},
                                        {.number = strain},
                                        {.number = strain / rate},
                                        {.number = law.total()},
                                        {.number = law.hardening},
                                        {.number = branches},
                                        {.number = 100 * (branches / law.total() - 1)}}});
      }
    sheet.notes.push_back(errors_note(organ.name, fit.errors));
  }
  return sheet;
}

}  // namespace

SheetPlan plan_tissue_table() {
  return {.requests = {},
          .make = [](std::span<const CaseResult>, MeshStore&) { return tissue_sheet(); }};
}

}  // namespace springcheck
