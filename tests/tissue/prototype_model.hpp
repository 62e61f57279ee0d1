#pragma once

#include "tests/tissue/reference_rows.hpp"
#include "tissue/maxwell_branches.hpp"

namespace springcheck::tissue {

/// The model E1 of e1_parameters.csv. The dashpot's row has eta in G's column.
inline MaxwellModel prototype_model(const std::string& organ,
                                    const std::string& branches) {
  const BipowerLaw law = law_of_organ(organ);
  MaxwellModel model{.elastic = {0, 0},
                     .branches = {},
                     .viscosity = 0,
                     .linear_limit = law.linear_limit,
                     .hardening_index = law.hardening_index};
  for (const ReferenceRow& row : reference_rows("e1_parameters.csv")) {
    const bool is_ours = row.text("organ") == organ && row.text("model") == "E1" &&
                         row.text("N") == branches;
    if (!is_ours) continue;
    const double G = row.number("G_i_Pa");
    if (row.text("branch") == "dashpot")
      model.viscosity = G;
    else if (row.text("branch") == "inf")
      model.elastic = {G, row.number("B_i_Pa")};
    else
      model.branches.push_back({row.number("tau_s"), {G, row.number("B_i_Pa")}});
  }
  return model;
}

}  // namespace springcheck::tissue
