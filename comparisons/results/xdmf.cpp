#include "comparisons/results/xdmf.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <cmath>

#include "comparisons/results/stored_mesh.hpp"
#include "comparisons/store/columns.hpp"
#include "comparisons/store/hdf5.hpp"
#include "meshing/output_file.hpp"

namespace springcheck {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  return out;
}

/// "compression fem-stvk:q1 nu=0.25 deformation=0.05 0123abcd".
std::string grid_name(const Columns& cases, std::size_t row) {
  const auto text = [&](const char* name) {
    const auto column = cases.texts.find(name);
    return column == cases.texts.end() ? std::string() : column->second[row];
  };
  std::string name = text("scene") + " " + text("method");
  if (!text("element").empty()) name += fmt::format(":{}", text("element"));
  for (const char* key : {"nu", "deformation"})
    if (const auto column = cases.numbers.find(key);
        column != cases.numbers.end() && !std::isnan(column->second.values[row]))
      name += fmt::format(" {}={:g}", key, column->second.values[row]);
  return name + " " + text("key").substr(0, 8);
}

void write_grids(std::ostream& out, const std::string& data, hid_t root,
                 const std::map<std::string, std::string>& shown) {
  fmt::print(out, "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n");
  const auto meshes = hdf5::open_group(root, "meshes"),
             fields = hdf5::open_group(root, "fields");
  const Columns cases = read_columns(hdf5::open_group(root, "cases"));
  for (std::size_t row = 0; row < cases.rows; ++row) {
    const std::string &key = cases.texts.at("key")[row],
                      &sha256 = cases.texts.at("mesh")[row];
    const auto place = shown.find(key);
    if (place == shown.end() || !hdf5::has_link(fields, key)) continue;
    const std::string& revision = place->second;
    const auto mesh = hdf5::open_group(meshes, sha256);
    const std::size_t nodes = hdf5::row_count_of_table(mesh, "nodes"),
                      cells = stored_cell_count(mesh);
    const std::string in_mesh = fmt::format("{}:/meshes/{}", data, sha256);
    const std::string in_case = fmt::format("{}:/fields/{}", data, key);
    const auto arrays = hdf5::open_group(fields, key);
    const std::string partial = hdf5::has_link(arrays, "displacement") ? "" : "partial_";
    fmt::print(out, "<Grid Name=\"{}{}\">\n", escaped(grid_name(cases, row)),
               revision.empty() ? "" : " of revision " + escaped(revision));
    write_xdmf_mesh(out, mesh, in_mesh);
    for (const auto& [field, unit] : {std::pair{partial + "displacement", "m"},
                                      {partial + "reaction", "N"},
                                      {std::string("deviation"), "m"}})
      if (hdf5::has_link(arrays, field))
        fmt::print(
            out,
            "<Attribute Name=\"{0} [{3}]\" AttributeType=\"Vector\" Center=\"Node\">"
            "<DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" "
            "Dimensions=\"{1} 3\">{2}/{0}</DataItem></Attribute>\n",
            field, nodes, in_case, unit);
    for (const std::string& field :
         {partial + "cell_volume_ratio", partial + "spring_strain"})
      if (hdf5::has_link(arrays, field))
        fmt::print(out,
                   "<Attribute Name=\"{0}\" AttributeType=\"Scalar\" Center=\"Cell\">"
                   "<DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" "
                   "Dimensions=\"{1}\">{2}/{0}</DataItem></Attribute>\n",
                   field, cells, in_case);
    fmt::print(out, "</Grid>\n");
  }
  fmt::print(out, "</Domain>\n</Xdmf>\n");
}

}  // namespace

void write_xdmf(const std::filesystem::path& file, const std::string& data, hid_t root,
                const std::map<std::string, std::string>& cases) {
  write_whole_stream(
      file, [&](std::ostream& out) { write_grids(out, escaped(data), root, cases); });
}

}  // namespace springcheck
