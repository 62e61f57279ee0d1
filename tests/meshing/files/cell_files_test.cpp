#include <boost/test/unit_test.hpp>
#include <sstream>

#include "meshing/basics/input_error.hpp"
#include "meshing/files/mesh_files.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(cell_files_test)

namespace {

const OwnFolder directory;

/// One cell of each type but hexahedra, which other tests have, and apart: nodes 0 to 3 a
/// tetrahedron, 4 to 8 a pyramid, 9 to 14 a prism.
Mesh cells(bool with_pyramid) {
  std::vector<Vector3> nodes{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<CellNodes> list{{0, 1, 2, 3}};
  if (with_pyramid) {
    for (const Vector3& x :
         {Vector3(2, 0, 0), {3, 0, 0}, {3, 1, 0}, {2, 1, 0}, {2.5, 0.5, 1}})
      nodes.push_back(x);
    list.push_back({4, 5, 6, 7, 8});
  }
  const auto first = static_cast<NodeIndex>(nodes.size());
  for (const double z : {0., 1.})
    for (const auto& [x, y] : {std::pair{4., 0.}, {5., 0.}, {4., 1.}})
      nodes.emplace_back(x, y, z);
  CellNodes prism;
  for (NodeIndex i = 0; i < 6; ++i) prism.push_back(first + i);
  list.push_back(prism);
  std::map<std::string, std::vector<FaceNodes>> regions;
  for (const CellNodes& cell : list)
    for (std::size_t f = 0; f < faces(type_of(cell)).size(); ++f)
      regions[std::string(name_of(type_of(cell))) + std::to_string(f)] = {
          face_nodes(cell, faces(type_of(cell))[f])};
  return {"cells", nodes, list, regions};
}

std::string written(const Mesh& mesh, const char* name) {
  write_mesh(mesh, directory / name);
  return text_of(directory / name);
}

}  // namespace

// VTK's wedge has its first triangle the other way round.
BOOST_AUTO_TEST_CASE(vtu_file_has_vtks_types_and_orders) {
  const std::string text = written(cells(true), "mesh.vtu");
  BOOST_TEST(text.find("Name=\"connectivity\" format=\"ascii\">\n0 1 2 3\n4 5 6 7 8\n"
                       "9 11 10 12 14 13\n<") != std::string::npos);
  BOOST_TEST(text.find("Name=\"offsets\" format=\"ascii\">\n4\n9\n15\n<") !=
             std::string::npos);
  BOOST_TEST(text.find("Name=\"types\" format=\"ascii\">\n10\n14\n13\n<") !=
             std::string::npos);
  const std::string block =
      written(generate_block({.size = {1, 1, 1}, .cells = {1, 1, 1}}), "mesh.vtu");
  BOOST_TEST(block.find("Name=\"types\" format=\"ascii\">\n12\n<") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(inp_file_has_one_block_of_elements_for_each_type) {
  const std::string text = written(cells(false), "mesh.inp");
  BOOST_TEST(text.find("*ELEMENT, TYPE=C3D4, ELSET=Eall\n1, 1, 2, 3, 4\n"
                       "*ELEMENT, TYPE=C3D6, ELSET=Eall\n2, 5, 6, 7, 8, 9, 10\n*NSET") !=
             std::string::npos);
}

// CalculiX's manual, of 1-2-3-4: S1 1-2-3, S2 1-4-2, S3 2-4-3, S4 3-4-1; of the wedge
// 1-2-3-4-5-6: S1 1-2-3, S2 4-5-6, S3 1-2-5-4, S4 2-3-6-5, S5 3-1-4-6.
BOOST_AUTO_TEST_CASE(inp_surfaces_name_the_faces_as_calculix_does) {
  struct Expected {
    std::string cell;
    std::vector<FaceNodes> faces;  // S1, S2, ...
  };
  const Mesh mesh = cells(false);
  const std::string text = written(mesh, "mesh.inp");
  for (const auto& [cell, faces] :
       {Expected{"1", {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}}},
        Expected{"2", {{4, 5, 6}, {7, 8, 9}, {4, 5, 7, 8}, {5, 6, 8, 9}, {4, 6, 7, 9}}}})
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto region = std::ranges::find_if(mesh.regions(), [&](const auto& entry) {
        return ascending(entry.second.faces.front()) == faces[f];
      });
      BOOST_TEST_REQUIRE((region != mesh.regions().end()));
      const std::string surface = "*SURFACE, NAME=" + region->first + ", TYPE=ELEMENT\n" +
                                  cell + ", S" + std::to_string(f + 1) + "\n";
      BOOST_TEST(text.find(surface) != std::string::npos, surface);
    }
}

BOOST_AUTO_TEST_CASE(names_that_calculix_does_not_take_are_refused_in_inp_files) {
  const Mesh block = generate_block({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const auto named = [&](const std::string& name) {
    return Mesh("block", block.nodes(), block.cells(),
                {{name, block.region("top").faces}});
  };
  BOOST_CHECK_NO_THROW(write_mesh(named(std::string(80, 'a')), directory / "a.inp"));
  for (const std::string& name : {std::string("foot,left"), std::string(81, 'a')})
    BOOST_CHECK_EXCEPTION(
        write_mesh(named(name), directory / "b.inp"), InputError,
        [](const InputError& error) {
          return std::string(error.what()).find("what CalculiX takes") !=
                 std::string::npos;
        });
}

BOOST_AUTO_TEST_CASE(pyramids_are_refused_in_inp_files) {
  const std::filesystem::path file = directory / "pyramids.inp";
  BOOST_CHECK_EXCEPTION(
      write_mesh(cells(true), file), InputError, [&](const InputError& error) {
        BOOST_TEST(error.what() == file.string() +
                                       ": pyramids: expected none, as CalculiX has no "
                                       "such cells, got 1");
        return true;
      });
  BOOST_TEST(!std::filesystem::exists(file));
}

BOOST_AUTO_TEST_SUITE_END()
