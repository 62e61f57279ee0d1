#include "meshing/files/msh_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "meshing/conformity.hpp"
#include "meshing/files/tagged_cells.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {

Mesh read_msh(const std::filesystem::path& file, double metres_per_unit) {
  if (!(metres_per_unit > 0) || !std::isfinite(metres_per_unit))
    throw InputError(file.string(), "metres per unit", "a positive finite number",
                     fmt::format("{}", metres_per_unit));
  const MshFile msh = parse_msh(file);
  const TaggedCells cells = tagged_cells(file.string(), msh, metres_per_unit);
  const std::vector<CellFace> boundary = checked_boundary(cells);
  Mesh mesh(file.string(), cells.nodes, cells.cells,
            tagged_regions(cells, msh, boundary));
  check_conformity(mesh, [&](NodeIndex node) { return name_of_node(cells, node); });
  return mesh;
}

}  // namespace springcheck
