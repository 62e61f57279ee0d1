#include <boost/test/unit_test.hpp>
#include <fstream>
#include <sstream>
#include <tuple>

#include "comparisons/results/known_results.hpp"
#include "comparisons/results/result_file.hpp"
#include "comparisons/store/hdf5.hpp"
#include "comparisons/store/stored_columns.hpp"
#include "meshing/basics/sha256.hpp"
#include "tests/comparisons/settings.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(revisions_test)

namespace {

/// The results of two methods, with their reference.
std::vector<CaseResult> two_results(MeshStore& meshes) {
  return run_study(
      requests(run_of("compression", {"cells=4,4,4", "method=mss-cf,fem-hooke"})), meshes,
      1, [](std::size_t, std::size_t) {});
}

const std::string other_revision(12, '0');

/// Makes the file one that a program of another revision has written, or one that is
/// older than revisions.
void make_foreign(const fs::path& file, const std::string& revision) {
  const hdf5::Handle root(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose,
                          "a");
  const auto sessions = hdf5::open_group(root, "provenance"),
             cases = hdf5::open_group(root, "cases");
  if (revision.empty()) {
    hdf5::remove_link(sessions, "revision");
    hdf5::remove_link(cases, "identity");
    return;
  }
  Row session = row_at(read_columns(sessions), 0);
  session["revision"] = revision;
  replace_row(sessions, 0, session);
  const Columns table = read_columns(cases);
  for (std::size_t i = 0; i < table.rows; ++i) {
    Row row = row_at(table, i);
    const std::string key = std::get<std::string>(row["key"]),
                      other =
                          sha256(std::get<std::string>(row["identity"]) + ' ' + revision);
    row["key"] = other;
    replace_row(cases, i, row);
    H5Lmove(root, ("fields/" + key).c_str(), root, ("fields/" + other).c_str(),
            H5P_DEFAULT, H5P_DEFAULT);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(figures_of_other_revisions_are_taken_when_asked_for) {
  const OwnFolder own;
  const auto file = own.path / "a.h5";
  MeshStore meshes;
  const auto results = two_results(meshes);
  write_results(file, results, meshes);
  BOOST_TEST(stored_keys(file).others.empty());
  BOOST_TEST(read_results(file, Revisions::own).at(results[0].key).revision.empty());
  make_foreign(file, other_revision);

  BOOST_TEST(read_cases(file, Revisions::own).rows == 0U);
  BOOST_TEST(read_results(file, Revisions::own).empty());
  BOOST_TEST(read_cases(file, Revisions::all).rows == 2U);
  const auto theirs = read_results(file, Revisions::all);
  BOOST_TEST_REQUIRE(theirs.size() == 2U);
  const StoredKeys stored = stored_keys(file);
  BOOST_TEST((stored.others == OtherRevisions{{other_revision, 2}}));
  for (const CaseResult& result : results) {
    const StoredCase& found = theirs.at(result.key);
    BOOST_TEST(found.revision == other_revision);
    BOOST_TEST(found.key == stored.substitutes.at(result.key));
    BOOST_TEST(stored.rows.contains(found.key));
    CaseResult read = with_stored(result.request, found);
    BOOST_TEST(read.key == found.key);  // to be found in the file
    read_fields(file, meshes.mesh(result.request.settings.body), read);
    BOOST_TEST((read.solution.displacements == result.solution.displacements));
  }

  // What this program computes takes the place of what the other did.
  ResultFile(file).put(std::span(results).first(1), true, meshes);
  BOOST_TEST(all_cases(file).rows == 3U);
  BOOST_TEST(read_cases(file, Revisions::own).rows == 1U);
  BOOST_TEST(read_cases(file, Revisions::all).rows == 2U);
  const auto both = read_results(file, Revisions::all);
  BOOST_TEST(both.at(results[0].key).revision.empty());
  BOOST_TEST(both.at(results[0].key).key == results[0].key);
  BOOST_TEST(both.at(results[1].key).revision == other_revision);
  BOOST_TEST(!stored_keys(file).substitutes.contains(results[0].key));
}

// What another revision began and this one went on with is of neither's cases.
BOOST_AUTO_TEST_CASE(a_result_is_stored_under_its_own_revision) {
  const OwnFolder own;
  const auto file = own.path / "a.h5";
  MeshStore meshes;
  auto results = two_results(meshes);
  const std::string key = results[0].key, both = other_revision + "+ours";
  const Mesh& mesh = meshes.mesh(results[0].request.settings.body);
  results[0].revision = both;
  results[0].key = key_of_identity(case_identity(results[0].request, mesh), both);
  write_results(file, results, meshes);
  BOOST_TEST((stored_keys(file).others == OtherRevisions{{both, 1}}));
  BOOST_TEST(!read_results(file, Revisions::own).contains(key));
  BOOST_TEST(read_results(file, Revisions::own).contains(results[1].key));
  BOOST_TEST(read_results(file, Revisions::all).at(key).revision == both);
}

BOOST_AUTO_TEST_CASE(of_several_other_revisions_the_newest_is_taken) {
  const OwnFolder own;
  const auto older = own.path / "older.h5", newer = own.path / "newer.h5";
  MeshStore meshes;
  const auto results = two_results(meshes);
  for (const auto& [file, revision, date] :
       {std::tuple(older, std::string(12, '1'), "2025-01-02T03:04:05Z"),
        {newer, other_revision, "2025-11-02T03:04:05Z"}}) {
    write_results(file, results, meshes);
    make_foreign(file, revision);
    const hdf5::Handle root(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose,
                            "a");
    const auto sessions = hdf5::open_group(root, "provenance");
    Row session = row_at(read_columns(sessions), 0);
    session["date"] = std::string(date);
    replace_row(sessions, 0, session);
  }
  for (const auto& files : {std::vector{older, newer}, {newer, older}})
    for (const auto& [key, place] : stored_cases(files, Revisions::all))
      BOOST_TEST(place.second.revision == other_revision);
  ResultFile(newer).absorb(older);  // which adds the older rows behind the newer
  BOOST_TEST(all_cases(newer).rows == 4U);
  for (const auto& [key, stored] : read_results(newer, Revisions::all))
    BOOST_TEST(stored.revision == other_revision);
}

// ParaView opens what the file holds, and what a report is of.
BOOST_AUTO_TEST_CASE(grids_of_other_revisions_say_so) {
  const OwnFolder own;
  const auto file = own.path / "a.h5", xdmf = own.path / "b.xdmf";
  MeshStore meshes;
  const auto results = two_results(meshes);
  write_results(file, results, meshes);
  make_foreign(file, other_revision);
  write_results(file, std::span(results).first(1), meshes);
  const auto grids = [](const fs::path& path, const std::string& ending) {
    std::size_t count = 0;
    std::ifstream lines(path);
    for (std::string line; std::getline(lines, line);)
      count += line.starts_with("<Grid ") && line.ends_with(ending + "\">");
    return count;
  };
  const std::string told = " of revision " + other_revision;
  BOOST_TEST(grids(own.path / "a.xdmf", "") == 3U);
  BOOST_TEST(grids(own.path / "a.xdmf", told) == 2U);
  write_xdmf_for(file, xdmf, Revisions::own);
  BOOST_TEST(grids(xdmf, "") == 1U);
  BOOST_TEST(grids(xdmf, told) == 0U);
  write_xdmf_for(file, xdmf, Revisions::all);
  BOOST_TEST(grids(xdmf, "") == 2U);
  BOOST_TEST(grids(xdmf, told) == 1U);
}

// Nobody can tell what was asked but by the columns: gates can, tables cannot.
BOOST_AUTO_TEST_CASE(files_older_than_revisions_keep_their_keys) {
  const OwnFolder own;
  const auto file = own.path / "a.h5";
  MeshStore meshes;
  const auto results = two_results(meshes);
  write_results(file, results, meshes);
  make_foreign(file, "");
  BOOST_TEST(read_cases(file, Revisions::own).rows == 0U);
  BOOST_TEST(read_cases(file, Revisions::all).rows == 2U);
  const auto all = read_results(file, Revisions::all);
  for (const CaseResult& result : results)
    BOOST_TEST(all.at(result.key).revision == "unknown");
  BOOST_TEST((stored_keys(file).others == OtherRevisions{{"unknown", 2}}));
  BOOST_TEST(stored_keys(file).substitutes.empty());
}

BOOST_AUTO_TEST_SUITE_END()
