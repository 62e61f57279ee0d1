#include "meshing/files/msh_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <cmath>

#include "meshing/basics/input_error.hpp"
#include "meshing/conformity.hpp"
#include "meshing/files/tagged_cells.hpp"

namespace springcheck {

Mesh read_msh(const std::filesystem::path& file, double metres_per_unit) {
  if (!(metres_per_unit > 0) || !std::isfinite(metres_per_unit))
    throw InputError(file.string(), "metres per unit", "a positive finite number",
                     fmt::format("{}", metres_per_unit));
  const MshFile msh = parse_msh(file);
  const TaggedCells cells = tagged_cells(file.string(), msh, metres_per_unit);
  TaggedSurfaces surfaces = tagged_surfaces(cells, msh, checked_boundary(cells));
  Mesh mesh(file.string(), cells.nodes, cells.cells, std::move(surfaces.regions),
            std::move(surfaces.elsewhere));
  check_conformity(mesh, [&](NodeIndex node) { return name_of_node(cells, node); });
  if (const std::set<std::string> volumes = volumes_apart(msh); !volumes.empty())
    spdlog::warn("{}: the physical volumes {} become one body of one material",
                 file.string(), fmt::join(volumes, ", "));
  return mesh;
}

}  // namespace springcheck
