#include "comparisons/imported/vtu_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <string_view>

#include "comparisons/imported/nodal_vectors.hpp"
#include "comparisons/imported/vtk_numbers.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

std::string attribute(pugi::xml_node element, const char* name) {
  return element.attribute(name).value();
}

/// All text of an element, which comments may part.
std::string text_in(pugi::xml_node element) {
  std::string text;
  for (const pugi::xml_node part : element.children()) text += part.value();
  return text;
}

/// A vtu file: its name for messages, the element that all is in, and what that says.
class VtuFile {
 public:
  explicit VtuFile(const std::filesystem::path& file) : name_(file.string()) {
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file)) refuse("", "a readable file", "none");
    std::stringstream content;
    content << in.rdbuf();
    const std::string text = content.str();
    const auto parsed = document_.load_buffer(text.data(), text.size(),
                                              pugi::parse_default, pugi::encoding_utf8);
    if (!parsed)
      throw InputError(
          fmt::format("{}:{}", name_,
                      1 + std::count(text.begin(), text.begin() + parsed.offset, '\n')),
          "", "XML; binary data inline as base64, not appended raw",
          static_cast<std::size_t>(parsed.offset) >= text.size() ? "the end of the file"
                                                                 : parsed.description());
    root_ = document_.child("VTKFile");
    if (attribute(root_, "type") != "UnstructuredGrid")
      refuse("", "a VTKFile of type UnstructuredGrid",
             root_ ? "type '" + attribute(root_, "type") + "'" : "none");
  }

  [[noreturn]] void refuse(const std::string& entity, const std::string& expected,
                           const std::string& got) const {
    throw InputError(name_, entity, expected, got);
  }

  [[nodiscard]] const std::string& name() const { return name_; }

  /// The only piece of the grid.
  [[nodiscard]] pugi::xml_node piece() const {
    const auto pieces = root_.child("UnstructuredGrid").children("Piece");
    const auto count = std::distance(pieces.begin(), pieces.end());
    if (count != 1) refuse("", "one Piece", fmt::to_string(count));
    return *pieces.begin();
  }

  /// Encoding of an array's data.
  [[nodiscard]] VtkEncoding encoding(pugi::xml_node array,
                                     const std::string& entity) const {
    const std::string format = attribute(array, "format"),
                      type = attribute(array, "type"),
                      compressor = attribute(root_, "compressor"),
                      order = attribute(root_, "byte_order"),
                      header = attribute(root_, "header_type");
    if (format != "ascii" && format != "binary")
      refuse(entity, "format 'ascii' or 'binary', the data inline", "'" + format + "'");
    if (type != "Float32" && type != "Float64")
      refuse(entity, "type Float32 or Float64", "'" + type + "'");
    if (format == "binary") {
      if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
        refuse("compressor", "vtkZLibDataCompressor or none", "'" + compressor + "'");
      if (!order.empty() && order != "LittleEndian")
        refuse("byte_order", "LittleEndian", "'" + order + "'");
      if (!header.empty() && header != "UInt32" && header != "UInt64")
        refuse("header_type", "UInt32 or UInt64", "'" + header + "'");
    }
    using enum VtkEncoding::Format;
    using Compression = VtkEncoding::Compression;
    return {.format = format == "ascii" ? ascii : base64,
            .compression = compressor.empty() ? Compression::none : Compression::zlib,
            .header_bytes = header == "UInt64" ? 8U : 4U,
            .type = type == "Float32" ? VtkReal::float32 : VtkReal::float64};
  }

  /// Three numbers for each point.
  [[nodiscard]] std::vector<Vector3> vectors(pugi::xml_node array,
                                             const std::string& entity,
                                             std::size_t points) const {
    const std::vector<double> numbers = vtk_numbers(name_ + ": " + entity, text_in(array),
                                                    encoding(array, entity), 3 * points);
    std::vector<Vector3> vectors;
    for (std::size_t i = 0; i < points; ++i)
      vectors.emplace_back(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    return vectors;
  }

 private:
  std::string name_;
  pugi::xml_document document_;
  pugi::xml_node root_;
};

bool has_three_components(pugi::xml_node array) {
  return attribute(array, "NumberOfComponents") == "3";
}

/// The array of displacements in PointData.
pugi::xml_node displacement_array(const VtuFile& file, pugi::xml_node piece) {
  std::vector<pugi::xml_node> vectors;
  std::vector<std::string> names;
  for (const pugi::xml_node array : piece.child("PointData").children("DataArray")) {
    if (!has_three_components(array)) continue;
    const std::string name = attribute(array, "Name");
    if (name == "displacement" || name == "displacement [m]") return array;
    vectors.push_back(array);
    names.push_back("'" + name + "'");
  }
  if (vectors.size() != 1)
    file.refuse("PointData",
                "an array named 'displacement', or one only, of three components",
                vectors.empty() ? "none" : fmt::to_string(fmt::join(names, ", ")));
  return vectors.front();
}

}  // namespace

std::vector<Vector3> read_vtu_displacements(const std::filesystem::path& file,
                                            const Mesh& mesh) {
  const VtuFile vtu(file);
  const pugi::xml_node piece = vtu.piece();
  const std::size_t nodes = mesh.nodes().size();
  if (const std::string points = attribute(piece, "NumberOfPoints");
      points != std::to_string(nodes))
    vtu.refuse("NumberOfPoints", fmt::format("{}, the mesh's nodes", nodes),
               "'" + points + "'");
  const pugi::xml_node coordinates = piece.child("Points").child("DataArray");
  if (!has_three_components(coordinates))
    vtu.refuse("Points", "a DataArray of three components", "none");
  const std::vector<Vector3> points = vtu.vectors(coordinates, "Points", nodes);
  pugi::xml_node array = displacement_array(vtu, piece);
  const std::vector<Vector3> displacements =
      vtu.vectors(array, fmt::format("array '{}'", attribute(array, "Name")), nodes);
  const bool is_rounded = attribute(coordinates, "type") == "Float32";
  const double relative = is_rounded ? std::numeric_limits<float>::epsilon() : 0;

  NodalVectors vectors(mesh, "displacement");
  for (std::size_t i = 0; i < nodes; ++i)
    vectors.add_at(fmt::format("{}: point {} (from 0)", vtu.name(), i), points[i],
                   relative * points[i].norm(), displacements[i]);
  return vectors.complete(vtu.name());
}

}  // namespace springcheck
