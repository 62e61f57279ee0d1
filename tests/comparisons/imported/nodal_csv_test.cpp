#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "comparisons/imported/nodal_csv.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tests/comparisons/imported/messages.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(nodal_csv_test)

namespace {

// Two cells of 1 m x 1 m x .5 m: 12 nodes, x first, then y, then z.
const Mesh mesh = generate_block({.size = {1, 1, 1}, .cells = {1, 1, 2}});
const OwnFolder own;
const std::filesystem::path file = own.path / "mine.csv";

std::vector<Vector3> read(const std::string& text, NodalQuantity quantity) {
  write(file, text);
  return read_nodal_csv(file, mesh, quantity);
}

std::string refusal(const std::string& text,
                    NodalQuantity quantity = NodalQuantity::displacement) {
  return message_of(file, [&] { read(text, quantity); });
}

/// Rows of all nodes from the last to the first, u = (n, 2 n, -n) of the n-th.
std::string by_number() {
  std::string text = "node,ux,uy,uz\n";
  for (std::size_t n = mesh.nodes().size(); n > 0; --n) {
    const std::string i = std::to_string(n);
    text += i + "," + i + "," + std::to_string(2 * n) + ",-" + i + "\n";
  }
  return text;
}

}  // namespace

BOOST_AUTO_TEST_CASE(nodes_are_found_by_number_in_any_order) {
  const auto u = read(by_number(), NodalQuantity::displacement);
  BOOST_TEST_REQUIRE(u.size() == 12U);
  for (std::size_t n = 0; n < 12; ++n) {
    const auto i = static_cast<double>(n + 1);
    BOOST_TEST((u[n] == Vector3(i, 2 * i, -i)));
  }
}

// The smallest edge is .5 m, so that points within 5e-7 m are nodes.
BOOST_AUTO_TEST_CASE(nodes_are_found_by_coordinates_to_a_millionth_of_an_edge) {
  std::string text = "\xEF\xBB\xBF# uz, x,y,z,\tux,uy\r\n\r\n";
  for (const Vector3& x : mesh.nodes())
    text += std::to_string(x.z() * 8) + "," + std::to_string(x.x()) + "," +
            std::to_string(x.y()) + "," + std::to_string(x.z()) + "4e-7, +1 ,2\r\n";
  const auto with_digits = [&](const std::string& digits) {
    std::string changed = text;
    for (auto at = changed.find("4e-7"); at != std::string::npos;
         at = changed.find("4e-7", at))
      changed.replace(at, 4, digits);
    return changed;
  };
  const auto u = read(with_digits("4"), NodalQuantity::displacement);  // 4e-7 m
  for (std::size_t n = 0; n < 12; ++n)
    BOOST_TEST((u[n] == Vector3(1, 2, 8 * mesh.nodes()[n].z())));
  BOOST_TEST(refusal(with_digits("6")) ==
             "mine.csv:3: point (0, 0, 6e-07): expected a node of the mesh, within 5e-07 "
             "m, got one that is 6e-07 m from the nearest, node 1 at (0, 0, 0)");
}

BOOST_AUTO_TEST_CASE(nodes_without_a_force_have_none) {
  const auto f = read("node,fx,fy,fz\n12,0,0,-1.5\n", NodalQuantity::force);
  BOOST_TEST((f[11] == Vector3(0, 0, -1.5)));
  for (std::size_t n = 0; n < 11; ++n) BOOST_TEST(f[n].isZero(0));
  BOOST_TEST(
      refusal("node,fx,fy,fz\n", NodalQuantity::force) ==
      "mine.csv: expected a line of column names and at least one row, got no row");
}

// All say u = (n, 2 n, -n) of the n-th node.
BOOST_AUTO_TEST_CASE(files_are_read_as_people_have_them) {
  const auto expected = read(by_number(), NodalQuantity::displacement);
  const auto with_header = [&](const std::string& header) {
    return header + by_number().substr(by_number().find('\n'));
  };
  const auto with_separator = [&](const std::string& text, char separator) {
    std::string changed = text;
    std::ranges::replace(changed, ',', separator);
    return changed;
  };
  std::string quoted = "\"Node\",\"UX\",\"UY\",\"UZ\",\"name\"\n",
              tabs = "\tnode\tux\tuy\tuz\tnote\n";
  std::string more = "# of step 3\nx,Node,UX,UY,UZ,name\n\n",
              decimals = "Node;UX;UY;UZ\n";
  for (int n = 1; n <= 12; ++n) {
    more += fmt::format("7,{0},{0},{1},-{0},\"corner {0}\"\n# of {0}\n", n, 2 * n);
    decimals += fmt::format("{0};{0},0;{1},00;-{0}\n", n, 2 * n);
    quoted += fmt::format("\"{0}\",\"{0}\",\"{1}\",\"-{0}\",\"a, {0}\"\n", n, 2 * n);
    tabs += fmt::format("7\t{0}\t{0}\t{1}\t-{0}\t\n", n, 2 * n);
  }
  for (const std::string& text :
       {with_header("Node,UX,UY,UZ"), with_header("\"node id\",\"Ux [m]\",uy (m),uz"),
        with_header("% ID,UX,UY,UZ"), with_separator(by_number(), ';'),
        with_separator(by_number(), '\t'), with_separator(by_number(), ' '), more,
        decimals, quoted, tabs, "% node, ux, uy, uz\n" + by_number()})
    BOOST_TEST((read(text, NodalQuantity::displacement) == expected), text);
}

// Numbers beside coordinates are those of another program.
BOOST_AUTO_TEST_CASE(coordinates_come_before_numbers) {
  const auto f = read("node,x,y,z,fx,fy,fz\n999,0,0,0,0,0,-1.5\n", NodalQuantity::force);
  BOOST_TEST((f[0] == Vector3(0, 0, -1.5)));
}

BOOST_AUTO_TEST_CASE(wrong_files_are_refused_by_line) {
  const std::string good = by_number();
  BOOST_TEST(refusal(good) == "accepted");
  BOOST_TEST(refusal("") ==
             "mine.csv: expected a line of column names and at least one row, got none");
  for (const char* header :
       {"node,ux,uy", "node,fx,fy,fz", "x,y,ux,uy,uz", "node,ux,uy,uz,UZ", "1,2,3,4",
        "node,id,ux,uy,uz", "node,ux [mm],uy [mm],uz [mm]"})
    BOOST_TEST(refusal(std::string(header) + "\n1,2,3,4\n") ==
               "mine.csv:1: columns: expected x,y,z,ux,uy,uz or node,ux,uy,uz, each "
               "once, got '" +
                   std::string(header) + "'");
  BOOST_TEST(refusal(good + "13,0,0,0\n") ==
             "mine.csv:14: node: expected a number from 1 to 12, the mesh's nodes, got "
             "'13'");
  for (const char* node : {"0", "1.5", "-1", "nan"})
    BOOST_TEST(refusal("node,ux,uy,uz\n" + std::string(node) + ",0,0,0\n")
                   .ends_with("got '" + std::string(node) + "'"));
  BOOST_TEST(refusal(good + "7,0,0,0\n") ==
             "mine.csv:14: displacement of node 7: expected one only, got another one "
             "after mine.csv:7");
  BOOST_TEST(refusal(good.substr(0, good.rfind("2,2,4"))) ==
             "mine.csv: expected a displacement of each of the mesh's 12 nodes, got none "
             "of 2 of them, the first is node 1 at (0, 0, 0)");
  const auto with_row = [](const std::string& row) {
    return refusal("node,ux,uy,uz\n" + row + "\n");
  };
  BOOST_TEST(with_row("1,nan,0,0") ==
             "mine.csv:2: displacement of node 1: expected finite numbers, got (nan, 0, "
             "0)");
  BOOST_TEST(with_row("1,0,inf,0").find("finite") != std::string::npos);
  BOOST_TEST(with_row("1,0,zero,0") == "mine.csv:2: uy: expected a number, got 'zero'");
  BOOST_TEST(with_row("1,0,,0") == "mine.csv:2: uy: expected a number, got ''");
  BOOST_TEST(with_row("1,0,0") == "mine.csv:2: expected 4 values, got 3: '1,0,0'");
  BOOST_TEST(
      message_of(file, [] {
        read_nodal_csv(own.path / "none.csv", mesh, NodalQuantity::force);
      }) == "none.csv: expected a readable CSV file, got No such file or directory");
  BOOST_TEST(message_of(own.path, [] {
               read_nodal_csv(own.path, mesh, NodalQuantity::force);
             }).find("a directory") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
