#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

#include "comparisons/sheets/sheet.hpp"
#include "comparisons/studies/study.hpp"
#include "comparisons/tables/catalogue.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(split_reference_test)

namespace {

/// A row of independent prototypes, nu = 1/4: springs on 10^3 cells (or 4 x 4 x 24) and
/// converged continua by Aitken's extrapolation of q1 on 10, 20, 40 cells.
struct Stored {
  const char *scene, *load, *quantity;
  double springs, cauchy_born, hencky;
};

const std::vector<Stored> stored{
    {"compression", "5 %", "volume change", -3.167, -3.098, -3.060},
    {"compression", "20 %", "volume change", -13.517, -13.203, -12.490},
    {"tension", "5 %", "volume change", 2.505, 2.468, 2.553},
    {"tension", "20 %", "volume change", 8.761, 8.600, 9.876},
    {"shearing", "5 %", "resultant", 0.3386, 0.3312, 0.3289},
    {"shearing", "20 %", "resultant", 1.4606, 1.4336, 1.2994},
    {"torsion", "1 deg", "torque", 1290.9e-6, 1266.2e-6, 1266.0e-6},
    {"torsion", "45 deg", "torque", 59442e-6, 58368e-6, 55829e-6}};

Sheet split_table() {
  const SheetPlan plan = plan_sheet("split");
  MeshStore meshes;
  const auto results =
      run_study(plan.requests, meshes, 2, [](std::size_t, std::size_t) {});
  return plan.make(results, meshes);
}

std::size_t column_of(const Sheet& sheet, const std::string& key) {
  const auto found = std::ranges::find(sheet.columns, key, &Column::key);
  BOOST_TEST_REQUIRE((found != sheet.columns.end()), key);
  return static_cast<std::size_t>(found - sheet.columns.begin());
}

const SheetRow& row(const Sheet& sheet, const Stored& wanted) {
  const auto found = std::ranges::find_if(sheet.rows, [&](const SheetRow& r) {
    return r.cells[0].text == wanted.scene && r.cells[1].text == wanted.load &&
           r.cells[2].text == wanted.quantity;
  });
  BOOST_TEST_REQUIRE((found != sheet.rows.end()), wanted.scene << " " << wanted.load);
  return *found;
}

}  // namespace

// Bands: .02 points of volume and .3 % of force, which are what the two extrapolations
// differ by at most, or so the prototypes' figures were given out.
BOOST_AUTO_TEST_CASE(the_table_repeats_what_independent_programs_found) {
  const Sheet sheet = split_table();
  for (const Stored& wanted : stored)
    BOOST_TEST_CONTEXT(wanted.scene << " " << wanted.load << " " << wanted.quantity) {
      const SheetRow& found = row(sheet, wanted);
      const bool is_volume = std::string(wanted.quantity) == "volume change";
      const auto expect = [&](const char* key, double value) {
        const auto& number = found.cells[column_of(sheet, key)].number;
        BOOST_TEST_REQUIRE(number.has_value(), key);
        BOOST_TEST(
            std::abs(*number - value) < (is_volume ? 0.02 : 0.003 * std::abs(value)),
            key << ": " << *number << " instead of " << value);
      };
      expect("springs", wanted.springs);
      expect("cauchy_born", wanted.cauchy_born);
      expect("reference", wanted.hencky);
      BOOST_TEST(found.cells[column_of(sheet, "state")].text == "resolved");
      // Clamped edges are singular: below second order.
      const auto& order = found.cells[column_of(sheet, "cauchy_born_order")].number;
      BOOST_TEST_REQUIRE(order.has_value());
      BOOST_TEST(*order > 0.7);
      BOOST_TEST(*order < 2);
    }
}

BOOST_AUTO_TEST_SUITE_END()
