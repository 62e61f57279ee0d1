#include "meshing/files/mesh_files.hpp"
#include "meshing/basics/output_file.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <sstream>
#include <system_error>

#include "meshing/basics/input_error.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(mesh_files_test)

namespace {

std::vector<std::string> files_in(const OwnFolder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path))
    names.push_back(entry.path().filename().string());
  return names;
}

/// Two cells whose coordinates need all their digits.
Mesh mesh_with_long_decimals() {
  std::vector<Vector3> nodes;
  for (const double z : {0., 1. / 3, 0.1 + 0.7})  // the last is not 0.8
    for (const auto& [x, y] : {std::pair{0., 0.}, {1. / 7, 1e-17}, {0.1, 0.7}, {0., 0.9}})
      nodes.emplace_back(x, y, z);
  return {"long decimals",
          nodes,
          {{0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8, 9, 10, 11}},
          {{"bottom", {{0, 3, 2, 1}}}, {"top", {{8, 9, 10, 11}}}}};
}

/// Numbers between `start` and the next `end`; commas count as spaces.
template <class Number>
std::vector<Number> numbers_between(const std::string& text, const std::string& start,
                                    char end) {
  const std::size_t from = text.find(start);
  BOOST_TEST_REQUIRE(from != std::string::npos, "no " << start);
  const std::size_t begin = from + start.size();
  std::string part = text.substr(begin, text.find(end, begin) - begin);
  std::ranges::replace(part, ',', ' ');
  std::istringstream in(part);
  return {std::istream_iterator<Number>(in), {}};
}

/// Entries of the VTK array whose opening tag ends so.
template <class Number>
std::vector<Number> vtu_array(const std::string& text, const std::string& tag_end) {
  return numbers_between<Number>(text, tag_end + " format=\"ascii\">", '<');
}

}  // namespace

// Bit for bit: shortest decimals that read back as the same double.
BOOST_AUTO_TEST_CASE(vtu_file_reads_back_to_the_same_mesh) {
  const OwnFolder directory;
  const Mesh mesh = mesh_with_long_decimals();
  write_mesh(mesh, directory / "mesh.vtu");
  const std::string text = text_of(directory / "mesh.vtu");

  BOOST_TEST(text.find("<Piece NumberOfPoints=\"12\" NumberOfCells=\"2\">") !=
             std::string::npos);
  std::vector<double> coordinates;
  for (const Vector3& x : mesh.nodes())
    coordinates.insert(coordinates.end(), x.begin(), x.end());
  BOOST_TEST(vtu_array<double>(text, "NumberOfComponents=\"3\"") == coordinates,
             boost::test_tools::per_element());
  BOOST_TEST(vtu_array<int>(text, "Name=\"connectivity\"") ==
                 (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 8, 9, 10, 11}),
             boost::test_tools::per_element());
  BOOST_TEST(vtu_array<int>(text, "Name=\"offsets\"") == (std::vector<int>{8, 16}),
             boost::test_tools::per_element());
  BOOST_TEST(vtu_array<int>(text, "Name=\"types\"") == (std::vector<int>{12, 12}),
             boost::test_tools::per_element());  // VTK_HEXAHEDRON
}

// Bit for bit, and numbered from 1.
BOOST_AUTO_TEST_CASE(inp_file_reads_back_to_the_same_mesh) {
  const OwnFolder directory;
  const Mesh mesh = mesh_with_long_decimals();
  write_mesh(mesh, directory / "mesh.inp");
  const std::string text = text_of(directory / "mesh.inp");

  std::vector<double> nodes;
  for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
    nodes.push_back(static_cast<double>(n + 1));
    nodes.insert(nodes.end(), mesh.nodes()[n].begin(), mesh.nodes()[n].end());
  }
  BOOST_TEST(numbers_between<double>(text, "*NODE, NSET=Nall", '*') == nodes,
             boost::test_tools::per_element());
  BOOST_TEST(numbers_between<int>(text, "*ELEMENT, TYPE=C3D8, ELSET=Eall", '*') ==
                 (std::vector<int>{1, 1, 2, 3, 4, 5, 6, 7, 8,  //
                                   2, 5, 6, 7, 8, 9, 10, 11, 12}),
             boost::test_tools::per_element());
  BOOST_TEST(numbers_between<int>(text, "*NSET, NSET=bottom", '*') ==
                 (std::vector<int>{1, 2, 3, 4}),
             boost::test_tools::per_element());
  BOOST_TEST(numbers_between<int>(text, "*NSET, NSET=top", '*') ==
                 (std::vector<int>{9, 10, 11, 12}),
             boost::test_tools::per_element());
}

// CalculiX reads 20 characters of a number: more would cost the exponent. What fits are
// 14 digits beside a sign, a point and an exponent: off by 5e-14 of the number at most.
BOOST_AUTO_TEST_CASE(inp_file_has_no_number_of_more_than_20_characters) {
  const OwnFolder directory;
  const std::vector<double> z{-1e-4 / 7, 1e-4 / 7, 1e-3 / 7};
  std::vector<Vector3> nodes;
  for (const double height : z)
    for (const auto& [x, y] : {std::pair{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}})
      nodes.emplace_back(x, y, height);
  write_mesh(
      Mesh("thin", nodes, {{0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8, 9, 10, 11}}, {}),
      directory / "mesh.inp");
  const std::string text = text_of(directory / "mesh.inp");
  std::size_t length = 0;
  for (const char c : text.substr(text.find("*NODE, NSET=Nall\n") + 17)) {
    length = c == ',' || c == ' ' || c == '\n' ? 0 : length + 1;
    BOOST_TEST(length <= 20U);
  }
  const auto numbers = numbers_between<double>(text, "*NODE, NSET=Nall", '*');
  BOOST_TEST_REQUIRE(numbers.size() == 48U);
  for (std::size_t n = 0; n < 12; ++n)
    BOOST_TEST(numbers[4 * n + 3] == z[n / 4], boost::test_tools::tolerance(1e-13));
}

// CalculiX numbers the faces of 1-2-3-4, 5-6-7-8: S1 1-2-3-4, S2 5-8-7-6, S3 1-5-6-2,
// S4 2-6-7-3, S5 3-7-8-4, S6 4-8-5-1. The cell with the face need not be the first one.
BOOST_AUTO_TEST_CASE(inp_surfaces_name_the_faces_as_calculix_does) {
  const OwnFolder directory;
  const std::vector<FaceNodes> as_calculix{{0, 3, 2, 1}, {8, 9, 10, 11}, {0, 1, 5, 4},
                                           {1, 2, 6, 5}, {2, 3, 7, 6},   {3, 0, 4, 7}};
  std::map<std::string, std::vector<FaceNodes>> regions;
  for (std::size_t f = 0; f < 6; ++f)
    regions["face" + std::to_string(f + 1)] = {as_calculix[f]};
  const Mesh mesh = mesh_with_long_decimals();
  write_mesh(Mesh("faces", mesh.nodes(), mesh.cells(), regions), directory / "mesh.inp");
  const std::string text = text_of(directory / "mesh.inp");
  for (int f = 1; f <= 6; ++f) {
    const std::string number = std::to_string(f);
    BOOST_TEST(
        text.find("*SURFACE, NAME=face" + number + ", TYPE=ELEMENT\n" +
                  (f == 2 ? "2" : "1") + ", S" + number + "\n") != std::string::npos,
        text);
  }
}

BOOST_AUTO_TEST_CASE(finished_file_replaces_the_old_one_and_leaves_nothing_beside_it) {
  for (const char* name : {"mesh.msh", "mesh.vtu", "mesh.inp"}) {
    const OwnFolder directory;
    std::ofstream(directory / name) << "old";
    write_mesh(mesh_with_long_decimals(), directory / name);
    BOOST_TEST(files_in(directory) == std::vector<std::string>{name},
               boost::test_tools::per_element());
    BOOST_TEST(text_of(directory / name) != "old");
  }
}

BOOST_AUTO_TEST_CASE(unknown_extension_is_refused) {
  const OwnFolder directory;
  const Mesh mesh = mesh_with_long_decimals();
  for (const auto& [name, got] : {std::pair{"mesh.stl", ".stl"}, {"mesh", "none"}}) {
    const std::string message = (directory / name).string() +
                                ": extension: expected .msh, .vtu or .inp, got " + got;
    BOOST_CHECK_EXCEPTION(write_mesh(mesh, directory / name), InputError,
                          [&](const InputError& error) {
                            BOOST_TEST(error.what() == message);
                            return true;
                          });
  }
  BOOST_TEST(files_in(directory).empty());
}

BOOST_AUTO_TEST_CASE(place_that_cannot_be_written_is_reported) {
  const OwnFolder directory;
  const Mesh mesh = mesh_with_long_decimals();
  for (const char* name : {"none/mesh.msh", "none/mesh.vtu", "none/mesh.inp"})
    BOOST_CHECK_EXCEPTION(write_mesh(mesh, directory / name), std::runtime_error,
                          [](const std::runtime_error& error) {
                            return std::string(error.what()).find("mesh.") !=
                                   std::string::npos;
                          });
}

BOOST_AUTO_TEST_CASE(check_writable_leaves_no_trace) {
  const OwnFolder directory;
  check_writable(directory / "new.vtu");
  BOOST_TEST(files_in(directory).empty());
  std::ofstream(directory / "old.vtu") << "old";
  check_writable(directory / "old.vtu");
  BOOST_TEST(text_of(directory / "old.vtu") == "old");
  BOOST_TEST(files_in(directory).size() == 1U);
}

BOOST_AUTO_TEST_CASE(check_writable_refuses_directories_and_missing_ones) {
  const OwnFolder directory;
  const auto refuses = [&](const std::filesystem::path& file, const std::string& got) {
    BOOST_CHECK_EXCEPTION(check_writable(file), InputError, [&](const InputError& error) {
      BOOST_TEST(error.what() ==
                 file.string() + ": expected a file that can be written, got " + got);
      return true;
    });
  };
  refuses(directory / "", "a directory");
  refuses(directory / "none/mesh.vtu", "No such file or directory");
}

BOOST_AUTO_TEST_SUITE_END()
