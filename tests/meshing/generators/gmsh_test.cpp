#include "meshing/files/mesh_files.hpp"
#include "meshing/generators/generate_block.hpp"

#include <gmsh.h>

#include <boost/test/unit_test.hpp>
#include <fstream>

#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(gmsh_test)

namespace {

// Sides and cells all different, so that mixed-up axes show.
const Block block{.size = {0.3, 0.2, 0.7}, .cells = {3, 2, 4}};

}  // namespace

BOOST_AUTO_TEST_CASE(msh_file_says_4_1_and_reads_back_through_gmsh,
                     *boost::unit_test::tolerance(1e-14)) {
  const Mesh mesh = generate_block(block);
  const OwnFolder own;
  const auto file = own / "block.msh";
  write_mesh(mesh, file);
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
  BOOST_TEST((faces == std::map<std::string, std::size_t>{{"body", 24},
                                                          {"bottom", 6},
                                                          {"top", 6},
                                                          {"x_min", 8},
                                                          {"x_max", 8},
                                                          {"y_min", 12},
                                                          {"y_max", 12}}));
}

BOOST_AUTO_TEST_SUITE_END()
