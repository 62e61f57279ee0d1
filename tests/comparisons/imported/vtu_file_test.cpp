#include <zlib.h>

#include <boost/test/unit_test.hpp>
#include <cstring>
#include <sstream>

#include "comparisons/imported/vtk_numbers.hpp"
#include "comparisons/imported/vtu_file.hpp"
#include "meshing/files/mesh_files.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tests/comparisons/imported/messages.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(vtu_file_test)

namespace {

const Mesh mesh = generate_block({.size = {1, 1, 2}, .cells = {1, 1, 2}});  // 12 nodes
const OwnFolder own;
const std::filesystem::path file = own.path / "mine.vtu";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

const std::string array_of = "<DataArray type=\"Float64\" format=\"ascii\" ";

/// u = (x/2, y/4, -z/8) as PointData.
std::string displacement_array(const std::string& name) {
  std::ostringstream text;
  text << array_of << "NumberOfComponents=\"3\" Name=\"" << name << "\">\n";
  for (const Vector3& x : mesh.nodes())
    text << x.x() / 2 << " " << x.y() / 4 << " " << -x.z() / 8 << "\n";
  return text.str() + "</DataArray>\n";
}

/// The mesh as springcheck writes it, with these arrays of PointData.
std::string with_point_data(const std::string& arrays) {
  write_mesh(mesh, file);
  return replaced(text_of(file), "</Points>\n",
                  "</Points>\n<PointData>\n" + arrays + "</PointData>\n");
}

void expect_the_field(const std::filesystem::path& path) {
  const auto u = read_vtu_displacements(path, mesh);
  BOOST_TEST_REQUIRE(u.size() == 12U);
  for (std::size_t n = 0; n < 12; ++n) {
    const Vector3& x = mesh.nodes()[n];
    BOOST_TEST((u[n] == Vector3(x.x() / 2, x.y() / 4, -x.z() / 8)));  // exact in binary
  }
}

std::string refusal(const std::string& text) {
  write(file, text);
  return message_of(file, [] { read_vtu_displacements(file, mesh); });
}

std::string to_base64(std::string bytes) {
  constexpr const char* digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.append(padding, '\0');
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t j = 0; j < 3; ++j)
      bits = bits << 8 | static_cast<unsigned char>(bytes[i + j]);
    for (int shift = 18; shift >= 0; shift -= 6) text += digits[bits >> shift & 63];
  }
  return text.replace(text.size() - padding, padding, padding, '=');
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

/// The bytes as VTK compresses them: a header, then blocks.
std::string compressed(const std::string& bytes, std::size_t block) {
  std::vector<std::uint64_t> header{(bytes.size() + block - 1) / block, block,
                                    bytes.size() % block};
  std::string blocks;
  for (std::size_t at = 0; at < bytes.size(); at += block) {
    const std::string part = bytes.substr(at, block);
    std::string packed(compressBound(part.size()), '\0');
    uLongf size = packed.size();
    compress(reinterpret_cast<Bytef*>(packed.data()), &size,
             reinterpret_cast<const Bytef*>(part.data()), part.size());
    header.push_back(size);
    blocks += packed.substr(0, size);
  }
  return to_base64(bytes_of(header)) + "\n" + to_base64(blocks);
}

constexpr VtkEncoding zlib{.format = VtkEncoding::Format::base64,
                           .compression = VtkEncoding::Compression::zlib,
                           .header_bytes = 8,
                           .type = VtkReal::float64};

}  // namespace

BOOST_AUTO_TEST_CASE(our_own_mesh_with_a_displacement_is_read) {
  write(file, with_point_data(displacement_array("displacement")));
  expect_the_field(file);
  write(file, with_point_data(displacement_array("a") +
                              displacement_array("displacement [m]")));
  expect_the_field(file);
  // Of several arrays the one with the right name is taken, of a single one that one,
  // whatever its name.
  write(file, with_point_data(displacement_array("a") + displacement_array("b") +
                              displacement_array("displacement")));
  expect_the_field(file);
  write(file, with_point_data(displacement_array("u") + array_of +
                              "Name=\"p\">1 2 3</DataArray>\n"));
  expect_the_field(file);
}

// The files were written by meshio: base64 without compression, zlib, and zlib of 32-bit
// numbers.
BOOST_AUTO_TEST_CASE(files_of_meshio_are_read) {
  for (const char* name : {"meshio_plain.vtu", "meshio_zlib.vtu", "meshio_float32.vtu"})
    expect_the_field(std::filesystem::path("tests/comparisons/imported") / name);
}

// 36 bytes are cut in the middle of a number; 40 divide 4000 without a rest, which VTK
// writes as a last block of 0 bytes.
BOOST_AUTO_TEST_CASE(compressed_blocks_of_any_size_are_put_together) {
  std::vector<double> numbers;
  for (int i = 0; i < 500; ++i) numbers.push_back(1. / (i + 1));
  for (const std::size_t block : {36U, 40U, 4000U, 32768U})
    BOOST_TEST(
        vtk_numbers("x", compressed(bytes_of(numbers), block), zlib, 500) == numbers,
        boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(broken_binary_data_is_refused) {
  const auto refusal_of = [](const std::string& text, const VtkEncoding& encoding) {
    return message_of("", [&] { vtk_numbers("x", text, encoding, 4); });
  };
  VtkEncoding plain = zlib;
  plain.compression = VtkEncoding::Compression::none;
  const std::string four = bytes_of(std::vector<double>{1, 2, 3, 4});
  const auto with_size = [&](std::uint64_t size) {
    return to_base64(bytes_of(std::vector{size}) + four);
  };
  BOOST_TEST(refusal_of(with_size(32), plain) == "accepted");
  BOOST_TEST(refusal_of(with_size(24), plain) == "x: expected 4 numbers, got 3");
  BOOST_TEST(refusal_of(with_size(1ULL << 63), plain) ==
             "x: expected 9223372036854775808 more bytes, got the end after 32");
  BOOST_TEST(refusal_of("AAA$", plain) == "x: expected base64, got the character '$'");
  BOOST_TEST(refusal_of("AAAAA", plain) ==
             "x: expected base64 in groups of four, got 'A' at the end");
  BOOST_TEST(refusal_of("", plain) == "x: expected 8 more bytes, got the end after 0");
  BOOST_TEST(refusal_of(compressed(four, 16), zlib) == "accepted");
  BOOST_TEST(refusal_of(compressed(four + four, 16), zlib) ==
             "x: expected 32 bytes, got 4 blocks of 16, the last of 16");
  for (const std::vector<std::uint64_t>& header : std::vector<std::vector<std::uint64_t>>{
           {0, 0, 0}, {1ULL << 63, 2, 2}, {2, 1ULL << 63, 32}, {1, 32, 1ULL << 63}})
    BOOST_TEST(refusal_of(to_base64(bytes_of(header)), zlib)
                   .starts_with("x: expected 32 bytes, got "));
  BOOST_TEST(refusal_of(to_base64(bytes_of(std::vector<std::uint64_t>{1, 32, 32, 8})) +
                            to_base64("no zlib!"),
                        zlib) ==
             "x: expected 32 bytes of zlib in block 1, got broken data");
}

BOOST_AUTO_TEST_CASE(wrong_files_are_refused_with_what_is_wrong) {
  const std::string good = with_point_data(displacement_array("displacement"));
  BOOST_TEST(refusal(good) == "accepted");
  BOOST_TEST(refusal("").starts_with("mine.vtu:"));
  BOOST_TEST(refusal("<VTKFile").starts_with("mine.vtu:1: expected XML"));
  BOOST_TEST(refusal("<html></html>") ==
             "mine.vtu: expected a VTKFile of type UnstructuredGrid, got none");
  BOOST_TEST(
      refusal(replaced(good, "\"UnstructuredGrid\"", "\"PolyData\"")) ==
      "mine.vtu: expected a VTKFile of type UnstructuredGrid, got type 'PolyData'");
  BOOST_TEST(
      refusal("<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid/></VTKFile>") ==
      "mine.vtu: expected one Piece, got 0");
  BOOST_TEST(refusal(replaced(good, "NumberOfPoints=\"12\"", "NumberOfPoints=\"27\"")) ==
             "mine.vtu: NumberOfPoints: expected 12, the mesh's nodes, got '27'");
  BOOST_TEST(refusal(with_point_data("")) ==
             "mine.vtu: PointData: expected an array named 'displacement', or one only, "
             "of three components, got none");
  BOOST_TEST(
      refusal(with_point_data(displacement_array("u") + displacement_array("v"))) ==
      "mine.vtu: PointData: expected an array named 'displacement', or one only, "
      "of three components, got 'u', 'v'");
  BOOST_TEST(refusal(replaced(good, "0.5 0 -0", "0.5 nan 0")) ==
             "mine.vtu: point 1 (from 0): displacement of node 2: expected finite "
             "numbers, got (0.5, nan, 0)");
  BOOST_TEST(refusal(replaced(good, "0.5 0 -0", "0.5 0")) ==
             "mine.vtu: array 'displacement': expected 36 numbers, got 35");
  BOOST_TEST(refusal(replaced(good, "0.5 0 -0", "0.5 0 x")) ==
             "mine.vtu: array 'displacement': expected numbers, got 'x'");
  BOOST_TEST(refusal(replaced(good, "\n1 0 0\n", "\n0 0 0\n")) ==
             "mine.vtu: point 1 (from 0): displacement of node 1: expected one only, got "
             "another one after mine.vtu: point 0 (from 0)");
  BOOST_TEST(refusal(replaced(good, "\n1 0 0\n", "\n1.25 0 0\n")) ==
             "mine.vtu: point 1 (from 0): point (1.25, 0, 0): expected a node of the "
             "mesh, within 1e-06 m, got one that is 0.25 m from the nearest, node 2 at "
             "(1, 0, 0)");
  BOOST_TEST(refusal(replaced(good, "format=\"ascii\" NumberOf",
                              "format=\"appended\" "
                              "NumberOf"))
                 .find("the data inline, got 'appended'") != std::string::npos);
  const std::string binary =
      replaced(good, "format=\"ascii\" NumberOf", "format=\"binary\" NumberOf");
  for (const char* attribute :
       {"byte_order=\"BigEndian\"", "compressor=\"vtkLZ4DataCompressor\"",
        "header_type=\"Int8\""})
    BOOST_TEST(
        refusal(replaced(binary, "<VTKFile ", "<VTKFile " + std::string(attribute) + " "))
            .find("got '") != std::string::npos);
}

// 32-bit numbers of 1.7 m are off by up to 1e-7 m, beside the 1e-6 m that all may be.
BOOST_AUTO_TEST_CASE(points_of_32_bits_may_be_off_by_their_rounding) {
  const std::string good = with_point_data(displacement_array("displacement")),
                    off = replaced(good, "\n1 1 2\n", "\n1 1 2.00000115\n");
  BOOST_TEST(refusal(off).find("1.15e-06 m from the nearest") != std::string::npos);
  BOOST_TEST(refusal(replaced(off, "<Points>\n<DataArray type=\"Float64\"",
                              "<Points>\n<DataArray type=\"Float32\"")) == "accepted");
}

BOOST_AUTO_TEST_CASE(elements_are_nested_as_deep_as_they_like) {
  std::string nested;
  for (int i = 0; i < 200'000; ++i) nested += "<a>";
  for (int i = 0; i < 200'000; ++i) nested += "</a>";
  write(file, with_point_data(displacement_array("displacement") + nested));
  expect_the_field(file);
  for (const char* before : {"", "<?x ' ?>\n", "<!DOCTYPE x>\n", "<!-- ' -->\n"})
    BOOST_TEST(refusal(before + ("<VTKFile>\n" + nested) + "</VTKFile>\n") ==
               "mine.vtu: expected a VTKFile of type UnstructuredGrid, got type ''");
}

BOOST_AUTO_TEST_CASE(comments_between_numbers_are_none) {
  const std::string good = with_point_data(displacement_array("displacement"));
  write(file, replaced(good, "\n1 1 2\n", "\n1 1 <!-- the top --> 2\n"));
  expect_the_field(file);
}

BOOST_AUTO_TEST_SUITE_END()
