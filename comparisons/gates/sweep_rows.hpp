#pragma once

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "comparisons/gates/gate.hpp"
#include "comparisons/gates/measure_column.hpp"

namespace springcheck::gates {

/// The cases that a gate names are not there, or cannot be compared.
class NoCase : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The case that meets the selection, or the first of several that agree: with the same
/// status, and the same value of each measure that is asked of them. So do cases of one
/// simulation that differ in their reference, but for deviations from it. Throws NoCase
/// when none meets it, or several that do not agree.
std::size_t one_row(const Columns& cases, const Selection& selection,
                    std::span<const MeasureColumn> asked);

/// Cases of the gate, one for each value of the setting `along`, sorted by it (counts of
/// cells by their product): those that `where` lists, else all that it selects; of
/// several that agree (see one_row) the first. Throws NoCase when a listed one is
/// missing, there are fewer than `least`, or they differ in more than this setting.
std::vector<std::size_t> sweep_rows(const Columns& cases, const Gate& gate,
                                    const std::string& along, std::size_t least,
                                    const MeasureColumn& asked);

/// The gate's three grids with the most cells, from coarse to fine. Throws NoCase like
/// sweep_rows, and when they are not refined by the same factor along all axes.
std::vector<std::size_t> finest_grids(const Columns& cases, const Gate& gate,
                                      const MeasureColumn& asked);

/// Order that the values on three such grids show, see observed_order.
std::optional<double> order_on(const Columns& cases, const std::vector<std::size_t>& rows,
                               const std::vector<double>& values);

}  // namespace springcheck::gates
