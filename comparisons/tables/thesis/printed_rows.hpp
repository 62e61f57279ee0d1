#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/settings/run_settings.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/tables/thesis/comparison.hpp"
#include "comparisons/tables/thesis/printed_figures.hpp"

namespace springcheck {

/// The reference of deviations and of the values beside ours; none: the default of
/// requests().
using Reference = std::optional<ReferenceMethod>;

/// The only request of the scene with those changes.
Request printed_request(const std::string& scene, const std::string& method,
                        const GivenSettings& changes, const Reference& reference);

/// A row of our method beside a printed figure.
PlannedRow row_of(const PrintedFigure& figure, const std::string& method,
                  const GivenSettings& further, const Reference& reference);

/// Appends rows of the methods that are not in the thesis, under the load of the i-th
/// figure of a table, where the figures print another load after it: those of one load
/// follow each other.
void add_unprinted(std::vector<PlannedRow>& rows,
                   const std::vector<PrintedFigure>& figures, std::size_t i,
                   const Reference& asked);

/// Rows of tables 5.1 to 5.4: one for each printed figure, but three laws for the FEM
/// column and the E-form beside the mu-form where the printed value needs it; and of each
/// load methods that are not in the thesis.
std::vector<PlannedRow> printed_rows(const std::string& table,
                                     const Reference& reference);

}  // namespace springcheck
