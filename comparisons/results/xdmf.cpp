#include "comparisons/results/xdmf.hpp"

#include <fmt/format.h>

#include <cmath>

#include "comparisons/results/stored_mesh.hpp"
#include "comparisons/results/xdmf_elements.hpp"
#include "comparisons/store/hdf5.hpp"
#include "comparisons/store/stored_columns.hpp"
#include "meshing/basics/output_file.hpp"

namespace springcheck {
namespace {

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

void append_attribute(pugi::xml_node grid, const std::string& name, const char* type,
                      const char* center, const std::string& dimensions,
                      const std::string& place) {
  append_data_item(
      append_element(grid, "Attribute",
                     {{"Name", name}, {"AttributeType", type}, {"Center", center}}),
      dimensions, place, XdmfNumbers::real);
}

void append_fields(pugi::xml_node grid, hid_t fields, const std::string& in_case,
                   std::size_t nodes, std::size_t cells) {
  const std::string partial = hdf5::has_link(fields, "displacement") ? "" : "partial_";
  for (const auto& [field, unit] : {std::pair{partial + "displacement", "m"},
                                    {partial + "reaction", "N"},
                                    {std::string("deviation"), "m"}})
    if (hdf5::has_link(fields, field))
      append_attribute(grid, fmt::format("{} [{}]", field, unit), "Vector", "Node",
                       fmt::format("{} 3", nodes), in_case + "/" + field);
  for (const std::string& field :
       {partial + "cell_volume_ratio", partial + "spring_strain"})
    if (hdf5::has_link(fields, field))
      append_attribute(grid, field, "Scalar", "Cell", fmt::to_string(cells),
                       in_case + "/" + field);
}

/// A grid for each case that is shown and has fields.
void append_grids(pugi::xml_node domain, const std::string& data, hid_t root,
                  const std::map<std::string, std::string>& shown) {
  const auto meshes = hdf5::open_group(root, "meshes"),
             fields = hdf5::open_group(root, "fields");
  const Columns cases = read_columns(hdf5::open_group(root, "cases"));
  for (std::size_t row = 0; row < cases.rows; ++row) {
    const std::string &key = cases.texts.at("key")[row],
                      &sha256 = cases.texts.at("mesh")[row];
    const auto place = shown.find(key);
    if (place == shown.end() || !hdf5::has_link(fields, key)) continue;
    const auto own_fields = hdf5::open_group(fields, key);
    if (hdf5::links(own_fields).empty()) continue;
    std::string name = grid_name(cases, row);
    if (!place->second.empty()) name += " of revision " + place->second;
    const pugi::xml_node grid = append_element(domain, "Grid", {{"Name", name}});
    const auto mesh = hdf5::open_group(meshes, sha256);
    append_xdmf_mesh(grid, mesh, fmt::format("{}:/meshes/{}", data, sha256));
    append_fields(grid, own_fields, fmt::format("{}:/fields/{}", data, key),
                  hdf5::row_count_of_table(mesh, "nodes"), stored_cell_count(mesh));
  }
}

}  // namespace

void write_xdmf(const std::filesystem::path& file, const std::string& data, hid_t root,
                const std::map<std::string, std::string>& cases) {
  pugi::xml_document document;
  pugi::xml_node xdmf = append_element(document, "Xdmf", {{"Version", "3.0"}});
  append_grids(xdmf.append_child("Domain"), data, root, cases);
  write_whole_stream(file, [&](std::ostream& out) { document.save(out, ""); });
}

}  // namespace springcheck
