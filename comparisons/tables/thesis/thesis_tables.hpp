#pragma once

#include <string_view>

#include "comparisons/tables/thesis/printed_rows.hpp"

namespace springcheck {

/// What Golec 2018 printed in one of tables 5.1 to 5.4.
Quantity printed_quantity(std::string_view table);

// What Golec 2018 printed of comparisons, and ours beside it. Tables 5.1 to 5.4:
ComparisonPlan plan_compression(const Reference& reference);
ComparisonPlan plan_tension(const Reference& reference);
ComparisonPlan plan_shearing(const Reference& reference);
ComparisonPlan plan_torsion(const Reference& reference);

/// Distance of springs' points from the reference's, section 5.6.2.
ComparisonPlan plan_deviation(const Reference& reference);

/// Beams under gravity, shown in figures 5.15 to 5.19, beside beam theory.
ComparisonPlan plan_bending(const Reference& reference);

}  // namespace springcheck
