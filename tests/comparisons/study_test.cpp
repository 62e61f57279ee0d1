#define BOOST_TEST_MODULE study
#include <array>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "comparisons/hdf5.hpp"
#include "comparisons/memory.hpp"
#include "comparisons/result_file.hpp"
#include "meshing/input_error.hpp"
#include "settings.hpp"

using namespace springcheck;

namespace {

/// A folder of the test's own, removed at its end.
struct OwnFolder {
  std::filesystem::path path = [] {
    std::string name =
        (std::filesystem::temp_directory_path() / "springcheck_study_XXXXXX").string();
    return std::filesystem::path(mkdtemp(name.data()));
  }();
  OwnFolder() = default;
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  ~OwnFolder() { std::filesystem::remove_all(path); }
};

const std::vector<std::string> small{"cells=4,4,4", "method=mss-cf,fem-hooke"};

std::vector<CaseResult> study(const std::vector<Request>& requests, MeshStore& meshes,
                              int parallel, std::size_t* simulations = nullptr) {
  return run_study(requests, meshes, parallel, [&](std::size_t, std::size_t all) {
    if (simulations != nullptr) *simulations = all;
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_verdict_lists_all_flags_and_takes_the_first) {
  using Flags = std::vector<Status>;
  const auto is = [](const Verdict& verdict, Status status, const Flags& flags) {
    return verdict.status == status && verdict.flags == flags;
  };
  BOOST_TEST(is(judge(SolveStatus::ok, false, false), Status::ok, {}));
  BOOST_TEST(
      is(judge(SolveStatus::ok, false, true), Status::wrinkled, {Status::wrinkled}));
  BOOST_TEST(is(judge(SolveStatus::indefinite, true, true), Status::inverted,
                {Status::inverted, Status::wrinkled, Status::indefinite}));
  BOOST_TEST(is(judge(SolveStatus::indefinite, false, false), Status::indefinite,
                {Status::indefinite}));
  BOOST_TEST(
      is(judge(SolveStatus::no_equilibrium, true, true), Status::no_equilibrium, {}));
  BOOST_TEST(is(judge(SolveStatus::refused, false, false), Status::refused, {}));
}

BOOST_AUTO_TEST_CASE(shared_simulations_run_once) {
  MeshStore meshes;
  std::vector<Request> all = requests(run_of("compression", small));
  all.push_back(all.front());
  std::size_t simulations = 0;
  const auto results = study(all, meshes, 2, &simulations);
  BOOST_TEST(simulations == 3U);  // mss-cf, fem-hooke and the reference fem-stvk
  BOOST_TEST_REQUIRE(results.size() == 3U);
  BOOST_TEST(results[0].key == results[2].key);
  BOOST_TEST(results[0].key != results[1].key);
}

BOOST_AUTO_TEST_CASE(the_key_holds_what_deviations_are_measured_against) {
  MeshStore meshes;
  Request request = requests(run_of("compression", small)).front();
  const Mesh& mesh = meshes.mesh(request.settings.block);
  const std::string key = case_key(request, mesh);
  request.reference->element = *find_element("q1");
  BOOST_TEST(case_key(request, mesh) != key);
  request.reference.reset();
  BOOST_TEST(case_key(request, mesh) != key);
}

// A reference that a file holds with its fields is not computed again.
BOOST_AUTO_TEST_CASE(known_references_are_taken_with_their_fields) {
  MeshStore meshes;
  const Request request = requests(run_of("compression", small)).front();
  const Request alone{.settings = *request.reference, .reference = std::nullopt};
  const CaseResult reference = study({alone}, meshes, 1).front();
  const CaseResult computed = study({request}, meshes, 1).front();
  std::size_t simulations = 0;
  const CaseResult result =
      run_study(
          {request}, meshes, 1, [&](std::size_t, std::size_t all) { simulations = all; },
          [&](const Request&, const std::string& key) -> std::optional<CaseResult> {
            if (key != reference.key) return std::nullopt;
            return reference;
          })
          .front();
  BOOST_TEST(simulations == 1U);
  BOOST_TEST(*result.measures.mean_deviation == *computed.measures.mean_deviation);
}

// Nearly incompressible and crushed to four tenths of its height, the lattice folds over.
BOOST_AUTO_TEST_CASE(a_folded_cell_is_reported_inverted) {
  MeshStore meshes;
  const auto results = study(
      requests(run_of("compression",
                      {"cells=4,4,4", "method=mss-cf", "nu=0.499", "deformation=0.6"})),
      meshes, 2);
  BOOST_TEST((results.front().status == Status::inverted));
  BOOST_TEST(*results.front().measures.corner_jacobian_ratio_min < 0);
}

// The same bits whatever runs beside: every simulation is sequential in its sums.
BOOST_AUTO_TEST_CASE(results_do_not_depend_on_how_many_run_at_once) {
  MeshStore meshes;
  const auto all = requests(run_of("torsion", small));
  const auto alone = study(all, meshes, 1), together = study(all, meshes, 2);
  for (std::size_t i = 0; i < all.size(); ++i) {
    BOOST_TEST((alone[i].solution.displacements == together[i].solution.displacements));
    BOOST_TEST(*alone[i].measures.plate_torque == *together[i].measures.plate_torque);
  }
}

BOOST_AUTO_TEST_CASE(a_refused_case_is_a_result_without_measures) {
  MeshStore meshes;
  const auto results =
      study(requests(run_of("compression",
                            {"size=.05,.05,.06", "cells=4,4,4", "method=mss-cf"})),
            meshes, 1);
  BOOST_TEST((results.front().status == Status::refused));
  BOOST_TEST(results.front().reason.find("cubic") != std::string::npos);
  for_each_measure(results.front().measures, [](const char* name, const auto& value) {
    BOOST_TEST(!value.has_value(), name);
  });
}

// With vectors and matrices among the measures, and iterations where there are any.
BOOST_AUTO_TEST_CASE(a_result_file_gives_back_what_was_written) {
  const OwnFolder own;
  const auto file = own.path / "study.h5";
  MeshStore meshes;
  auto all = requests(run_of("compression", small));
  for (const char* scene : {"traction", "affine"})
    all.push_back(
        requests(run_of(scene, {"method=fem-stvk", "linear-solver=multigrid"})).front());
  const auto written = study(all, meshes, 1);
  BOOST_TEST(!written[0].solution.linear_iterations.has_value());
  BOOST_TEST(written[2].solution.linear_iterations.value() > 0);
  write_results(file, written, meshes);
  const auto stored = read_results(file);
  BOOST_TEST_REQUIRE(stored.size() == 4U);
  for (const CaseResult& result : written) {
    CaseResult read = with_stored(result.request, result.key, stored.at(result.key));
    const Mesh& mesh = meshes.mesh(result.request.settings.block);
    read_fields(file, mesh, read);
    BOOST_TEST((read.solution.displacements == result.solution.displacements));
    BOOST_TEST((read.solution.reactions == result.solution.reactions));
    const auto volumes = deformed_volumes(mesh, result.solution);
    for (std::size_t c = 0; c < volumes.size(); ++c)
      BOOST_TEST(read.solution.cell_volumes.at(c) == volumes[c],
                 boost::test_tools::tolerance(1e-14));
    const Mesh other = generate_block({.size = {1, 1, 1}, .cells = {2, 2, 2}});
    BOOST_CHECK_THROW(read_fields(file, other, read), InputError);
    BOOST_TEST((read.status == result.status));
    BOOST_TEST(read.solution.steps == result.solution.steps);
    BOOST_TEST((read.solution.linear_iterations == result.solution.linear_iterations));
    BOOST_TEST(read.wall_s == result.wall_s);
    std::vector<double> before, after;  // exact: binary numbers
    const auto collect = [](std::vector<double>& into) {
      return [&](const char*, const auto& value) {
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

// Each item names a dataset of the HDF5 file and its shape; topology is 8 wide, points 3.
BOOST_AUTO_TEST_CASE(xdmf_names_datasets_by_their_shapes) {
  const OwnFolder own;
  MeshStore meshes;
  write_results(own.path / "a&b.h5",
                study(requests(run_of("compression", small)), meshes, 1), meshes);
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
  BOOST_TEST(items == 2 * 5);  // mesh, points and three fields of two cases
}

BOOST_AUTO_TEST_CASE(foreign_and_broken_files_are_refused_by_name) {
  const OwnFolder own;
  const std::filesystem::path& folder = own.path;
  const auto message = [](const std::filesystem::path& file) {
    try {
      read_results(file);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  BOOST_TEST(message(folder / "none.h5").find("no such file") != std::string::npos);
  std::ofstream(folder / "text.h5") << "not HDF5";
  BOOST_TEST(message(folder / "text.h5").find("text.h5") != std::string::npos);
  const auto make = [&](const char* name, std::optional<long long> layout) {
    const auto root = hdf5::create_in_memory();
    if (layout) hdf5::write_attribute(root, "layout", *layout);
    std::ofstream(folder / name, std::ios::binary) << hdf5::file_image(root);
  };
  make("foreign.h5", std::nullopt);
  BOOST_TEST(message(folder / "foreign.h5").find("layout") != std::string::npos);
  make("newer.h5", 2);
  BOOST_TEST(message(folder / "newer.h5") ==
             (folder / "newer.h5").string() + ": layout: expected 1, got 2");
  make("cut.h5", 1);
  BOOST_TEST(message(folder / "cut.h5").find("cases") != std::string::npos);
}

// Figures that no program of ours writes are not taken into tables.
BOOST_AUTO_TEST_CASE(damaged_figures_are_refused_with_their_case) {
  const OwnFolder own;
  MeshStore meshes;
  const std::vector<CaseResult> good =
      study({requests(run_of("compression", small)).back()}, meshes, 1);
  const auto message = [&](const auto& damage) {
    std::vector<CaseResult> bad = good;
    damage(bad.front());
    write_results(own.path / "bad.h5", bad, meshes);
    try {
      read_results(own.path / "bad.h5");
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
  ends_with(message([](CaseResult& r) { r.measures.plate_force = std::nan(""); }),
            "plate_force" + of_case + "finite numbers, got others");
  ends_with(message([](CaseResult& r) { r.measures.force->x() = INFINITY; }),
            "force" + of_case + "finite numbers, got others");
  ends_with(message([](CaseResult& r) { r.measures.volume_error.reset(); }),
            "volume_error" + of_case + "a number, got none with status ok");
  ends_with(message([](CaseResult& r) { r.status = Status::not_converged; }),
            "volume_error" + of_case + "none, got one with status not_converged");
  ends_with(message([](CaseResult& r) { r.wall_s = std::nan(""); }),
            "attribute 'wall_s'" + of_case + "a number, got none");
}

BOOST_AUTO_TEST_CASE(too_many_cells_are_refused_before_allocating) {
  const auto all =
      requests(run_of("compression", {"cells=2000,2000,2000", "method=mss-cf"}));
  BOOST_CHECK_EXCEPTION(
      check_memory("--cells", all, 1), InputError, [](const InputError& error) {
        return std::string(error.what()).find("GB") != std::string::npos;
      });
  BOOST_CHECK_NO_THROW(
      check_memory("--cells", requests(run_of("compression", small)), 2));
}
