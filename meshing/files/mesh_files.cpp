#include "meshing/files/mesh_files.hpp"

#include <string>

#include "meshing/files/inp_writer.hpp"
#include "meshing/files/msh_writer.hpp"
#include "meshing/files/vtu_writer.hpp"
#include "meshing/input_error.hpp"
#include "meshing/output_file.hpp"

namespace springcheck {

void write_mesh(const Mesh& mesh, const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  const std::size_t pyramids = mesh.count(CellType::pyramid);
  if (extension == ".inp" && pyramids > 0)
    throw InputError(file.string(), "pyramids", "none, as CalculiX has no such cells",
                     std::to_string(pyramids));
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
