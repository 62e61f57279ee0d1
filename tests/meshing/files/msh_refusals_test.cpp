#include <boost/test/unit_test.hpp>
#include <limits>

#include "meshing/basics/input_error.hpp"
#include "meshing/files/msh_reader.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(msh_refusals_test)

namespace {

const OwnFolder directory;
const std::filesystem::path file = directory / "bad.msh";

/// What read_msh says of a file, behind the file's name.
std::string refusal(const std::filesystem::path& bad, double metres_per_unit = 1) {
  try {
    static_cast<void>(read_msh(bad, metres_per_unit));
  } catch (const InputError& error) {
    const std::string message = error.what();
    BOOST_TEST(message.starts_with(bad.string()), message);
    return message.substr(bad.string().size());
  }
  return "no refusal";
}

std::string refusal_of(const std::string& text) {
  std::ofstream(file) << text;
  return refusal(file);
}

const std::string format = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";

/// A tetrahedron of nodes 1 to 4 on the plane z = 0, with more of both.
std::string text(const std::string& nodes = "", int more_nodes = 0,
                 const std::string& elements = "", int more_elements = 0) {
  return format + "$Nodes\n" + std::to_string(4 + more_nodes) +
         "\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n" + nodes + "$EndNodes\n$Elements\n" +
         std::to_string(1 + more_elements) + "\n11 4 2 0 1 1 2 3 4\n" + elements +
         "$EndElements\n";
}

std::string replaced(std::string in, const std::string& from, const std::string& to) {
  return in.replace(in.find(from), from.size(), to);
}

}  // namespace

BOOST_AUTO_TEST_CASE(sound_text_is_not_refused) {
  BOOST_TEST(refusal_of(text()) == "no refusal");
}

BOOST_AUTO_TEST_CASE(what_is_no_file_to_read_is_refused) {
  BOOST_TEST(refusal(directory / "none.msh") ==
             ": expected a gmsh file that can be read, got no such file (gmsh -3 "
             "BODY.geo -o BODY.msh makes one)");
  BOOST_TEST(refusal(directory / "") ==
             ": expected a gmsh file that can be read, got a directory");
  BOOST_TEST(refusal("/dev/zero") ==
             ": expected a gmsh file that can be read, got no regular file");
  BOOST_TEST(refusal_of("") ==
             ": expected a gmsh file that can be read, got an empty one");
}

// gmsh would run it.
BOOST_AUTO_TEST_CASE(script_is_refused_and_not_run) {
  const std::filesystem::path trace = directory / "trace";
  BOOST_TEST(refusal_of("SystemCall \"touch " + trace.string() + "\";\n") ==
             ":1: first line: expected '$MeshFormat' of a mesh (gmsh -3 "
             "BODY.geo -o BODY.msh makes one), got 'SystemCall'");
  BOOST_TEST(!std::filesystem::exists(trace));
}

BOOST_AUTO_TEST_CASE(other_versions_and_kinds_of_data_are_refused) {
  const auto with = [](const std::string& line) {
    return refusal_of(replaced(text(), "2.2 0 8", line));
  };
  BOOST_TEST(with("4 0 8") == ":2: $MeshFormat: expected version 2.2 or 4.1, got '4'");
  BOOST_TEST(with("2.2 2 8") == ":2: $MeshFormat: expected file type 0 or 1, got 2");
  BOOST_TEST(with("2.2 0 4") == ":2: $MeshFormat: expected data size 8, got 4");
  BOOST_TEST(with("2.2 1 8") ==
             ": $MeshFormat: expected 1 in this machine's byte order, got 1684948260");
}

BOOST_AUTO_TEST_CASE(unit_that_is_no_length_is_refused) {
  std::ofstream(file) << text();
  BOOST_TEST(refusal(file, 0) ==
             ": metres per unit: expected a positive finite number, got 0");
  BOOST_TEST(refusal(file, std::numeric_limits<double>::quiet_NaN()) ==
             ": metres per unit: expected a positive finite number, got nan");
}

BOOST_AUTO_TEST_CASE(damage_is_named_by_line_and_section) {
  BOOST_TEST(refusal_of(format) == ":4: expected a section $Nodes, got none");
  BOOST_TEST(refusal_of(text().substr(0, 80)) ==
             ":10: $Nodes: expected '$EndNodes', got '$End'");
  BOOST_TEST(refusal_of(replaced(text(), "3 0 1 0", "3 0 x 0")) ==
             ":8: $Nodes: expected a number, got 'x'");
  BOOST_TEST(refusal_of(replaced(text(), "3 0 1 0", "3.5 0 1 0")) ==
             ":8: $Nodes: expected a whole number, got '3.5'");
  BOOST_TEST(refusal_of(replaced(text(), "$EndNodes", "5 1 1 1\n$EndNodes")) ==
             ":10: $Nodes: expected '$EndNodes', got '5'");
  BOOST_TEST(refusal_of(text() + "$Periodic\n0\n") ==
             ":15: $Periodic: expected '$EndPeriodic', got the end of the file");
  BOOST_TEST(refusal_of(text() + "rubbish\n") ==
             ":15: section: expected the start of a section, got 'rubbish'");
  BOOST_TEST(refusal_of(text() + "$Nodes\n0\n$EndNodes\n") ==
             ":15: $Nodes: expected the section once, got it twice");
}

BOOST_AUTO_TEST_CASE(counts_beyond_the_file_are_refused_before_memory_is_asked_for) {
  BOOST_TEST(refusal_of(replaced(text(), "$Nodes\n4", "$Nodes\n4000000000000")) ==
             ":5: $Nodes: expected from 0 to the 10 that the rest of the file has room "
             "for, got 4000000000000");
  BOOST_TEST(refusal_of(replaced(text(), "$Nodes\n4", "$Nodes\n-4")) ==
             ":5: $Nodes: expected from 0 to the 10 that the rest of the file has room "
             "for, got -4");
}

BOOST_AUTO_TEST_CASE(elements_of_higher_order_are_refused) {
  BOOST_TEST(refusal_of(replaced(text(), "11 4 2", "11 11 2")) ==
             ":13: $Elements: expected elements of first order: points, lines, "
             "triangles, quadrilaterals, tetrahedra, pyramids, prisms, hexahedra, got "
             "gmsh's type 11");
}

BOOST_AUTO_TEST_CASE(mesh_without_cells_is_refused) {
  BOOST_TEST(
      refusal_of(format + "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
                          "$Elements\n1\n1 2 2 0 1 1 2 3\n$EndElements\n") ==
      ": cells: expected at least 1 tetrahedron, pyramid, prism or hexahedron, got "
      "0 beside 1 triangles and quadrilaterals");
}

BOOST_AUTO_TEST_CASE(bad_nodes_are_named_by_their_tags) {
  BOOST_TEST(refusal_of(text("70 5 5 5\n", 1)) ==
             ": node 70: expected an element that uses it, got none");
  BOOST_TEST(refusal_of(text("3 5 5 5\n", 1)) ==
             ": node 3: expected to be given once, got it twice");
  BOOST_TEST(refusal_of(text("", 0, "12 4 2 0 1 1 2 3 99\n", 1)) ==
             ": tetrahedron 12: expected nodes of the file, got a node 99");
  for (const std::string bad : {"inf", "nan", "-inf"})
    BOOST_TEST(refusal_of(replaced(text(), "2 1 0 0", "2 1 " + bad + " 0")) ==
               ": node 2: expected finite coordinates, got (1, " + bad + ", 0)");
  std::ofstream(file) << replaced(text(), "2 1 0 0", "2 1e300 0 0");
  BOOST_TEST(refusal(file, 1e20) ==
             ": node 2: expected finite coordinates, got (1e+300, 0, 0)");
}

BOOST_AUTO_TEST_CASE(bad_cells_are_named_by_their_tags) {
  BOOST_TEST(refusal_of(replaced(text(), "1 2 3 4", "1 3 2 4")) ==
             ": tetrahedron 11 near (0.25, 0.25, 0.25) m: expected positive Jacobians at "
             "its corners, got -1 m^3");
  BOOST_TEST(refusal_of(replaced(text(), "4 0 0 1", "4 1 1 0")) ==
             ": tetrahedron 11 near (0.5, 0.5, 0) m: expected positive Jacobians at its "
             "corners, got 0 m^3");
  BOOST_TEST(refusal_of(text("", 0, "12 4 2 0 1 1 2 3 3\n", 1)) ==
             ": tetrahedron 12 near (0.25, 0.5, 0) m: expected positive Jacobians at its "
             "corners, got 0 m^3");
  BOOST_TEST(refusal_of(text("", 0, "12 4 2 0 1 1 2 3 4\n", 1)) ==
             ": tetrahedron 12 near (0.25, 0.25, 0.25) m: expected its neighbour on the "
             "other side of each of its faces, got tetrahedron 11 near (0.25, 0.25, "
             "0.25) m on the same side: the two overlap, or are one");
  BOOST_TEST(refusal_of(text("5 0 0 -1\n6 0 0 -2\n", 2,
                             "12 4 2 0 1 1 3 2 5\n13 4 2 0 1 1 3 2 6\n", 2)) ==
             ": tetrahedron 13 near (0.25, 0.25, -0.5) m: expected at most two cells at "
             "each of its faces, got three");
}

BOOST_AUTO_TEST_CASE(nonconforming_cells_are_named_by_the_tags_of_their_nodes) {
  // The first cells were never merged; the second have a node hanging in the lower face.
  BOOST_TEST(refusal_of(text("20 0 0 0\n21 1 0 0\n22 0 1 0\n23 0 0 -1\n", 4,
                             "12 4 2 0 1 20 22 21 23\n", 1)) ==
             ": node 1: expected a place of its own, or cells merged there, got node 20 "
             "in the same place");
  BOOST_TEST(refusal_of(text("20 .2 .2 0\n21 1 2 -1\n22 2 1 -1\n23 2 2 -2\n", 4,
                             "12 4 2 0 1 20 21 22 23\n", 1)) ==
             ": node 20: expected a corner of every face that it lies in, got it inside "
             "the face of node 1, node 3, node 2");
}

BOOST_AUTO_TEST_CASE(bad_surfaces_are_named_with_their_elements) {
  // Surfaces of no cell, inside the body, or partly so are no error: no plate can be
  // there, and nobody asks for one.
  BOOST_TEST(refusal_of(text("5 5 5 5\n", 1, "12 2 2 7 1 1 2 5\n", 1)) == "no refusal");
  for (const char* faces :
       {"13 2 2 7 1 1 2 3\n14 2 2 7 1 1 2 4\n", "13 2 2 7 1 1 2 3\n14 2 2 7 1 1 3 2\n"})
    BOOST_TEST(refusal_of(text("5 0 0 -1\n", 1,
                               std::string("12 4 2 0 1 1 3 2 5\n") + faces, 3)) ==
               "no refusal");
  BOOST_TEST(refusal_of(text("", 0, "12 2 2 7 1 1 2 3\n13 2 2 7 1 2 3 1\n", 2)) ==
             ": triangle 13 of surface '7': expected each face once, got it twice");
}

BOOST_AUTO_TEST_CASE(numbers_of_groups_are_those_of_gmsh) {
  const auto of_group = [](const std::string& group) {
    return refusal_of(replaced(text(), "11 4 2 0 1", "11 4 2 " + group + " 1"));
  };
  BOOST_TEST(of_group("-2147483647") == "no refusal");
  for (const char* group : {"-2147483648", "2147483648", "-9223372036854775808"}) {
    const std::string message = of_group(group);
    BOOST_TEST(message.find("$Elements: expected a physical group of a number up to 2^31 "
                            "- 1, got " +
                            std::string(group)) != std::string::npos,
               message);
  }
}

BOOST_AUTO_TEST_SUITE_END()
