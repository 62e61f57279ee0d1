#include "fem_reference/statics/coverage.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace springcheck::fem_reference {

std::optional<std::string> reason_to_refuse(const Mesh& mesh, const Scene& scene,
                                            const Settings& settings) {
  const CellType first = type_of(mesh.cells().front());  // hexahedra are the last
  if (settings.element == Element::q2 && first != CellType::hexahedron)
    return fmt::format("q2 is for hexahedra; cells of type {} in the mesh: {}",
                       name_of(first), mesh.count(first));
  for (const Plate& plate : scene.plates)
    if (settings.law == Law::hooke && std::abs(plate.motion.angle) > std::numbers::pi)
      return "Hooke's law of small strains sees where a plate ends, not the way there: "
             "beyond half a turn that is a smaller one";
  const bool baudet =
      settings.law == Law::cauchy_born && settings.lattice.springs == Springs::baudet;
  const double nu = scene.material.poisson_ratio;
  if (baudet && !(nu > -0.25))
    return fmt::format(
        "the edge springs of the mss-baudet lattice are negative for nu <= -0.25; got {}",
        nu);
  return std::nullopt;
}

}  // namespace springcheck::fem_reference
