#include "tests/house/arrows.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tests/own_folder.hpp"

BOOST_AUTO_TEST_SUITE(arrows_test)

namespace {

namespace fs = std::filesystem;
using springcheck::OwnFolder;

const std::vector<Room> small_house = read_rooms(R"(
# a cellar, and what stands on it
cellar:
hall: cellar
attic: cellar hall
tests/**: cellar hall
)");

const Sources as_listed{{"cellar/wine.cpp", "hall/door.cpp", "attic/box.cpp",
                         "tests/hall/door_test.cpp", "tests/wine_test.cpp"},
                        {{"cellar/wine.cpp", 1, "cellar/wine.hpp"},
                         {"hall/door.cpp", 1, "cellar/wine.hpp"},
                         {"attic/box.cpp", 1, "cellar/wine.hpp"},
                         {"attic/box.cpp", 2, "hall/door.hpp"},
                         {"tests/hall/door_test.cpp", 1, "hall/door.hpp"},
                         {"tests/hall/door_test.cpp", 2, "tests/bell.hpp"},
                         {"tests/wine_test.cpp", 1, "cellar/wine.hpp"}}};

std::vector<std::string> faults_with(const Include& further) {
  Sources sources = as_listed;
  sources.includes.push_back(further);
  return faults(small_house, sources);
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
  const std::vector<Room> rooms = read_rooms(text.str());
  const Sources sources = sources_below(".", rooms);
  BOOST_TEST(sources.includes.size() > 1000U);  // they were found
  for (const std::string& fault : faults(rooms, sources)) BOOST_ERROR(fault);
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
  Sources sources = as_listed;
  sources.files.emplace_back("garden/tree.cpp");
  expect_one_fault(faults(small_house, sources),
                   "garden/tree.cpp: the list has no line for garden");
}

// Where every room sees only those above it, no circle is left.
BOOST_AUTO_TEST_CASE(a_circle_of_folders_is_a_fault_though_it_is_listed) {
  std::vector<Room> rooms = small_house;
  rooms.front().sees = {"hall"};
  Sources sources = as_listed;
  sources.includes.push_back({"cellar/wine.cpp", 2, "hall/door.hpp"});
  expect_one_fault(faults(rooms, sources),
                   "cellar sees hall, which does not stand above it");
}

BOOST_AUTO_TEST_CASE(all_that_a_pattern_names_must_stand_above) {
  std::vector<Room> rooms = read_rooms("cellar:\nhall: cellar/**\ncellar/shelf: hall\n");
  const Sources sources{{"cellar/wine.cpp", "hall/door.cpp", "cellar/shelf/jam.cpp"},
                        {{"hall/door.cpp", 1, "cellar/wine.hpp"},
                         {"cellar/shelf/jam.cpp", 1, "hall/door.hpp"}}};
  expect_one_fault(faults(rooms, sources),
                   "hall sees cellar/**, which does not stand above it");
}

BOOST_AUTO_TEST_CASE(an_entry_that_nobody_uses_is_a_fault) {
  Sources sources = as_listed;
  sources.includes.erase(sources.includes.begin() + 3);
  expect_one_fault(faults(small_house, sources),
                   "no file of attic includes anything of hall");
}

BOOST_AUTO_TEST_CASE(a_room_without_files_is_a_fault) {
  std::vector<Room> rooms = small_house;
  rooms.push_back({.folder = "balcony", .sees = {}});
  expect_one_fault(faults(rooms, as_listed), "there is no file in balcony");
}

BOOST_AUTO_TEST_CASE(a_list_that_cannot_be_read_names_the_line) {
  const auto message_of = [](const std::string& list) {
    try {
      read_rooms(list);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  BOOST_TEST(message_of("cellar:\nhall cellar\n") ==
             "docs/rooms.txt:2: expected FOLDER: FOLDER..., got 'hall cellar'");
  BOOST_TEST(message_of("cellar:\n\ncellar:\n") ==
             "docs/rooms.txt:3: expected each room once, got 'cellar'");
  BOOST_TEST(message_of("cellar:\nhall: cellar cellar\n") ==
             "docs/rooms.txt:2: expected each folder once, got 'cellar'");
}

// An include is found however it is written: in brackets, by way of another folder, by a
// macro.
BOOST_AUTO_TEST_CASE(every_include_of_ours_is_found) {
  const OwnFolder own;
  const fs::path& root = own.path;
  for (const char* folder : {"cellar", "hall", "mine"})
    fs::create_directories(root / folder);
  std::ofstream(root / "mine" / "CMakeCache.txt") << "built here\n";
  std::ofstream(root / "mine" / "made.cpp") << "#include \"cellar/wine.hpp\"\n";
  std::ofstream(root / "cellar" / "wine.inl") << "#include <hall/door.hpp>\n"
                                                 "#include <vector>\n"
                                                 "#include <Eigen/Core>\n"
                                                 "#include \"cellar/../hall/key.hpp\"\n"
                                                 "#  include DOOR\n";
  const Sources sources = sources_below(root, small_house);
  BOOST_TEST(sources.files == std::vector<std::string>{"cellar/wine.inl"});
  std::vector<std::string> found;
  for (const Include& include : sources.includes)
    found.push_back(std::to_string(include.line) + " " + include.included);
  const std::vector<std::string> expected{"1 hall/door.hpp", "4 hall/key.hpp", "5 DOOR"};
  BOOST_TEST(found == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
