#include "tests/house/arrows.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <sstream>

BOOST_AUTO_TEST_SUITE(arrows_test)

namespace {

const std::vector<Room> small_house = read_rooms(R"(
# a cellar, and what stands on it
cellar:
hall: cellar
attic: cellar hall
tests/**: cellar hall
)");

const std::vector<Include> as_listed{{"cellar/wine.cpp", 1, "cellar/wine.hpp"},
                                     {"hall/door.cpp", 1, "cellar/wine.hpp"},
                                     {"attic/box.cpp", 1, "cellar/wine.hpp"},
                                     {"attic/box.cpp", 2, "hall/door.hpp"},
                                     {"tests/hall/door_test.cpp", 1, "hall/door.hpp"},
                                     {"tests/hall/door_test.cpp", 2, "tests/bell.hpp"},
                                     {"tests/wine_test.cpp", 1, "cellar/wine.hpp"}};

std::vector<std::string> faults_with(const Include& further) {
  std::vector<Include> includes = as_listed;
  includes.push_back(further);
  return faults(small_house, includes);
}

void expect_one_fault(const std::vector<std::string>& found,
                      const std::string& expected) {
  BOOST_TEST_REQUIRE(found.size() == 1U);
  BOOST_TEST(found.front() == expected);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_include_of_the_repository_is_on_the_list) {
  std::ifstream file("docs/rooms.txt");
  BOOST_TEST_REQUIRE(file.is_open());
  std::ostringstream text;
  text << file.rdbuf();
  const std::vector<Include> includes = includes_below(".");
  BOOST_TEST(includes.size() > 1000U);  // they were found
  for (const std::string& fault : faults(read_rooms(text.str()), includes))
    BOOST_ERROR(fault);
}

BOOST_AUTO_TEST_CASE(a_house_as_it_is_listed_has_no_fault) {
  BOOST_TEST(faults(small_house, as_listed).empty());
}

BOOST_AUTO_TEST_CASE(an_include_that_is_not_listed_is_a_fault) {
  expect_one_fault(faults_with({"hall/door.cpp", 7, "attic/box.hpp"}),
                   "hall/door.cpp:7: includes attic/box.hpp, but hall may not see attic");
  expect_one_fault(faults_with({"tests/hall/door_test.cpp", 3, "attic/box.hpp"}),
                   "tests/hall/door_test.cpp:3: includes attic/box.hpp, but tests/** may "
                   "not see attic");
}

BOOST_AUTO_TEST_CASE(a_file_that_stands_in_no_room_is_a_fault) {
  expect_one_fault(faults_with({"garden/tree.cpp", 2, "cellar/wine.hpp"}),
                   "garden/tree.cpp:2: the list has no line for garden");
}

// Where every room sees only those above it, no circle is left.
BOOST_AUTO_TEST_CASE(a_circle_of_folders_is_a_fault_though_it_is_listed) {
  std::vector<Room> rooms = small_house;
  rooms.front().sees = {"hall"};
  std::vector<Include> includes = as_listed;
  includes.push_back({"cellar/wine.cpp", 2, "hall/door.hpp"});
  expect_one_fault(faults(rooms, includes),
                   "cellar sees hall, which does not stand above it");
}

BOOST_AUTO_TEST_CASE(an_entry_that_nobody_uses_is_a_fault) {
  std::vector<Include> includes = as_listed;
  includes.erase(includes.begin() + 3);
  expect_one_fault(faults(small_house, includes),
                   "no file of attic includes anything of hall");
}

BOOST_AUTO_TEST_CASE(a_room_without_files_is_a_fault) {
  std::vector<Room> rooms = small_house;
  rooms.push_back({.folder = "balcony", .sees = {}});
  expect_one_fault(faults(rooms, as_listed), "no file of balcony includes anything");
}

BOOST_AUTO_TEST_SUITE_END()
