#include "comparisons/imported/vtu_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>

#include "comparisons/imported/nodal_vectors.hpp"
#include "comparisons/imported/vtk_numbers.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

using Tree = boost::property_tree::ptree;

std::string attribute(const Tree& element, const std::string& name) {
  return element.get("<xmlattr>." + name, "");
}

/// Boost's parser calls itself for each element in an element, and some 10,000 overrun
/// the stack. Elements are no deeper than there are "<", of which a grid's arrays need a
/// few hundred. Throws InputError where there are more than it could ever stand.
void check_nesting(const std::string& name, std::string_view text) {
  constexpr std::ptrdiff_t most = 6000;
  if (const auto count = std::ranges::count(text, '<'); count > most)
    throw InputError(name, "",
                     fmt::format("at most {} times '<', as of VTK's tags", most),
                     fmt::to_string(count));
}

/// A vtu file: its name for messages, the element that all is in, and what that says.
class VtuFile {
 public:
  explicit VtuFile(const std::filesystem::path& file) : name_(file.string()) {
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file)) refuse("", "a readable file", "none");
    std::stringstream content;
    content << in.rdbuf();
    check_nesting(name_, content.view());
    try {
      read_xml(content, tree_);
    } catch (const boost::property_tree::xml_parser_error& error) {
      throw InputError(fmt::format("{}:{}", name_, error.line()), "",
                       "XML; binary data inline as base64, not appended raw",
                       error.message());
    }
    const auto root = tree_.get_child_optional("VTKFile");
    if (!root || attribute(*root, "type") != "UnstructuredGrid")
      refuse("", "a VTKFile of type UnstructuredGrid",
             root ? "type '" + attribute(*root, "type") + "'" : "none");
    root_ = &*root;
  }

  [[noreturn]] void refuse(const std::string& entity, const std::string& expected,
                           const std::string& got) const {
    throw InputError(name_, entity, expected, got);
  }

  [[nodiscard]] const std::string& name() const { return name_; }

  /// The only piece of the grid.
  [[nodiscard]] const Tree& piece() const {
    const Tree empty;
    const std::size_t count = root_->get_child("UnstructuredGrid", empty).count("Piece");
    if (count != 1) refuse("", "one Piece", fmt::to_string(count));
    return root_->get_child("UnstructuredGrid.Piece");
  }

  /// Encoding of an array's data.
  [[nodiscard]] VtkEncoding encoding(const Tree& array, const std::string& entity) const {
    const std::string format = attribute(array, "format"),
                      type = attribute(array, "type"),
                      compressor = attribute(*root_, "compressor"),
                      order = attribute(*root_, "byte_order"),
                      header = attribute(*root_, "header_type");
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
  [[nodiscard]] std::vector<Vector3> vectors(const Tree& array, const std::string& entity,
                                             std::size_t points) const {
    const std::vector<double> numbers = vtk_numbers(name_ + ": " + entity, array.data(),
                                                    encoding(array, entity), 3 * points);
    std::vector<Vector3> vectors;
    for (std::size_t i = 0; i < points; ++i)
      vectors.emplace_back(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    return vectors;
  }

 private:
  std::string name_;
  Tree tree_;
  const Tree* root_;
};

bool has_three_components(const Tree& array) {
  return attribute(array, "NumberOfComponents") == "3";
}

/// The array of displacements in PointData.
const Tree& displacement_array(const VtuFile& file, const Tree& piece) {
  std::vector<const Tree*> vectors;
  std::string names;
  if (const auto data = piece.get_child_optional("PointData"))
    for (const auto& [tag, array] : *data) {
      if (tag != "DataArray" || !has_three_components(array)) continue;
      const std::string name = attribute(array, "Name");
      if (name == "displacement" || name == "displacement [m]") return array;
      vectors.push_back(&array);
      names += (names.empty() ? "'" : ", '") + name + "'";
    }
  if (vectors.size() != 1)
    file.refuse("PointData",
                "an array named 'displacement', or one only, of three components",
                vectors.empty() ? "none" : names);
  return *vectors.front();
}

}  // namespace

std::vector<Vector3> read_vtu_displacements(const std::filesystem::path& file,
                                            const Mesh& mesh) {
  const VtuFile vtu(file);
  const Tree& piece = vtu.piece();
  const std::size_t nodes = mesh.nodes().size();
  if (const std::string points = attribute(piece, "NumberOfPoints");
      points != std::to_string(nodes))
    vtu.refuse("NumberOfPoints", fmt::format("{}, the mesh's nodes", nodes),
               "'" + points + "'");
  const auto coordinates = piece.get_child_optional("Points.DataArray");
  if (!coordinates || !has_three_components(*coordinates))
    vtu.refuse("Points", "a DataArray of three components", "none");
  const std::vector<Vector3> points = vtu.vectors(*coordinates, "Points", nodes);
  const Tree& array = displacement_array(vtu, piece);
  const std::vector<Vector3> displacements =
      vtu.vectors(array, fmt::format("array '{}'", attribute(array, "Name")), nodes);
  const bool is_rounded = attribute(*coordinates, "type") == "Float32";
  const double relative = is_rounded ? std::numeric_limits<float>::epsilon() : 0;

  NodalVectors vectors(mesh, "displacement");
  for (std::size_t i = 0; i < nodes; ++i)
    vectors.add_at(fmt::format("{}: point {} (from 0)", vtu.name(), i), points[i],
                   relative * points[i].norm(), displacements[i]);
  return vectors.complete(vtu.name());
}

}  // namespace springcheck
