#include "meshing/files/msh_reader.hpp"

#include <gmsh.h>

#include <boost/test/unit_test.hpp>

#include "meshing/basics/input_error.hpp"
#include "meshing/files/mesh_files.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(msh_reader_test)

namespace {

const OwnFolder directory;

std::filesystem::path file_with(const std::string& text) {
  const std::filesystem::path file = directory / "text.msh";
  std::ofstream(file) << text;
  return file;
}

/// One tetrahedron: 7 left out nodes' numbers, a point, a line, and both of its named and
/// unnamed surfaces.
const std::string tetrahedron_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n2\n2 5 \"lower side\"\n3 9 \"liver\"\n$EndPhysicalNames\n"
    "$Comments\nnobody reads 1 2 3\n$EndComments\n"
    "$Nodes\n5\n40 0 0 1e3\n10 0 0 0\n20 1e+3 0 0\n30 +0 1000. 0\n7 5 5 5\n$EndNodes\n"
    "$Elements\n5\n1 15 2 0 1 7\n2 1 2 0 1 10 20\n3 2 2 5 1 10 20 30\n"
    "4 2 2 6 1 10 20 40\n5 4 2 9 1 10 20 30 40\n$EndElements\n";
const std::string tetrahedron_4 =
    "$MeshFormat\r\n4.1 0 8\r\n$EndMeshFormat\r\n"
    "$PhysicalNames\n2\n2 5 \"lower side\"\n3 9 \"liver\"\n$EndPhysicalNames\n"
    "$Entities\n1 1 2 1\n1 5 5 5 0\n1 0 0 0 1 1 1 0 2 1 -1\n"
    "1 0 0 0 1 1 0 1 -5 0\n2 0 0 0 1 0 1 1 6 1 1\n"
    "1 0 0 0 1 1 1 1 9 2 1 2\n$EndEntities\n"
    "$Nodes\n3 5 7 40\n0 1 0 1\n7\n5 5 5\n2 1 1 2\n40\n10\n0 0 1000 .5 .5\n0 0 0 0 0\n"
    "3 1 0 2\n20\n30\n1000 0 0\n0 1000 0\n$EndNodes\n"
    "$Elements\n5 5 1 5\n0 1 15 1\n1 7\n1 1 1 1\n2 10 20\n2 1 2 1\n3 10 20 30\n"
    "2 2 2 1\n4 10 20 40\n3 1 4 1\n5 10 20 30 40\n$EndElements\n";

/// Two tetrahedra, each a physical volume, with a named surface between them.
const std::string two_materials =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n4\n2 5 \"bottom\"\n2 6 \"capsule\"\n3 8 \"liver\"\n3 9 \"tumour\"\n"
    "$EndPhysicalNames\n"
    "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 -1\n$EndNodes\n"
    "$Elements\n4\n1 2 2 6 1 1 2 3\n2 2 2 5 1 1 2 5\n3 4 2 8 1 1 2 3 4\n"
    "4 4 2 9 1 1 3 2 5\n$EndElements\n";

/// The mesh as gmsh writes it.
std::filesystem::path through_gmsh(const Mesh& mesh, double version, int is_binary) {
  write_mesh(mesh, directory / "ours.msh");
  const std::filesystem::path file = directory / "gmshs.msh";
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::open((directory / "ours.msh").string());
  gmsh::option::setNumber("Mesh.MshFileVersion", version);
  gmsh::option::setNumber("Mesh.Binary", is_binary);
  gmsh::write(file.string());
  gmsh::finalize();
  return file;
}

Mesh mixed_block() {
  return generate_block({.size = {0.3, 0.2, 0.7},
                         .cells = {3, 4, 5},
                         .pattern = CellPattern::mixed,
                         .distortion = 0.15});
}

}  // namespace

BOOST_AUTO_TEST_CASE(
    both_versions_are_read_in_their_unit_with_regions_by_name_or_number) {
  for (const std::string& text : {tetrahedron_2, tetrahedron_4}) {
    const Mesh mesh = read_msh(file_with(text), 0.001);
    // Ascending tags: 10, 20, 30, 40.
    BOOST_TEST((mesh.nodes() ==
                std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    BOOST_TEST((mesh.cells() == std::vector<CellNodes>{{0, 1, 2, 3}}));
    BOOST_TEST(mesh.regions().size() == 2U);
    // Turned to face outward where they did not:
    BOOST_TEST((mesh.region("lower side").faces == std::vector<FaceNodes>{{0, 2, 1}}));
    BOOST_TEST((mesh.region("6").faces == std::vector<FaceNodes>{{0, 1, 3}}));
    BOOST_TEST(mesh.source() == (directory / "text.msh").string());
  }
}

BOOST_AUTO_TEST_CASE(file_of_ours_reads_back_bit_by_bit_in_all_patterns) {
  for (const CellPatternName& pattern : cell_patterns())
    for (const double distortion : {0., 0.02}) {
      const Mesh mesh = generate_block({.size = {0.3, 0.2, 0.7},
                                        .cells = {3, 2, 7},
                                        .pattern = pattern.value,
                                        .distortion = distortion});
      write_mesh(mesh, directory / "mesh.msh");
      const Mesh back = read_msh(directory / "mesh.msh", 1);
      BOOST_TEST(back.sha256() == mesh.sha256(), mesh.source());
    }
}

BOOST_AUTO_TEST_CASE(binary_files_of_gmsh_read_back_bit_by_bit) {
  const Mesh mesh = mixed_block();
  for (const double version : {2.2, 4.1})
    BOOST_TEST(read_msh(through_gmsh(mesh, version, 1), 1).sha256() == mesh.sha256());
}

// gmsh prints 16 digits, one short of exact.
BOOST_AUTO_TEST_CASE(text_files_of_gmsh_read_back_but_for_the_last_digit) {
  const Mesh mesh = mixed_block();
  for (const double version : {2.2, 4.1}) {
    const Mesh back = read_msh(through_gmsh(mesh, version, 0), 1);
    BOOST_TEST((back.cells() == mesh.cells()));
    for (const auto& [name, region] : mesh.regions())
      BOOST_TEST((back.region(name).faces == region.faces));
    BOOST_TEST_REQUIRE(back.nodes().size() == mesh.nodes().size());
    for (std::size_t n = 0; n < mesh.nodes().size(); ++n)
      BOOST_TEST((back.nodes()[n] - mesh.nodes()[n]).norm() < 1e-15);
  }
}

// Two tetrahedra, of which the upper one is in no group: it is not there, nor its node.
BOOST_AUTO_TEST_CASE(cells_outside_the_physical_volumes_do_not_count) {
  std::string text = tetrahedron_2;
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("$Nodes\n5\n", "$Nodes\n6\n50 1000 1000 1000\n");
  replace("$Elements\n5\n", "$Elements\n6\n6 4 2 0 2 20 30 40 50\n");
  BOOST_TEST(read_msh(file_with(text), 1).nodes().size() == 4U);
  replace("5 4 2 9 1", "5 4 2 0 1");
  BOOST_TEST(read_msh(file_with(text), 1).nodes().size() == 5U);
}

// Version 2.2 has one line for each physical group.
BOOST_AUTO_TEST_CASE(cell_in_two_physical_volumes_counts_once) {
  std::string text = tetrahedron_2;
  const std::string from = "$Elements\n5\n";
  text.replace(text.find(from), from.size(), "$Elements\n6\n6 4 2 8 1 10 20 30 40\n");
  BOOST_TEST(read_msh(file_with(text), 1).cells().size() == 1U);
}

BOOST_AUTO_TEST_CASE(cells_of_any_order_are_sorted_by_type) {
  const Mesh mesh = mixed_block();
  const Mesh back = read_msh(through_gmsh(mesh, 2.2, 0), 1);
  BOOST_TEST(std::ranges::is_sorted(back.cells(), {}, &CellNodes::size));
}

BOOST_AUTO_TEST_CASE(a_surface_between_cells_is_a_name_and_no_plate) {
  const Mesh mesh = read_msh(file_with(two_materials), 1);
  BOOST_TEST(mesh.cells().size() == 2U);
  BOOST_TEST(mesh.regions().size() == 1U);
  BOOST_TEST((mesh.surfaces_elsewhere() == std::set<std::string>{"capsule"}));
  BOOST_CHECK_EXCEPTION((void)mesh.region("capsule"), InputError, [](const auto& error) {
    return std::string(error.what())
        .ends_with(
            "region: expected a surface on the boundary, got 'capsule', which is not on "
            "it "
            "throughout");
  });
}

BOOST_AUTO_TEST_SUITE_END()
