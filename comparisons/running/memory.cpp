#include "comparisons/running/memory.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "comparisons/system/memory.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

/// Peak memory of the program with one mesh [bytes].
double estimated_mesh_memory(const Body& body) {
  constexpr double program = 165e6, per_cell = 3e3;
  return program + per_cell * estimated_cells(body);
}

void refuse_if_too_large(const std::string& place, const std::string& what,
                         double bytes) {
  const double available = available_memory();
  if (bytes > available)
    throw InputError(
        place, what,
        fmt::format("cells for at most {:.3g} GB, which this process may still take",
                    available / 1e9),
        fmt::format("an estimate of {:.3g} GB", bytes / 1e9));
}

}  // namespace

double estimated_memory(const CaseSettings& settings) {
  std::array<double, 3> nodes = element_nodes(settings);
  std::ranges::sort(nodes);
  const double cells = (nodes[0] - 1) * (nodes[1] - 1) * (nodes[2] - 1);
  const double bytes = estimated_mesh_memory(settings.body);
  const LinearSystems systems = settings.method.linear_systems
                                    ? settings.method.linear_systems(settings)
                                    : LinearSystems{};
  switch (systems.kind) {
    case LinearSystems::Kind::none:
      break;
    case LinearSystems::Kind::multigrid:
      return bytes + settings.elements.element.multigrid_bytes * cells;
    case LinearSystems::Kind::cholesky: {
      // Peak of `run compression`, one method, at 10^3, 20^3, 30^3 cells: 188, 432, 1264
      // MB (mss-cf), 191, 400, 1181 MB (fem-stvk). Fitted: so much per cell for matrices,
      // and a Cholesky factor that grows like nested dissection's, nodes *
      // sqrt(cross-section).
      constexpr double matrices_per_cell = 12.5e3, factor = 740;
      return bytes + systems.coupling * (matrices_per_cell * cells +
                                         factor * nodes[0] * nodes[1] * nodes[2] *
                                             std::sqrt(nodes[0] * nodes[1]));
    }
  }
  return bytes;
}

void check_mesh_memory(const std::string& place, const Body& body) {
  refuse_if_too_large(place, "mesh", estimated_mesh_memory(body));
}

void check_memory(const std::string& place, const std::vector<Request>& requests) {
  for (const Request& request : requests) {
    refuse_if_too_large(place, label(request.settings),
                        estimated_memory(request.settings));
    for (const CaseSettings& reference : reference_cases(request))
      refuse_if_too_large(place,
                          fmt::format("{} on {} cells", label(reference),
                                      fmt::join(reference.body.block.cells, " x ")),
                          estimated_memory(reference));
  }
}

}  // namespace springcheck
