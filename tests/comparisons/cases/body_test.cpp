#include "comparisons/cases/body.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/running/case_result.hpp"
#include "comparisons/settings/case_json.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/files/mesh_files.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tests/comparisons/settings.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(body_test)

namespace {

std::string message_of(const std::string& scene,
                       const std::vector<std::string>& changes) {
  try {
    requests(run_of(scene, changes));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// A block of 6 x 4 x 2 cm that stands half a metre up, in millimetres.
std::filesystem::path raised_block(const OwnFolder& folder) {
  const Mesh mesh = generate_block(
      {.size = {60, 40, 20}, .cells = {3, 2, 2}, .pattern = CellPattern::mixed});
  std::vector<Vector3> nodes = mesh.nodes();
  for (Vector3& x : nodes) x += Vector3(100, 200, 500);
  std::map<std::string, std::vector<FaceNodes>> regions{
      {"foot", mesh.region("bottom").faces}, {"head", mesh.region("top").faces}};
  const std::filesystem::path file = folder.path / "raised.msh";
  write_mesh(Mesh("raised", nodes, mesh.cells(), regions), file);
  return file;
}

}  // namespace

BOOST_AUTO_TEST_CASE(cell_types_distortion_and_seed_reach_the_block) {
  const CaseSettings settings =
      case_of("compression", {"cell-type=mixed", "distortion=0.2", "seed=7"});
  const Block& block = settings.body.block;
  BOOST_TEST((block.pattern == CellPattern::mixed));
  BOOST_TEST(block.distortion == 0.2);
  BOOST_TEST(block.seed == 7U);
  BOOST_TEST(message_of("compression", {"cell-type=cube"})
                 .starts_with("--cell-type: unknown value 'cube', expected one "
                              "of hexahedron, tetrahedron"));
  BOOST_TEST(message_of("compression", {"distortion=-1"}).starts_with("--distortion"));
}

// A seed that decides nothing about the mesh must not make another mesh of it.
BOOST_AUTO_TEST_CASE(the_seed_is_part_of_a_mesh_only_where_chance_is) {
  const auto seeds = [](const std::string& change) {
    return case_of("compression", {change, "seed=5", "method=fem-stvk"}).body.block.seed;
  };
  BOOST_TEST(seeds("cell-type=hexahedron") == 1U);
  BOOST_TEST(seeds("cell-type=mixed") == 5U);
  BOOST_TEST(seeds("distortion=0.1") == 5U);
}

// The plates are where the regions are: 500 mm up, 20 mm apart.
BOOST_AUTO_TEST_CASE(plates_of_a_file_s_mesh_are_its_regions,
                     *boost::unit_test::tolerance(1e-12)) {
  const OwnFolder folder;
  const std::string file = raised_block(folder).string();
  const std::vector<std::string> given{"mesh=" + file, "mesh-unit=mm", "fixed=foot",
                                       "moved=head", "method=mss-affine"};
  const CaseSettings settings = case_of("torsion", given);
  const Mesh mesh = build_mesh(settings.body);
  BOOST_TEST(mesh.volume() == 0.06 * 0.04 * 0.02);
  const Scene scene = mechanical_scene(settings, mesh);
  BOOST_TEST(scene.plates.front().region == "foot");
  const Plate& upper = scene.plates.back();
  BOOST_TEST(upper.region == "head");
  BOOST_TEST(upper.motion.centre.x() == 0.13);
  BOOST_TEST(upper.motion.centre.y() == 0.22);
  BOOST_TEST(upper.motion.centre.z() == 0.52);
  const CaseSettings pressed = case_of("compression", given);
  BOOST_TEST(mechanical_scene(pressed, mesh).plates.back().motion.translation.z() ==
             -0.05 * 0.02);
}

BOOST_AUTO_TEST_CASE(a_plate_that_is_missing_or_upside_down_is_refused) {
  const OwnFolder folder;
  const std::string file = raised_block(folder).string();
  const auto scene_with = [&](const std::string& fixed, const std::string& moved) {
    const CaseSettings settings =
        case_of("compression", {"mesh=" + file, "fixed=" + fixed, "moved=" + moved});
    mechanical_scene(settings, build_mesh(settings.body));
  };
  BOOST_CHECK_EXCEPTION(
      scene_with("foot", "nose"), InputError, [&](const InputError& error) {
        BOOST_TEST(error.what() ==
                   file + ": moved: unknown surface 'nose', expected one of foot, head");
        return true;
      });
  BOOST_CHECK_EXCEPTION(
      scene_with("head", "foot"), InputError, [&](const InputError& error) {
        BOOST_TEST(error.what() == file +
                                       ": region 'foot': expected a plate above 'head', "
                                       "along z, got one 20 m below it");
        return true;
      });
}

BOOST_AUTO_TEST_CASE(plates_beside_each_other_are_refused) {
  const OwnFolder folder;
  const Mesh mesh = generate_block({.size = {0.05, 0.02, 0.03}, .cells = {2, 2, 2}});
  const std::map<std::string, std::vector<FaceNodes>> regions{
      {"bottom", mesh.region("x_min").faces}, {"top", mesh.region("x_max").faces}};
  std::vector<Vector3> nodes = mesh.nodes();
  for (Vector3& x : nodes) x.z() += 1e-6 * x.x();  // the one is a little higher
  const std::string file = (folder.path / "lying.msh").string();
  write_mesh(Mesh("lying", nodes, mesh.cells(), regions), file);
  const CaseSettings settings = case_of("compression", {"mesh=" + file});
  BOOST_CHECK_EXCEPTION(
      mechanical_scene(settings, build_mesh(settings.body)), InputError,
      [](const InputError& error) {
        return std::string(error.what()).find("the body's axis is not z") !=
               std::string::npos;
      });
}

BOOST_AUTO_TEST_CASE(what_does_not_go_with_a_mesh_is_refused) {
  BOOST_TEST(
      message_of("compression", {"mesh=a.msh", "cells=2,2,2"})
          .starts_with(
              "--cells: expected no cells beside mesh 'a.msh', which stands in its "
              "place, got [2, 2, 2]"));
  BOOST_TEST(message_of("compression", {"fixed=foot"}) ==
             "--fixed: expected mesh beside fixed: no fixed without mesh, got 'foot'");
  BOOST_TEST(message_of("compression", {"mesh=a.msh", "mesh-unit=inch"}) ==
             "--mesh-unit: unknown value 'inch', expected one of m, cm, mm");
  BOOST_TEST(message_of("uniaxial", {"mesh=a.msh"}).find("expected a block") !=
             std::string::npos);
  BOOST_TEST(
      message_of("traction", {"mesh=a.msh", "plates=sliding"}).find("expected a block") !=
      std::string::npos);
  BOOST_TEST(message_of("compression", {"mesh=a.msh", "reference=fem-stvk@converged"})
                 .find("expected a block, which regular grids can cut") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_kidney_takes_no_settings_of_a_grid) {
  BOOST_TEST(
      message_of("kidney", {"cell-type=mixed"}) ==
      "--cell-type: expected free-tetrahedron or free-hexahedron for a kidney, got "
      "'mixed'");
  BOOST_TEST(message_of("kidney", {"distortion=0.1"})
                 .starts_with("--distortion: expected none of it but in blocks"));
}

BOOST_AUTO_TEST_CASE(a_disc_is_round_and_of_hexahedra) {
  const auto refused = [](const std::string& option, const std::string& expected) {
    BOOST_TEST(message_of("tissue-torsion", {option}).find(expected) !=
               std::string::npos);
  };
  refused("cell-type=tetrahedron", "--cell-type: expected hexahedron for a disc");
  refused("size=.015,.016,.003", "a disc's diameter twice, and its height");
  refused("cells=8,6,2", "as many along x as along y");
  refused("cells=2,2,2", "at least 3 across");
  refused("distortion=.1", "none of it but in blocks");
}

// What is not read is not part of a case.
BOOST_AUTO_TEST_CASE(settings_name_the_plates_that_a_test_has) {
  const auto settings = [](const std::string& scene) {
    return settings_json(case_of(scene, {"mesh=a.msh", "moved=b", "method=fem-stvk"}));
  };
  BOOST_TEST(settings("compression")["moved"] == "b");
  BOOST_TEST(!settings("bending").contains("moved"));
  BOOST_TEST(settings("bending")["fixed"] == "bottom");
  BOOST_TEST(!settings("affine").contains("fixed"));
}

// A case is its mesh's content, wherever the file lies; and its plates.
BOOST_AUTO_TEST_CASE(the_key_knows_the_mesh_by_its_content) {
  const OwnFolder folder;
  const std::filesystem::path file = raised_block(folder), copy = folder.path / "b.msh";
  std::filesystem::copy_file(file, copy);
  const auto key = [&](const std::filesystem::path& mesh, const std::string& moved) {
    const Request request{
        .settings = case_of("compression", {"mesh=" + mesh.string(), "fixed=foot",
                                            "moved=" + moved, "method=fem-stvk"}),
        .reference = std::nullopt};
    return case_key(request, build_mesh(request.settings.body));
  };
  BOOST_TEST(key(file, "head") == key(copy, "head"));
  BOOST_TEST(key(file, "head") != key(file, "foot"));
}

// On cells other than a grid's the converged reference is that of the regular grid of
// hexahedra.
BOOST_AUTO_TEST_CASE(references_on_named_cells_are_grids_of_hexahedra) {
  const Request on_same =
      requests(
          run_of("compression", {"cell-type=mixed", "cells=4,4,4", "method=mss-affine"}))
          .front();
  BOOST_TEST((on_same.reference->body == on_same.settings.body));
  BOOST_TEST(reference_label(on_same) == "fem-stvk:q1-sri");
  const Request on_grid =
      requests(run_of("compression", {"cell-type=mixed", "cells=4,4,4",
                                      "method=mss-affine", "reference=fem-hencky:q2@4"}))
          .front();
  BOOST_TEST((on_grid.reference->body.block.pattern == CellPattern::hexahedron));
  BOOST_TEST(reference_label(on_grid) == "fem-hencky:q2@4,4,4");
}

BOOST_AUTO_TEST_SUITE_END()
