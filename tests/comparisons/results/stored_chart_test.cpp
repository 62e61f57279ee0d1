#include "comparisons/results/stored_chart.hpp"

#include <boost/test/unit_test.hpp>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/results/result_file.hpp"
#include "comparisons/store/hdf5.hpp"
#include "comparisons/store/stored_columns.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/comparisons/chart/example_chart.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(stored_chart_test)

namespace {

StoredChart with_points(std::initializer_list<std::pair<const char*, int>> points) {
  ExampleChart example;
  for (const auto& [model, across] : points) example.add(model, across, 1, 10, 0.002);
  return example.chart;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_chart_is_of_one_machine_and_one_truth) {
  const StoredChart chart = with_points({{"mss-cf", 4}});
  StoredChart other = with_points({{"mss-cf", 8}, {"fem-stvk:q2", 4}});
  BOOST_TEST(identity_of(other) == identity_of(chart));
  other.machine = "another";
  BOOST_TEST(identity_of(other) != identity_of(chart));
  other = chart;
  other.truths[0].grids.keys[2] = "finer";
  BOOST_TEST(identity_of(other) != identity_of(chart));
  other = chart;
  other.truths.push_back({.law = "fem-hooke"});
  BOOST_TEST(identity_of(other) == identity_of(chart));
}

BOOST_AUTO_TEST_CASE(files_of_one_chart_give_all_its_points) {
  const OwnFolder own;
  StoredChart first = with_points({{"mss-cf", 4}, {"mss-cf", 8}});
  first.points[1].timing.reset();
  first.points[1].left_out = "over budget";
  StoredChart second = with_points({{"mss-cf", 8}, {"fem-stvk:q2", 4}, {"mss-cf", 4}});
  second.points[2].timing->median = 7;  // measured again: the first one's stays
  StoredChart elsewhere = second;
  elsewhere.machine = "another";
  first.truths[0].grids.formal_order = 1.7;
  first.truths[0].check = StoredChart::Grids{
      .cell_sizes = {3, 2, 1}, .keys = {"a", "b", "c"}, .formal_order = 1.1};
  first.truths[0].places_apart = 0.02;
  ResultFile(own.path / "first.h5").put_chart(first);
  {
    ResultFile file(own.path / "second.h5");
    file.put_chart(second);
    file.put_chart(elsewhere);
  }
  ResultFile(own.path / "first.h5").absorb(own.path / "second.h5");

  const std::vector<StoredChart> charts =
      read_charts(own.path / "first.h5", Revisions::all);
  BOOST_TEST_REQUIRE(charts.size() == 2U);  // of each machine
  const bool is_second = charts[0].machine == "another";
  const StoredChart& both = charts[is_second ? 1 : 0];
  const StoredChart::Truth& truth = both.truths.at(0);
  BOOST_TEST(truth.grids.formal_order == 1.7);
  BOOST_TEST_REQUIRE(truth.check.has_value());
  BOOST_TEST(truth.check->cell_sizes == (std::array<double, 3>{3, 2, 1}));
  BOOST_TEST(truth.check->keys == (std::array<std::string, 3>{"a", "b", "c"}));
  BOOST_TEST(truth.check->formal_order == 1.1);
  BOOST_TEST(truth.places_apart.value() == 0.02);
  BOOST_TEST((truth.has("t1") && truth.has("c") && !truth.has("mss-cf4")));
  // Files that know no check have none.
  BOOST_TEST(!charts[is_second ? 0 : 1].truths.at(0).check.has_value());
  BOOST_TEST_REQUIRE(both.points.size() == 3U);
  BOOST_TEST(both.points[0].key == "mss-cf4");
  BOOST_TEST(both.points[0].timing->median == 1);
  BOOST_TEST(both.points[1].key == "mss-cf8");
  BOOST_TEST(both.points[1].timing.has_value());
  BOOST_TEST(!both.points[1].left_out.has_value());
  BOOST_TEST(both.points[2].key == "fem-stvk:q24");
  BOOST_TEST(both.comparisons.size() == 3U);
}

BOOST_AUTO_TEST_CASE(why_a_point_was_left_out_is_kept) {
  const OwnFolder own;
  StoredChart chart = with_points({{"mss-cf", 4}, {"mss-cf", 8}});
  chart.points[1].timing.reset();
  chart.points[1].left_out = "over memory";
  ResultFile(own.path / "one.h5").put_chart(chart);
  const StoredChart read = read_charts(own.path / "one.h5", Revisions::all).at(0);
  BOOST_TEST(!read.points[0].left_out.has_value());
  BOOST_TEST(read.points[1].left_out.value() == "over memory");
  BOOST_TEST(!read.points[1].timing.has_value());
}

BOOST_AUTO_TEST_CASE(charts_of_other_revisions_are_taken_when_asked_for) {
  const OwnFolder own;
  const auto file = own.path / "one.h5";
  StoredChart chart = with_points({{"mss-cf", 4}});
  chart.revision = "0123456789ab";
  ResultFile(file).put_chart(chart);
  BOOST_TEST(read_charts(file, Revisions::own).empty());
  BOOST_TEST(read_charts(file, Revisions::all).size() == 1U);
  chart.revision = build_info::revision;
  ResultFile(file).put_chart(chart);
  BOOST_TEST(read_charts(file, Revisions::own).size() == 1U);
}

// HDF5 1.10 overruns a null pointer where it copies texts of more than 8 attributes; and
// a chart that cannot be read must not get into another file.
BOOST_AUTO_TEST_CASE(merging_reads_what_it_takes) {
  const OwnFolder own;
  const auto good = own.path / "good.h5", bad = own.path / "bad.h5";
  const StoredChart chart = with_points({{"mss-cf", 4}});
  for (const auto& file : {good, bad}) {
    ResultFile(file).put_chart(chart);
    const hdf5::Handle root(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose,
                            "chart");
    const auto charts = hdf5::open_group(root, "charts");
    const auto group = hdf5::open_group(charts, hdf5::links(charts).at(0));
    for (const char* name : {"further", "and more"})
      hdf5::write_attribute(group, name, std::string("text"));
    if (file == bad) H5Adelete(group, "law");
  }
  ResultFile(own.path / "all.h5").absorb(good);
  BOOST_TEST(read_charts(own.path / "all.h5", Revisions::all).size() == 1U);
  BOOST_CHECK_THROW(ResultFile(own.path / "none.h5").absorb(bad), InputError);
  BOOST_TEST(read_charts(own.path / "none.h5", Revisions::all).empty());
}

BOOST_AUTO_TEST_CASE(times_that_are_none_are_refused) {
  const OwnFolder own;
  const auto file = own.path / "one.h5";
  StoredChart chart = with_points({{"mss-cf", 4}});
  chart.points[0].times = {{0.1, 0.125}, {0.2}};
  ResultFile(file).put_chart(chart);
  BOOST_TEST(
      (read_charts(file, Revisions::all).at(0).points[0].times == chart.points[0].times));
  for (const char* times : {"0.1;;0.2", "0.1,", "0.1;", ";0.1", ",", "0.1 ", "a", "nan",
                            "1e999", "0.1:0.2", "0", "-1,2", "1e-320"}) {
    {
      const hdf5::Handle root(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose,
                              "chart");
      const auto charts = hdf5::open_group(root, "charts");
      const auto points =
          hdf5::open_group(hdf5::open_group(charts, hdf5::links(charts).at(0)), "points");
      Row row = row_at(read_columns(points), 0);
      row["times"] = std::string(times);
      replace_row(points, 0, row);
    }
    BOOST_CHECK_EXCEPTION(
        read_charts(file, Revisions::all), InputError, [&](const InputError& error) {
          return std::string(error.what()).find("'" + std::string(times) + "'") !=
                 std::string::npos;
        });
  }
}

BOOST_AUTO_TEST_SUITE_END()
