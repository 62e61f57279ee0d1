#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>

#include "comparisons/results/kept_results.hpp"
#include "comparisons/results/result_file.hpp"
#include "comparisons/results/stored_mesh.hpp"
#include "comparisons/store/hdf5.hpp"
#include "comparisons/store/overlay_file.hpp"
#include "meshing/generators/generate_block.hpp"
#include "meshing/input_error.hpp"
#include "tests/comparisons/own_folder.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(result_file_test)

namespace {

const std::vector<std::string> small{"cells=4,4,4", "method=mss-cf,fem-hooke"};

std::vector<CaseResult> study(const std::vector<Request>& requests, MeshStore& meshes) {
  return run_study(requests, meshes, 1, [](std::size_t, std::size_t) {});
}

}  // namespace

// With vectors and matrices among the measures, and iterations where there are any.
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
  // Of two cases mesh, points and four fields; of one the springs' strain.
  BOOST_TEST(items == 2 * 6 + 1);
}

BOOST_AUTO_TEST_CASE(foreign_and_broken_files_are_refused_by_name) {
  const OwnFolder own;
  const fs::path& folder = own.path;
  const auto message = [](const std::filesystem::path& file) {
    try {
      read_results(file, Revisions::own);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  BOOST_TEST(message(folder / "none.h5").find("no such file") != std::string::npos);
  std::ofstream(folder / "text.h5") << "not HDF5";
  BOOST_TEST(message(folder / "text.h5").find("text.h5") != std::string::npos);
  const auto make = [&](const char* name, std::optional<long long> layout) {
    std::ofstream(folder / name).flush();
    OverlayFile overlay(folder / name);
    {
      const hdf5::Handle root(overlay.create(), H5Fclose, name);
      if (layout) hdf5::write_attribute(root, "layout", *layout);
    }
    write_pages(folder / name, overlay.writes());
  };
  make("foreign.h5", std::nullopt);
  BOOST_TEST(message(folder / "foreign.h5").find("layout") != std::string::npos);
  make("newer.h5", 3);
  BOOST_TEST(message(folder / "newer.h5") ==
             (folder / "newer.h5").string() + ": layout: expected 2, got 3");
  make("cut.h5", 2);
  BOOST_TEST(message(folder / "cut.h5").find("cases") != std::string::npos);
}

// Figures that no program of ours writes are not taken into tables.
BOOST_AUTO_TEST_CASE(damaged_figures_are_refused_with_their_case) {
  const OwnFolder own;
  MeshStore meshes;
  const std::vector<CaseResult> good =
      study({requests(run_of("compression", small)).back()}, meshes);
  const auto message = [&](const auto& damage) {
    std::vector<CaseResult> bad = good;
    damage(bad.front());
    fs::remove(own.path / "bad.h5");
    write_results(own.path / "bad.h5", bad, meshes);
    try {
      read_results(own.path / "bad.h5", Revisions::own);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  BOOST_TEST(message([](CaseResult&) {}) == "accepted");
  const std::string of_case = " of case " + good.front().key + ": expected ";
  const auto ends_with = [&](const std::string& text, const std::string& end) {
    BOOST_TEST(text.ends_with(end), text);
  };
  ends_with(message([](CaseResult& r) { r.measures.plate_force = INFINITY; }),
            "plate_force" + of_case + "finite numbers, got others");
  ends_with(message([](CaseResult& r) { r.measures.force->x() = std::nan(""); }),
            "force" + of_case + "finite numbers, got others");
  ends_with(message([](CaseResult& r) { r.measures.volume_error.reset(); }),
            "volume_error" + of_case + "a number, got none with status ok");
  ends_with(message([](CaseResult& r) { r.status = Status::not_converged; }),
            "volume_error" + of_case + "none, got one with status not_converged");
  ends_with(message([](CaseResult& r) { r.measures.wall_s = std::nan(""); }),
            "wall_s" + of_case + "a number, got none");
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

  // Without fields none are left that belong to older figures.
  ResultFile(file).put({first.data(), 1}, false, meshes);
  CaseResult bare = with_stored(first[0].request, stored.at(first[0].key));
  read_fields(file, meshes.mesh(first[0].request.settings.body), bare);
  BOOST_TEST(bare.solution.displacements.empty());
}

// What stands in the way is said before anything is computed, and stays as it is.
BOOST_AUTO_TEST_CASE(files_that_are_not_ours_are_never_written) {
  const OwnFolder own;
  const fs::path file = own.path / "notes.h5";
  std::ofstream(file) << "my notes";
  BOOST_CHECK_THROW(check_results_writable(file), InputError);
  std::string content;
  std::getline(std::ifstream(file), content);
  BOOST_TEST(content == "my notes");
  const ResultFile first(own.path / "a.h5");
  BOOST_CHECK_THROW(ResultFile(own.path / "a.h5"), InputError);
  BOOST_TEST(!fs::exists(own.path / "a.h5"));  // until there are results
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

// As two programs write a file: the second adds to it.
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

// "/" leads into a group, and from the root: such a name lost the result, or put a table
// where the file has something else.
BOOST_AUTO_TEST_CASE(names_of_regions_are_no_paths_in_the_file) {
  const OwnFolder own;
  const auto file = own.path / "a.h5";
  const Mesh block = generate_block({.size = {1, 1, 1}, .cells = {2, 2, 2}});
  std::map<std::string, std::vector<FaceNodes>> regions;
  const std::vector<std::string> names{"%2F", ".", "..", "/provenance/evil", "foot/left"};
  for (const std::string& name : names) regions[name] = block.region("top").faces;
  const Mesh mesh("named", block.nodes(), block.cells(), regions);
  hid_t created = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hdf5::Handle root(created, H5Fclose, "a");
  const auto meshes = hdf5::create_group(root, "meshes");
  hdf5::create_group(root, "provenance");
  write_stored_mesh(meshes, mesh);
  BOOST_TEST(hdf5::links(hdf5::open_group(root, "provenance")).empty());
  const auto stored =
      hdf5::open_group(hdf5::open_group(meshes, mesh.sha256()), "regions");
  const std::vector<std::string> links{"%252F", "%2E", "%2Fprovenance%2Fevil", "..",
                                       "foot%2Fleft"};
  BOOST_TEST(hdf5::links(stored) == links, boost::test_tools::per_element());
}

// A key of another's making must not lead elsewhere in the file, nor a session.
BOOST_AUTO_TEST_CASE(keys_that_are_paths_are_refused) {
  const OwnFolder own;
  const auto file = own.path / "a.h5";
  MeshStore meshes;
  const auto results = study(requests(run_of("compression", small)), meshes);
  write_results(file, results, meshes);
  const auto expect_refused = [&](const char* column, const Row::mapped_type& value) {
    const auto bad = own.path / "bad.h5";
    fs::copy_file(file, bad, fs::copy_options::overwrite_existing);
    {
      const hdf5::Handle root(H5Fopen(bad.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose,
                              "bad");
      const auto cases = hdf5::open_group(root, "cases");
      Row row = row_at(read_columns(cases), 0);
      row[column] = value;
      replace_row(cases, 0, row);
    }
    BOOST_CHECK_THROW(all_cases(bad), InputError);
    BOOST_CHECK_THROW(ResultFile{bad}, InputError);
    BOOST_CHECK_THROW(ResultFile(own.path / "c.h5").absorb(bad), InputError);
  };
  for (const char* column : {"key", "mesh"})
    for (const char* name : {"/evil", "a/b", "."})
      expect_refused(column, std::string(name));
  for (const double session : {7., 0.5, -1.})
    expect_refused("provenance", std::vector{session});
}

BOOST_AUTO_TEST_SUITE_END()
