#include "meshing/files/mesh_files.hpp"

#include <algorithm>
#include <string>

#include "meshing/basics/input_error.hpp"
#include "meshing/basics/output_file.hpp"
#include "meshing/basics/text.hpp"
#include "meshing/files/inp_writer.hpp"
#include "meshing/files/msh_writer.hpp"
#include "meshing/files/vtu_writer.hpp"

namespace springcheck {

namespace {

void check_for_calculix(const Mesh& mesh, const std::filesystem::path& file) {
  constexpr std::size_t longest_name = 80;
  if (const std::size_t pyramids = mesh.count(CellType::pyramid); pyramids > 0)
    throw InputError(file.string(), "pyramids", "none, as CalculiX has no such cells",
                     std::to_string(pyramids));
  for (const auto& [name, region] : mesh.regions()) {
    const bool is_plain = std::ranges::all_of(name, [](char c) {
      return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
             c == '_' || c == '-' || c == '.';
    });
    if (!is_plain || name.size() > longest_name)
      throw InputError(file.string(), "name of a region",
                       "what CalculiX takes: up to 80 letters, digits, '_', '-', '.'",
                       quotation(name));
  }
}

}  // namespace

void write_mesh(const Mesh& mesh, const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".inp") check_for_calculix(mesh, file);
  if (extension == ".msh")
    write_whole_stream(file, [&](std::ostream& out) { write_msh(mesh, out); });
  else if (extension == ".vtu")
    write_whole_stream(file, [&](std::ostream& out) { write_vtu(mesh, out); });
  else if (extension == ".inp")
    write_whole_stream(file, [&](std::ostream& out) { write_inp(mesh, out); });
  else
    throw InputError(file.string(), "extension", ".msh, .vtu or .inp",
                     extension.empty() ? "none" : extension);
}

}  // namespace springcheck
