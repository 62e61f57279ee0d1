#include "comparisons/results/result_file.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <span>
#include <sstream>
#include <tuple>

#include "comparisons/results/kept_results.hpp"
#include "comparisons/store/hdf5.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tests/comparisons/results/small_study.hpp"
#include "tests/comparisons/settings.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(result_file_test)

// There are vectors and matrices among the measures, and iterations where there are any.
BOOST_AUTO_TEST_CASE(a_result_file_gives_back_what_was_written) {
  const OwnFolder own;
  const auto file = own.path / "study.h5";
  MeshStore meshes;
  auto all = requests(run_of("compression", small));
  for (const char* scene : {"traction", "affine"})
    all.push_back(
        requests(run_of(scene, {"method=fem-stvk", "linear-solver=multigrid"})).front());
  const auto written = study(all, meshes);
  BOOST_TEST(!written[0].solution.linear_iterations.has_value());
  BOOST_TEST(written[2].solution.linear_iterations.value() > 0);
  BOOST_TEST(written[0].solution.factorisations.value() > 0);
  BOOST_TEST(!written[2].solution.factorisations.has_value());
  // What the springs' points are off the elements', and only springs are strained.
  const auto& [springs, elements] = std::tie(written[0], written[1]);
  BOOST_TEST(springs.solution.spring_strains.size() == 64U);
  BOOST_TEST(elements.solution.spring_strains.empty());
  BOOST_TEST(written[2].deviation.empty());  // its own reference
  BOOST_TEST_REQUIRE(springs.deviation.size() == 125U);
  double largest = 0;
  for (const Vector3& off : springs.deviation) largest = std::max(largest, off.norm());
  BOOST_TEST(largest == *springs.measures.max_deviation);
  write_results(file, written, meshes);
  const auto stored = read_results(file, Revisions::own);
  BOOST_TEST_REQUIRE(stored.size() == 4U);
  for (const CaseResult& result : written) {
    CaseResult read = with_stored(result.request, stored.at(result.key));
    const Mesh& mesh = meshes.mesh(result.request.settings.body);
    read_fields(file, mesh, read);
    BOOST_TEST((read.solution.displacements == result.solution.displacements));
    BOOST_TEST((read.solution.reactions == result.solution.reactions));
    const auto volumes = deformed_volumes(mesh, result.solution);
    for (std::size_t c = 0; c < volumes.size(); ++c)
      BOOST_TEST(read.solution.cell_volumes.at(c) == volumes[c],
                 boost::test_tools::tolerance(1e-14));
    BOOST_TEST((read.solution.spring_strains == result.solution.spring_strains));
    BOOST_TEST((read.deviation == result.deviation));
    const Mesh other = generate_block({.size = {1, 1, 1}, .cells = {2, 2, 2}});
    BOOST_CHECK_THROW(read_fields(file, other, read), InputError);
    BOOST_TEST((read.status == result.status));
    BOOST_TEST(read.solution.steps == result.solution.steps);
    BOOST_TEST((read.solution.linear_iterations == result.solution.linear_iterations));
    BOOST_TEST((read.solution.factorisations == result.solution.factorisations));
    std::vector<double> before, after;  // exact: binary numbers
    const auto collect = [](std::vector<double>& into) {
      return [&](const Measure&, const auto& value) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Measures::Value>)
          into.push_back(value.value_or(-1e300));
        else if (value)
          into.insert(into.end(), value->data(), value->data() + value->size());
      };
    };
    for_each_measure(result.measures, collect(before));
    for_each_measure(read.measures, collect(after));
    BOOST_TEST(before == after, boost::test_tools::per_element());
  }
  BOOST_TEST(!std::filesystem::exists(file.string() + ".part"));
  const auto root = hdf5::open_file(file);
  const auto meshes_group = hdf5::open_group(root, "meshes");
  BOOST_TEST(hdf5::links(meshes_group).size() == 1U);  // all the same, stored once
  auto xdmf = file;
  BOOST_TEST(std::filesystem::exists(xdmf.replace_extension(".xdmf")));
}

// The last state before a breakdown is no result: its fields have names of their own.
BOOST_AUTO_TEST_CASE(fields_without_an_equilibrium_are_partial) {
  const OwnFolder own;
  const auto file = own.path / "partial.h5";
  MeshStore meshes;
  const auto written = study(
      requests(run_of("tension", {"method=mss-cf", "nu=0", "deformation=0.3"})), meshes);
  BOOST_TEST_REQUIRE(!written.front().measures.volume_error.has_value());
  write_results(file, written, meshes);
  const auto root = hdf5::open_file(file);
  const auto fields = hdf5::open_group(root, "fields");
  const auto names = hdf5::links(hdf5::open_group(fields, written.front().key));
  const std::vector<std::string> expected{"partial_cell_volume_ratio",
                                          "partial_displacement", "partial_reaction",
                                          "partial_spring_strain"};
  BOOST_TEST(names == expected, boost::test_tools::per_element());
  CaseResult read = written.front();
  read.solution.spring_strains.clear();
  read_fields(file, meshes.mesh(read.request.settings.body), read);
  BOOST_TEST((read.solution.spring_strains == written.front().solution.spring_strains));
  BOOST_TEST(read.deviation.empty());
}

// What was computed with fields is not computed again for them, whether it has any or
// not.
BOOST_AUTO_TEST_CASE(a_file_holds_what_it_is_asked_for) {
  const OwnFolder own;
  const auto file = own.path / "bare.h5";
  MeshStore meshes;
  std::vector<Request> asked =
      requests(run_of("compression", {"cells=2,2,2", "method=mss-cf"}));
  asked.push_back(
      requests(run_of("tension", {"method=mss-cf", "nu=0", "deformation=0.3"})).front());
  const auto results = study(asked, meshes);
  ResultFile(file).put(results, false, meshes);
  const CaseResult refused = study(
      requests(run_of("compression", {"cells=2,2,12", "method=mss-cf"})), meshes)[0];
  BOOST_TEST_REQUIRE((refused.status == Status::refused));
  ResultFile(file).put({&refused, 1}, false, meshes);
  const StoredKeys bare = stored_keys(file);
  BOOST_TEST(holds(bare, refused.key, true));
  BOOST_TEST(holds(bare, results[0].key, false));
  BOOST_TEST(!holds(bare, results[0].key, true));
  BOOST_TEST(!holds(bare, results[1].key, true));
  BOOST_TEST(!holds(bare, "another", false));
  CaseResult broken = results[1];
  broken.solution.displacements.clear();
  write_results(file, std::array{results[0], broken}, meshes);
  BOOST_TEST(holds(stored_keys(file), results[0].key, true));
  BOOST_TEST(holds(stored_keys(file), broken.key, true));
  CaseResult read = broken;
  read_fields(file, meshes.mesh(read.request.settings.body), read);
  BOOST_TEST(read.solution.displacements.empty());
  const std::string xdmf = text_of(own.path / "bare.xdmf");
  BOOST_TEST(xdmf.find(results[0].key.substr(0, 8)) != std::string::npos);
  BOOST_TEST(xdmf.find(broken.key.substr(0, 8)) == std::string::npos);
}

// Each item names a dataset of the HDF5 file and its shape; topology is 8 wide, points 3.
BOOST_AUTO_TEST_CASE(xdmf_names_datasets_by_their_shapes) {
  const OwnFolder own;
  MeshStore meshes;
  write_results(own.path / "a&b.h5",
                study(requests(run_of("compression", small)), meshes), meshes);
  std::ostringstream text;
  text << std::ifstream(own.path / "a&b.xdmf").rdbuf();
  const std::string xdmf = text.str();
  const auto root = hdf5::open_file(own.path / "a&b.h5");
  const std::regex item("Dimensions=\"([0-9 ]+)\">a&amp;b.h5:([^<]+)<");
  int items = 0;
  for (std::sregex_iterator found(xdmf.begin(), xdmf.end(), item), end; found != end;
       ++found, ++items) {
    const hdf5::Handle dataset(H5Dopen2(root, (*found)[2].str().c_str(), H5P_DEFAULT),
                               H5Dclose, (*found)[2]);
    const hdf5::Handle space(H5Dget_space(dataset), H5Sclose, "shape");
    std::array<hsize_t, 2> shape{};
    const int rank = H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    const std::string dimensions =
        std::to_string(shape[0]) + (rank == 2 ? " " + std::to_string(shape[1]) : "");
    BOOST_TEST(dimensions == (*found)[1].str());
  }
  // Two cases have mesh, points and four fields; one has the springs' strain.
  BOOST_TEST(items == 2 * 6 + 1);
}

// The same case again replaces its row and its fields; others stay.
BOOST_AUTO_TEST_CASE(results_are_added_and_replaced_by_key) {
  const OwnFolder own;
  const fs::path file = own.path / "all.h5";
  MeshStore meshes;
  auto first = study(requests(run_of("compression", small)), meshes);
  write_results(file, first, meshes);
  auto second = first;
  second.resize(1);
  second[0].measures.plate_force = 7;
  second[0].solution.displacements[0] = Vector3(1, 2, 3);
  const auto other = study(requests(run_of("shearing", small)), meshes);
  second.insert(second.end(), other.begin(), other.end());
  second.push_back(other.front());  // twice at once
  write_results(file, second, meshes);
  const auto stored = read_results(file, Revisions::own);
  BOOST_TEST(stored.size() == 4U);
  BOOST_TEST(*stored.at(first[0].key).measures.plate_force == 7.);
  BOOST_TEST(*stored.at(first[1].key).measures.plate_force ==
             *first[1].measures.plate_force);
  CaseResult read = with_stored(first[0].request, stored.at(first[0].key));
  read_fields(file, meshes.mesh(first[0].request.settings.body), read);
  BOOST_TEST((read.solution.displacements[0] == Vector3(1, 2, 3)));
  BOOST_TEST(read_cases(file, Revisions::own).rows == 4U);
  BOOST_TEST(ResultFile(file).stored().statuses.size() == 4U);

  // Without fields, none that belong to older figures are left.
  ResultFile(file).put({first.data(), 1}, false, meshes);
  CaseResult bare = with_stored(first[0].request, stored.at(first[0].key));
  read_fields(file, meshes.mesh(first[0].request.settings.body), bare);
  BOOST_TEST(bare.solution.displacements.empty());
}

// "auto" is the lack of a time step, not a text among numbers.
BOOST_AUTO_TEST_CASE(time_steps_given_and_chosen_share_a_column) {
  const OwnFolder own;
  const fs::path file = own.path / "dt.h5";
  MeshStore meshes;
  for (const char* dt : {"dt=auto", "dt=0.001"})
    write_results(
        file,
        study(requests(run_of("shearing", {"cells=2,2,2", "method=mss-cf", "duration=.01",
                                           "solver=semi-implicit", dt})),
              meshes),
        meshes);
  const std::vector<double> steps =
      read_cases(file, Revisions::own).numbers.at("dt").values;
  BOOST_TEST(std::isnan(steps.at(0)));
  BOOST_TEST(steps.at(1) == 0.001);
}

// Two programs write a file: the second adds to it.
BOOST_AUTO_TEST_CASE(cases_taken_from_a_file_keep_who_computed_them) {
  const OwnFolder own;
  const auto theirs = own.path / "theirs.h5", ours = own.path / "ours.h5";
  MeshStore meshes;
  const auto results = study(requests(run_of("compression", small)), meshes);
  const auto session = [](const fs::path& file) {
    return read_cases(file, Revisions::own).numbers.at("provenance").values;
  };
  write_results(theirs, std::span(results).first(1), meshes);
  write_results(theirs, std::span(results).last(1), meshes);
  const std::vector<double> both{0, 1};
  BOOST_TEST(session(theirs) == both);
  const auto bytes = [](const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  };
  const std::string before = bytes(theirs);
  KeptResults(theirs, meshes).finish(results, std::array{theirs});
  BOOST_TEST((bytes(theirs) == before));
  KeptResults(ours, meshes).finish(results, std::array{theirs});
  BOOST_TEST(session(ours) == both);
  BOOST_TEST(ResultFile(ours).stored().with_fields.size() == 2U);
  // What was computed replaces what there is, once.
  KeptResults kept(ours, meshes);
  kept.keep(results[0]);
  kept.finish(results, std::array{theirs});
  BOOST_TEST(session(ours) == (std::vector<double>{2, 1}));
}

BOOST_AUTO_TEST_SUITE_END()
