#define BOOST_TEST_MODULE gmsh
#include "meshing/gmsh.hpp"

#include <gmsh.h>

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <limits>

#include "meshing/cell_geometry.hpp"
#include "meshing/input_error.hpp"

using namespace springcheck;

namespace {

// Sides and cells all different, so that mixed-up axes show.
const Block block{.size = {0.3, 0.2, 0.7}, .cells = {3, 2, 4}};

/// Number of the grid node (i, j, k), x fastest.
NodeIndex grid_node(int i, int j, int k) {
  return static_cast<NodeIndex>(i + 4 * (j + 3 * k));
}

void check_refusal(const Block& bad, const std::string& message) {
  BOOST_CHECK_EXCEPTION(generate_block(bad), InputError, [&](const InputError& error) {
    BOOST_TEST(error.what() == message);
    return true;
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(block_has_the_nodes_cells_and_volume_asked_for) {
  const Mesh mesh = generate_block(block);
  BOOST_TEST(mesh.nodes().size() == 4U * 3 * 5);
  BOOST_TEST(mesh.cells().size() == 3U * 2 * 4);
  BOOST_TEST(mesh.source() == "block 0.3 x 0.2 x 0.7 m in 3 x 2 x 4 cells");
  // Sums of 24 cells: round-off.
  BOOST_TEST(mesh.volume() == 0.3 * 0.2 * 0.7, boost::test_tools::tolerance(1e-14));
}

// Bit for bit: gmsh's own coordinates are about 1e-10 of a cell off.
BOOST_AUTO_TEST_CASE(nodes_stand_exactly_on_the_grid_in_lexicographic_order) {
  const Mesh mesh = generate_block(block);
  for (int k = 0; k <= 4; ++k)
    for (int j = 0; j <= 2; ++j)
      for (int i = 0; i <= 3; ++i) {
        const Vector3& x = mesh.nodes()[grid_node(i, j, k)];
        BOOST_TEST((x == Vector3(0.3 * i / 3, 0.2 * j / 2, 0.7 * k / 4)));
      }
}

BOOST_AUTO_TEST_CASE(cells_are_upright_and_in_lexicographic_order) {
  const Mesh mesh = generate_block(block);
  std::size_t cell = 0;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) {
        const CellNodes expected{grid_node(i, j, k),
                                  grid_node(i + 1, j, k),
                                  grid_node(i + 1, j + 1, k),
                                  grid_node(i, j + 1, k),
                                  grid_node(i, j, k + 1),
                                  grid_node(i + 1, j, k + 1),
                                  grid_node(i + 1, j + 1, k + 1),
                                  grid_node(i, j + 1, k + 1)};
        BOOST_TEST(mesh.cells()[cell++] == expected,
                   boost::test_tools::per_element());
      }
}

BOOST_AUTO_TEST_CASE(regions_are_the_six_sides_facing_outward,
                     *boost::unit_test::tolerance(1e-14)) {
  struct Side {
    const char* name;
    Eigen::Index axis;
    double place;
    Vector3 area;  // [m^2], outward
    std::size_t faces;
  };
  const std::vector<Side> sides{
      {"bottom", 2, 0, {0, 0, -0.06}, 6}, {"top", 2, 0.7, {0, 0, 0.06}, 6},
      {"y_min", 1, 0, {0, -0.21, 0}, 12}, {"y_max", 1, 0.2, {0, 0.21, 0}, 12},
      {"x_min", 0, 0, {-0.14, 0, 0}, 8},  {"x_max", 0, 0.3, {0.14, 0, 0}, 8}};
  const Mesh mesh = generate_block(block);
  BOOST_TEST(mesh.regions().size() == sides.size());
  for (const Side& side : sides) {
    BOOST_TEST_CONTEXT(side.name) {
      const Region& region = mesh.region(side.name);
      BOOST_TEST(region.faces.size() == side.faces);
      for (const NodeIndex node : region.nodes)
        BOOST_TEST(mesh.nodes()[node][side.axis] == side.place);
      for (const FaceNodes& face : region.faces) {
        const auto& x = mesh.nodes();
        const Vector3 area = (x[face[2]] - x[face[0]]).cross(x[face[3]] - x[face[1]]) / 2;
        const Vector3 expected = side.area / static_cast<double>(side.faces);
        for (Eigen::Index i = 0; i < 3; ++i) BOOST_TEST(area[i] == expected[i]);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(same_block_twice_is_the_same_mesh) {
  BOOST_TEST(generate_block(block).sha256() == generate_block(block).sha256());
  Block other = block;
  other.cells[2] = 5;
  BOOST_TEST(generate_block(block).sha256() != generate_block(other).sha256());
}

BOOST_AUTO_TEST_CASE(lengths_that_are_not_positive_and_finite_are_refused) {
  check_refusal(
      {{0.3, 0, 0.7}, {3, 2, 4}},
      "block 0.3 x 0 x 0.7 m in 3 x 2 x 4 cells: size: expected positive finite "
      "lengths, got 0");
  check_refusal({{-1, 1, 1}, {1, 1, 1}},
                "block -1 x 1 x 1 m in 1 x 1 x 1 cells: size: expected positive finite "
                "lengths, got -1");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  check_refusal({{1, 1, infinity}, {1, 1, 1}},
                "block 1 x 1 x inf m in 1 x 1 x 1 cells: size: expected positive finite "
                "lengths, got inf");
  check_refusal({{1, nan, 1}, {1, 1, 1}},
                "block 1 x nan x 1 m in 1 x 1 x 1 cells: size: expected positive finite "
                "lengths, got nan");
}

BOOST_AUTO_TEST_CASE(block_without_cells_along_an_axis_is_refused) {
  check_refusal({{1, 1, 1}, {2, 0, 2}},
                "block 1 x 1 x 1 m in 2 x 0 x 2 cells: cells: expected at least 1 along "
                "each axis, got 0");
}

BOOST_AUTO_TEST_CASE(more_nodes_than_can_be_numbered_are_refused) {
  check_refusal({{1, 1, 1}, {1999, 1999, 1999}},
                "block 1 x 1 x 1 m in 1999 x 1999 x 1999 cells: nodes: expected at most "
                "2^32 - 1, got 8e+09");
}

BOOST_AUTO_TEST_CASE(msh_file_says_4_1_and_reads_back_through_gmsh,
                     *boost::unit_test::tolerance(1e-14)) {
  const Mesh mesh = generate_block(block);
  const auto file = std::filesystem::temp_directory_path() / "springcheck_gmsh_test.msh";
  write_msh(mesh, file);
  std::ifstream in(file);
  std::string header, version, format;
  in >> header >> version >> format;
  BOOST_TEST(header == "$MeshFormat");
  BOOST_TEST(version == "4.1");
  BOOST_TEST(format == "0");  // ASCII

  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::open(file.string());
  for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
    std::vector<double> x, parametric;
    gmsh::model::mesh::getNode(n + 1, x, parametric);
    for (std::size_t i = 0; i < 3; ++i)  // gmsh prints 16 digits, one short of exact
      BOOST_TEST(x[i] == mesh.nodes()[n][static_cast<Eigen::Index>(i)]);
  }
  std::vector<std::size_t> tags, nodes;
  gmsh::model::mesh::getElementsByType(5, tags, nodes);
  BOOST_TEST(tags.size() == mesh.cells().size());
  for (std::size_t c = 0; c < tags.size(); ++c) {
    BOOST_TEST(tags[c] == c + 1);
    for (std::size_t i = 0; i < 8; ++i)
      BOOST_TEST(nodes[8 * c + i] == mesh.cells()[c][i] + 1);
  }
  std::map<std::string, std::size_t> faces;
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups);
  for (const auto& [dimension, group] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(dimension, group, name);
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(dimension, group, entities);
    for (const int entity : entities) {
      tags.clear();  // gmsh takes filled vectors for preallocated ones
      nodes.clear();
      gmsh::model::mesh::getElementsByType(dimension == 3 ? 5 : 3, tags, nodes, entity);
      faces[name] += tags.size();
    }
  }
  gmsh::finalize();
  std::filesystem::remove(file);
  BOOST_TEST((faces == std::map<std::string, std::size_t>{{"body", 24},
                                                          {"bottom", 6},
                                                          {"top", 6},
                                                          {"x_min", 8},
                                                          {"x_max", 8},
                                                          {"y_min", 12},
                                                          {"y_max", 12}}));
}
