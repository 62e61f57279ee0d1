#include "comparisons/results/case_table.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "comparisons/results/result_file.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/comparisons/settings.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(case_table_test)

namespace {

using Texts = std::vector<std::string>;
using Numbers = std::vector<double>;

/// Cases that only settings tell apart: at rest, and through time in a heavier body.
Columns four_cases() {
  const OwnFolder own;
  MeshStore meshes;
  for (const std::vector<std::string>& given :
       {std::vector<std::string>{"cells=2,2,2", "method=mss-cf,fem-hooke"},
        {"cells=2,2,2", "method=mss-cf", "solver=verlet", "duration=0.01"},
        {"cells=2,2,2", "method=mss-cf", "solver=verlet", "duration=0.02"}}) {
    auto results = run_study(requests(run_of("compression", given)), meshes, 1,
                             [](std::size_t, std::size_t) {});
    ResultFile(own.path / "a.h5").put(results, false, meshes);
  }
  return read_cases(own.path / "a.h5", Revisions::own);
}

Texts names_of(const std::vector<CaseColumn>& table) {
  Texts names;
  for (const CaseColumn& column : table) names.push_back(column.name);
  return names;
}

bool has(const std::vector<CaseColumn>& table, const std::string& name) {
  return std::ranges::count(names_of(table), name) == 1;
}

const CaseColumn& column(const std::vector<CaseColumn>& table, const std::string& name) {
  return *std::ranges::find(table, name, &CaseColumn::name);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_column_stands_for_what_tells_cases_apart) {
  const Columns cases = four_cases();
  const auto table = case_table(cases, {});
  for (const char* name : {"key", "scene", "method", "solver", "duration", "status",
                           "plate_force", "volume_error", "solve_wall_s", "reference"})
    BOOST_TEST(has(table, name), name);
  // Cases at rest lack the steps' settings, which are the same in motion.
  for (const char* name : {"dt-ratio", "noise", "nu", "young", "cells.x",
                           "reference_settings", "tip_deflection"})
    BOOST_TEST(!has(table, name), name);
  BOOST_TEST(column(table, "plate_force").unit == "N");
  BOOST_TEST(column(table, "duration").unit == "s");
  BOOST_TEST(column(table, "method").unit.empty());
  for (const CaseColumn& one : table)
    BOOST_TEST(std::visit([](const auto& values) { return values.size(); }, one.values) ==
               cases.rows);
  BOOST_TEST((differing_settings(cases, {0}).empty()));
}

BOOST_AUTO_TEST_CASE(a_deformation_has_the_unit_of_its_tests) {
  const auto unit = [](std::vector<std::string> tests) {
    const std::vector<double> loads(tests.size(), .1);
    const Columns cases{.rows = tests.size(),
                        .texts = {{"test", std::move(tests)}},
                        .numbers = {{"deformation", {1, loads}}}};
    return case_table(cases, {"deformation"})[0].unit;
  };
  BOOST_TEST(unit({"compression", "shearing"}) == "");
  BOOST_TEST(unit({"torsion"}) == "rad");
  BOOST_TEST(unit({"torsion", "compression"}) == "1 or rad");
}

BOOST_AUTO_TEST_CASE(columns_are_those_chosen_in_their_order) {
  const Columns cases = four_cases();
  BOOST_TEST(names_of(case_table(cases, {"nu", "cells", "key", "size.z"})) ==
                 (Texts{"nu", "cells.x", "cells.y", "cells.z", "key", "size.z"}),
             boost::test_tools::per_element());
  const auto force = case_table(cases, {"plate_force", "size.z", "cells.y"});
  BOOST_TEST(std::get<Numbers>(force[0].values)[0] ==
             cases.numbers.at("plate_force").values[0]);
  BOOST_TEST(std::get<Numbers>(force[1].values)[0] == cases.numbers.at("size").values[2]);
  BOOST_TEST(std::get<Numbers>(force[2].values)[0] == 2);
  // What no case has is empty; what there is not is refused.
  const auto none = case_table(cases, {"tip_deflection"});
  BOOST_TEST(none[0].unit == "m");
  for (const double value : std::get<Numbers>(none[0].values))
    BOOST_TEST(std::isnan(value));
  for (const char* wrong : {"plate_farce", "cells.w", "nu.x", ""})
    BOOST_CHECK_EXCEPTION(case_table(cases, {wrong}), InputError, [&](const auto& error) {
      return std::string(error.what()).find(wrong) != std::string::npos;
    });
}

BOOST_AUTO_TEST_SUITE_END()
