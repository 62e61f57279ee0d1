#include "comparisons/settings/cut_keys.hpp"

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>

#include "comparisons/settings/scene_file.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;
namespace data = boost::unit_test::data;

BOOST_AUTO_TEST_SUITE(cut_keys_test)

namespace {

std::vector<WantedCut> from_text(const std::string& text) {
  return cuts_of(Given("--cut", Given::Scalar(text)));
}

const std::string scene =
    "test = \"tension\"\nsize = [1, 1, 1]\ncells = [2, 2, 2]\nyoung = 1e4\n"
    "nu = 0.25\ndensity = 1000\ndeformation = 0.05\nmethod = \"mss-cf\"\n";

std::vector<WantedCut> from_scene(const std::string& lines) {
  const OwnFolder own;
  const std::filesystem::path file = own / "scene.toml";
  std::ofstream(file) << scene << lines;
  try {
    const SceneFile read = read_scene(file.string());
    return make_run_settings(read.name, "scene.toml", read.settings).common.body.cuts;
  } catch (const InputError& error) {
    const std::string message = error.what();
    throw InputError("scene.toml" + message.substr(file.string().size()));
  }
}

template <class Read>
std::string message_of(const Read& read, const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

struct Bad {
  std::string text, message;
};
std::ostream& operator<<(std::ostream& out, const Bad& bad) {
  return out << bad.text;
}

const std::vector<Bad> bad_texts{
    {"plane=0,0,1,0",
     "--cut: expected split or remove, with which a cut begins, got 'plane=0'"},
    {"splitt,plane=0,0,1,0",
     "--cut: unknown kind of cut 'splitt', did you mean 'split'? expected one of split, "
     "remove"},
    {"split", "--cut: expected one of plane, box, cylinder, polyline, got none"},
    {"split,plan=0,0,1,0",
     "--cut: plan: unknown key of a cut 'plan', did you mean 'plane'? expected one of "
     "name, kind, plane, box, cylinder, polyline, depth, within"},
    {"split,plane=0,0,1", "--cut: plane: expected 4 finite numbers, got [0, 0, 1]"},
    {"split,plane=0,0,0,1",
     "--cut: plane: expected a normal other than zero, and an offset, got [0, 0, 0, 1]"},
    {"split,plane=0,0,1,0,plane=0,0,1,1",
     "--cut: plane: expected plane once, got [0, 0, 1, 1]"},
    {"split,plane=0,0,1,0,box=0,0,0,1,1,1",
     "--cut: box: expected no box beside plane, got [0, 0, 0, 1, 1, 1]"},
    {"split,plane=0,0,1,0,within=0,0,0,1,0,1",
     "--cut: within: expected its lower corner x,y,z, and above it its upper one, got "
     "[0, 0, 0, 1, 0, 1]"},
    {"split,cylinder=0,0,0,0,0,1,0",
     "--cut: cylinder: expected the ends x,y,z of its axis, apart, and a radius above 0, "
     "got [0, 0, 0, 0, 0, 1, 0]"},
    {"split,polyline=0,0,0,1,0,0",
     "--cut: polyline: expected a depth beside it, got none"},
    {"split,polyline=0,0,0,1,0,depth=0,0,1",
     "--cut: polyline: expected x,y,z of each of two or more points, got [0, 0, 0, 1, "
     "0]"},
    {"split,polyline=0,0,0,0,0,0,depth=0,0,1",
     "--cut: polyline: expected points that are each apart from the next, got "
     "[0, 0, 0, 0, 0, 0]"},
    {"split,polyline=0,0,0,0,0,1,depth=0,0,1",
     "--cut: depth: expected a vector other than zero, and across the polyline, got "
     "[0, 0, 1]"},
    {"split,plane=0,0,1,0,depth=0,0,1",
     "--cut: depth: expected no depth without a polyline, got [0, 0, 1]"},
    {"remove,plane=0,0,1,0",
     "--cut: expected a box or a cylinder, of which the inside is removed, got a surface "
     "that encloses nothing"},
    {"split,name=a b,plane=0,0,1,0",
     "--cut: name: expected a name without spaces, commas, quotes, slashes and '=', got "
     "'a b'"},
    {"split,name=a,plane=0,0,1,0,split,name=a,plane=0,0,1,1",
     "--cut: expected a name of its own for each cut, got a second one of 'a'"},
    {"split,plane=0,0,1,3s",
     "--cut: plane: expected a finite number, plain or in m, cm, mm, um, as in '5um', "
     "got "
     "[0, 0, 1, '3s']"}};

const std::vector<Bad> bad_lines{
    {"[[cut]]\nplane = [0, 0, 1, 0.5]\n",
     "scene.toml:9:1: cut: expected a kind: split or remove, got none"},
    {"[[cut]]\nkind = \"spilt\"\nplane = [0, 0, 1, 0.5]\n",
     "scene.toml:10:1: kind: unknown value 'spilt', did you mean 'split'? expected one "
     "of "
     "split, remove"},
    {"[[cut]]\nkind = \"split\"\nplan = [0, 0, 1, 0.5]\n",
     "scene.toml:11:1: plan: unknown key of a cut 'plan', did you mean 'plane'? expected "
     "one of name, kind, plane, box, cylinder, polyline, depth, within"},
    {"[[cut]]\nkind = \"split\"\nplane = 3\n",
     "scene.toml:11:1: plane: expected 4 finite numbers, got 3"},
    {"[[cut]]\nkind = \"split\"\nplane = {x = 3}\n",
     "scene.toml:11:1: plane: expected 4 finite numbers, got a table"},
    {"cut = 3\n",
     "scene.toml:9:7: cut: unknown kind of cut '3', expected one of split, remove"}};

}  // namespace

BOOST_AUTO_TEST_CASE(tables_and_texts_are_the_same_cuts) {
  const auto tables = from_scene(R"(
[[cut]]
name = "slit"
kind = "split"
plane = [0, 0, 2, "5cm"]
within = [[0, 0, 0], ["25mm", 1, 1]]
[[cut]]
kind = "remove"
cylinder = [0, 0, 0, 0, 0, 1, 0.1]
[[cut]]
kind = "split"
polyline = [[0, 0, 1], [1, 0, 1], [1, 1, 1]]
depth = [0, 0, -0.5]
)");
  BOOST_TEST_REQUIRE(tables.size() == 3);
  BOOST_TEST(tables[0].name == "slit");
  BOOST_TEST((std::get<Plane>(tables[0].where.surface) ==
              Plane{.normal = {0, 0, 1}, .offset = 0.025}));
  BOOST_TEST((tables[0].where.within == Box{.low = {0, 0, 0}, .high = {0.025, 1, 1}}));
  BOOST_TEST(tables[1].name == "cut-2");
  BOOST_TEST((tables[1].kind == CutKind::remove));
  BOOST_TEST(std::get<Blade>(tables[2].where.surface).points.size() == 3);

  const std::string text = text_of(tables);
  BOOST_TEST(text ==
             "split,name=slit,plane=0,0,1,0.025,within=0,0,0,0.025,1,1,"
             "remove,name=cut-2,cylinder=0,0,0,0,0,1,0.1,"
             "split,name=cut-3,polyline=0,0,1,1,0,1,1,1,1,depth=0,0,-0.5");
  BOOST_TEST((from_text(text) == tables));
  BOOST_TEST((from_scene("cut = \"" + text + "\"\n") == tables));
  BOOST_TEST(
      (from_text("split, name = slit, plane = 0, 0, 2, 5cm, within = 0, 0, 0, 25mm, "
                 "1, 1")[0] == tables[0]));
}

// What cases tell of a cut is the same cut, digit by digit.
BOOST_AUTO_TEST_CASE(texts_of_cuts_stay_as_they_are) {
  for (const char* text : {"split,plane=1,2,3,0.04", "split,plane=1e200,0,0,2.5e198",
                           "split,plane=-0.3,1e-7,0.7,1"}) {
    const std::vector<WantedCut> cuts = from_text(text);
    BOOST_TEST((from_text(text_of(cuts)) == cuts));
    BOOST_TEST(text_of(from_text(text_of(cuts))) == text_of(cuts));
  }
  BOOST_TEST(std::get<Plane>(from_text("split,plane=1e200,0,0,2.5e198")[0].where.surface)
                     .offset == 0.025,
             boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(an_empty_text_is_no_cut) {
  BOOST_TEST(from_text("").empty());
  BOOST_TEST(from_scene("cut = []\n").empty());
  BOOST_TEST(text_of(std::vector<WantedCut>{}).empty());
}

BOOST_AUTO_TEST_CASE(cuts_differ_by_what_they_do_and_not_by_their_place) {
  const WantedCut cut = from_text("split,plane=0,0,1,0.5")[0];
  BOOST_TEST(
      (cut == from_scene("[[cut]]\nkind = \"split\"\nplane = [0, 0, 1, 0.5]\n")[0]));
  BOOST_TEST(!(cut == from_text("split,plane=0,0,1,0.6")[0]));
  BOOST_TEST(!(cut == from_text("split,plane=0,0,1,0.5,within=0,0,0,1,1,1")[0]));
  BOOST_TEST(!(cut == from_text("split,name=other,plane=0,0,1,0.5")[0]));
  const WantedCut box = from_text("split,box=0,0,0,1,1,1")[0];
  BOOST_TEST(!(box == from_text("remove,box=0,0,0,1,1,1")[0]));
}

BOOST_DATA_TEST_CASE(bad_texts_are_refused, data::make(bad_texts)) {
  BOOST_TEST(message_of(from_text, sample.text) == sample.message);
}

BOOST_DATA_TEST_CASE(bad_tables_are_refused_with_line_and_column, data::make(bad_lines)) {
  BOOST_TEST(message_of(from_scene, sample.text) == sample.message);
}

BOOST_AUTO_TEST_SUITE_END()
