#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <thread>

#include "comparisons/sheets/sheet.hpp"
#include "comparisons/studies/study.hpp"
#include "comparisons/tables/catalogue.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(elements_table_test)

namespace {

/// Numbers of the table by mesh, method and nu, in the order of the columns.
using Rows = std::map<std::string, std::vector<Cell>>;

Rows computed() {
  const SheetPlan plan = plan_sheet("elements");
  MeshStore meshes;
  const auto results =
      run_study(plan.requests, meshes,
                static_cast<int>(std::max(1U, std::thread::hardware_concurrency())),
                [](std::size_t, std::size_t) {});
  Rows rows;
  for (const SheetRow& row : plan.make(results, meshes).rows)
    rows[row.cells[0].text + "/" + row.cells[2].text + "/" +
         std::to_string(row.cells[3].number.value()).substr(0, 5)] = row.cells;
  return rows;
}

constexpr std::size_t off_q2 = 4, volume = 10;  // first columns of three each

}  // namespace

// Bands of the project's own aims: forces within 5 % of Hooke q2 on 5^3 cubes, volumes
// within .1 points of the same law. On tetrahedra closer than linear elements wherever
// these are off by more than .01 % and .001 points.
BOOST_AUTO_TEST_CASE(virtual_springs_are_close_on_every_mesh) {
  const Rows rows = computed();
  for (const std::string springs :
       {"mss-affine", "mss-affine-stvk", "mss-affine-hencky"}) {
    int found = 0;
    for (const auto& [name, cells] : rows) {
      if (name.find("/" + springs + "/") == std::string::npos) continue;
      ++found;
      for (std::size_t test = 0; test < 3; ++test) {
        BOOST_TEST(std::abs(cells[off_q2 + test].number.value()) < 5, name);
        BOOST_TEST(std::abs(cells[volume + test].number.value()) < 0.1, name);
      }
      if (springs != "mss-affine" || !name.starts_with("gmsh")) continue;
      std::string linear = name;
      linear.replace(linear.find(springs), springs.size(),
                     "fem-cauchy-born:q1 (virtual springs)");
      for (const auto& [column, noise] :
           std::map<std::size_t, double>{{off_q2, 0.01}, {volume, 0.001}})
        for (std::size_t test = 0; test < 3; ++test) {
          const double theirs = std::abs(rows.at(linear)[column + test].number.value());
          if (theirs > noise)
            BOOST_TEST(std::abs(cells[column + test].number.value()) < theirs, name);
        }
    }
    BOOST_TEST(found == 3 * 4, springs);  // meshes, Poisson ratios
  }
}

BOOST_AUTO_TEST_SUITE_END()
