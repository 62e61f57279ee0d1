#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>

#include "comparisons/results/result_file.hpp"
#include "comparisons/results/stored_mesh.hpp"
#include "comparisons/store/hdf5.hpp"
#include "comparisons/store/overlay_file.hpp"
#include "comparisons/store/stored_columns.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tests/comparisons/results/small_study.hpp"
#include "tests/comparisons/settings.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(refused_files_test)

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
