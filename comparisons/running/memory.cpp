#include "comparisons/running/memory.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "comparisons/system/memory.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

/// Peak memory of the program with one mesh [bytes].
double estimated_mesh_memory(const Body& body) {
  constexpr double program = 165e6, per_cell = 3e3;
  return program + per_cell * estimated_cells(body);
}

void refuse_if_too_large(const std::string& place, const std::string& what, double bytes,
                         double available) {
  if (bytes > available)
    throw InputError(
        place, what,
        fmt::format("cells for at most {:.3g} GB, which this process may still take",
                    available / 1e9),
        fmt::format("an estimate of {:.3g} GB", bytes / 1e9));
}

/// Eigen, CHOLMOD and Trilinos count a matrix's entries by 32 bits.
void refuse_if_uncountable(const std::string& place, const std::string& what,
                           const CaseSettings& settings) {
  if (!settings.method.linear_systems) return;
  constexpr double most = std::numeric_limits<std::int32_t>::max();
  const auto [nx, ny, nz] = element_nodes(settings);
  const double entries =
      settings.method.linear_systems(settings).entries_per_node * nx * ny * nz;
  if (entries > most)
    throw InputError(place, what,
                     fmt::format("a matrix of at most {:.3g} entries, which the solvers "
                                 "can count",
                                 most),
                     fmt::format("an estimate of {:.3g}", entries));
}

void check_case(const std::string& place, const std::string& what,
                const CaseSettings& settings, double available) {
  refuse_if_uncountable(place, what, settings);
  refuse_if_too_large(place, what, estimated_memory(settings), available);
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
    case LinearSystems::Kind::conjugate_gradients: {
      // A matrix, and vectors and what it is assembled from, which take as much at most.
      // Peaks at 20^3 cells: 199 MB (q1-sri), 267 (q1-nodal), 274 (mss-affine, nu = .4);
      // at 46^3 755 (mss-cf); of q2 at 12^3 261.
      constexpr double per_entry = 16;
      return bytes + per_entry * systems.entries_per_node * cells;
    }
    case LinearSystems::Kind::multigrid:
      return bytes + systems.multigrid_bytes * cells;
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

bool fits_in_memory(const CaseSettings& settings) {
  return estimated_memory(settings) <= available_memory();
}

void check_mesh_memory(const std::string& place, const Body& body) {
  refuse_if_too_large(place, "mesh", estimated_mesh_memory(body), available_memory());
}

void check_memory(const std::string& place, const std::vector<Request>& requests) {
  check_memory(place, requests, available_memory());
}

void check_memory(const std::string& place, const std::vector<Request>& requests,
                  double available) {
  for (const Request& request : requests) {
    check_case(place, label(request.settings), request.settings, available);
    for (const CaseSettings& reference : reference_cases(request))
      check_case(place,
                 fmt::format("{} on {} cells", label(reference),
                             fmt::join(reference.body.block.cells, " x ")),
                 reference, available);
  }
}

}  // namespace springcheck
