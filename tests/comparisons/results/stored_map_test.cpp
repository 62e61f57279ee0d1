#include "comparisons/results/stored_map.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/stability/atlas.hpp"
#include "comparisons/stability/atlas_json.hpp"
#include "comparisons/store/hdf5.hpp"
#include "comparisons/store/open_result_file.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(stored_map_test)

namespace {

AtlasPlan plan_of(const std::vector<std::string>& over,
                  const std::vector<std::pair<std::string, std::string>>& options) {
  AtlasPlan plan{.scene = "compression", .options = {}, .axes = {}};
  for (const std::string& axis : over) plan.axes.push_back(axis_named("--over", axis));
  for (const auto& [key, value] : options)
    plan.options.push_back({key, Given::from_text("--" + key, value)});
  return plan;
}

Atlas atlas_in(const std::filesystem::path& file, const AtlasPlan& plan) {
  CaseRunner runner(file, 2);
  return make_atlas(plan, runner);
}

StoredMap planned() {
  return {.scene = "compression",
          .axes = {"deformation", "nu"},
          .points = {{.method = "mss-cf", .values = {"2%", "0.1"}, .key = "a"},
                     {.method = "mss-cf", .values = {"4%", "0.1"}, .key = "b"}},
          .limits = {},
          .revision = build_info::revision};
}

StoredMap completed() {
  StoredMap map = planned();
  map.state = MapState::complete;
  map.limits.push_back({.method = "mss-cf",
                        .other = "0.1",
                        .low = 2.5,
                        .high = std::nullopt,
                        .failure = "none",
                        .key = std::nullopt});
  return map;
}

}  // namespace

// How cases fail is said again of the stored ones, and is what the atlas said.
BOOST_AUTO_TEST_CASE(a_map_is_read_as_it_was_made) {
  const OwnFolder folder;
  const auto file = folder.path / "atlas.h5";
  const Atlas atlas =
      atlas_in(file, plan_of({"deformation=2%:30%:3", "nu=0,0.25"},
                             {{"cells", "3,3,3"}, {"method", "mss-nfd,mss-baudet"}}));
  const auto json = atlas_json(file, Revisions::own);
  BOOST_TEST_REQUIRE(json["maps"].size() == 1U);
  const auto& map = json["maps"][0];
  BOOST_TEST(map["axes"][0]["numbers"].dump() == "[2.0,16.0,30.0]");
  BOOST_TEST(map["axes"][0]["unit"] == "%");
  BOOST_TEST(map["axes"][1]["values"].dump() == R"(["0","0.25"])");
  BOOST_TEST_REQUIRE(map["points"].size() == atlas.points.size());
  std::size_t failed = 0;
  for (std::size_t i = 0; i < atlas.points.size(); ++i) {
    const auto& point = map["points"][i];
    BOOST_TEST(point["method"] == atlas.points[i].method);
    BOOST_TEST((point["values"] == atlas.points[i].values));
    BOOST_TEST(point["case"] == atlas.points[i].result.key);
    BOOST_TEST(point["failure"] == name_of(atlas.points[i].failure));
    failed += atlas.points[i].failure != Failure::none;
  }
  BOOST_TEST(failed > 0U);
  BOOST_TEST_REQUIRE(map["limits"].size() == atlas.limits.size());
  for (std::size_t i = 0; i < atlas.limits.size(); ++i) {
    BOOST_TEST(map["limits"][i]["low"].is_null() == !atlas.limits[i].low.has_value());
    if (atlas.limits[i].low)
      BOOST_TEST(map["limits"][i]["low"].get<double>() == *atlas.limits[i].low);
  }
}

BOOST_AUTO_TEST_CASE(locking_is_judged_by_the_stored_control) {
  const OwnFolder folder;
  const auto file = folder.path / "atlas.h5";
  AtlasPlan plan = plan_of({"nu=0.25,0.499"}, {{"cells", "3,3,3"},
                                               {"deformation", "1%"},
                                               {"element", "q1"},
                                               {"method", "fem-stvk"}});
  plan.judges_locking = true;
  atlas_in(file, plan);
  const auto points = atlas_json(file, Revisions::own)["maps"][0]["points"];
  BOOST_TEST(points[0]["failure"] == "none");
  BOOST_TEST(points[1]["failure"] == "locking");
}

// What is planned stands in the file before it is computed, and never replaces what is.
BOOST_AUTO_TEST_CASE(a_planned_map_waits_for_its_cases) {
  const OwnFolder folder;
  const auto file = folder.path / "atlas.h5";
  ResultFile(file).put_map(planned());
  auto map = atlas_json(file, Revisions::own)["maps"][0];
  BOOST_TEST(map["points"].size() == 2U);
  BOOST_TEST(map["points"][0]["failure"].is_null());
  BOOST_TEST(map["limits"].empty());
  ResultFile(file).put_map(completed());
  ResultFile(file).put_map(planned());
  BOOST_TEST_REQUIRE(atlas_json(file, Revisions::own)["maps"].size() == 1U);
  map = atlas_json(file, Revisions::own)["maps"][0];
  BOOST_TEST_REQUIRE(map["limits"].size() == 1U);
  BOOST_TEST(map["limits"][0]["low"] == 2.5);
  BOOST_TEST(map["limits"][0]["high"].is_null());
}

BOOST_AUTO_TEST_CASE(maps_are_merged) {
  const OwnFolder folder;
  const auto whole = folder.path / "whole.h5", part = folder.path / "part.h5",
             none = folder.path / "none.h5";
  ResultFile(whole).put_map(completed());
  ResultFile(part).put_map(planned());
  for (const auto& from : {part, whole, part}) ResultFile(none).absorb(from);
  BOOST_TEST_REQUIRE(read_maps(none, Revisions::own).size() == 1U);
  BOOST_TEST(read_maps(none, Revisions::own)[0].limits.size() == 1U);
}

// Neither limits nor points of others are shown as this program's, and merging keeps
// both.
BOOST_AUTO_TEST_CASE(maps_are_told_apart_by_revision) {
  const OwnFolder folder;
  const auto ours = folder.path / "ours.h5", theirs = folder.path / "theirs.h5";
  StoredMap older = completed(), mixed = completed();
  older.revision = "0123456789ab";
  older.limits[0].low = 7;
  mixed.other_revisions = "0123456789ab";
  mixed.limits[0].low = 8;
  mixed.points[0].key = "of theirs";
  ResultFile(theirs).put_map(older);
  ResultFile(theirs).put_map(mixed);
  BOOST_TEST(read_maps(theirs, Revisions::own).empty());
  BOOST_TEST(atlas_json(theirs, Revisions::own)["maps"].empty());
  const auto taken = atlas_json(theirs, Revisions::all)["maps"];
  BOOST_TEST_REQUIRE(taken.size() == 1U);  // of one question
  BOOST_TEST(taken[0]["other_revisions"] == "0123456789ab");

  ResultFile(ours).absorb(theirs);
  ResultFile(ours).put_map(completed());
  ResultFile(ours).absorb(theirs);
  for (const Revisions revisions : {Revisions::own, Revisions::all}) {
    const auto maps = atlas_json(ours, revisions)["maps"];
    BOOST_TEST_REQUIRE(maps.size() == 1U);  // others only where there are none of its own
    BOOST_TEST(maps[0]["other_revisions"] == "");
    BOOST_TEST(maps[0]["limits"][0]["low"] == 2.5);
  }
}

// A map that was begun stands until one of the same points is complete, whatever cases it
// was to be made of, and hides no complete one of others.
BOOST_AUTO_TEST_CASE(a_planned_map_hides_nothing) {
  const OwnFolder folder;
  const auto file = folder.path / "atlas.h5";
  StoredMap older = completed(), begun = planned();
  older.revision = "0123456789ab";
  begun.points[0].key = "of theirs";
  begun.other_revisions = "0123456789ab";
  ResultFile(file).put_map(older);
  ResultFile(file).put_map(planned());
  ResultFile(file).put_map(begun);
  BOOST_TEST(read_maps(file, Revisions::own).size() == 1U);  // planned()
  const auto all = read_maps(file, Revisions::all);
  BOOST_TEST_REQUIRE(all.size() == 1U);
  BOOST_TEST(all[0].revision == "0123456789ab");
  ResultFile(file).put_map(completed());
  BOOST_TEST_REQUIRE(read_maps(file, Revisions::all).size() == 1U);
  BOOST_TEST(revisions_of(read_maps(file, Revisions::all)[0]) == "");
  reading(file, [](hid_t root) {
    BOOST_TEST(hdf5::links(hdf5::open_group(root, "maps")).size() == 2U);
    return 0;
  });
}

// Texts that no JSON can hold, or none: of the file, told with its name.
BOOST_AUTO_TEST_CASE(maps_without_sound_texts_are_refused) {
  const OwnFolder folder;
  const auto file = folder.path / "atlas.h5";
  for (const char* scene : {"", "\xff"}) {
    {
      ResultFile(file).put_map(completed());
      const hdf5::Handle root(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose,
                              "atlas");
      const auto map =
          hdf5::open_group(hdf5::open_group(root, "maps"), identity_of(completed()));
      H5Adelete(map, "scene");
      hdf5::write_attribute(map, "scene", std::string(scene));
    }
    BOOST_CHECK_EXCEPTION(
        read_maps(file, Revisions::own), InputError, [&](const InputError& error) {
          return std::string(error.what()).find("scene") != std::string::npos;
        });
  }
}

BOOST_AUTO_TEST_SUITE_END()
