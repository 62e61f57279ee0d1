#include "comparisons/running/memory.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "fem_reference/statics/takes_multigrid.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

/// Peak memory of the program with one mesh [bytes].
double estimated_mesh_memory(const Body& body) {
  constexpr double program = 165e6, per_cell = 3e3;
  return program + per_cell * estimated_cells(body);
}

/// Nodes of the elements along x, y, z: q2 has one more between any two of the mesh.
std::array<double, 3> element_nodes(const CaseSettings& settings) {
  const bool halved = is_finite_element(settings.method) &&
                      settings.elements.element.element == fem_reference::Element::q2;
  std::array<double, 3> nodes{};
  std::ranges::transform(equivalent_grid(settings.body), nodes.begin(),
                         [&](double cells) { return (halved ? 2. : 1.) * cells + 1; });
  return nodes;
}

/// A number of kilobytes that Linux tells under a name; none elsewhere.
std::optional<double> bytes_in(const char* file, const char* name) {
  std::ifstream info(file);
  for (std::string line; std::getline(info, line);)
    if (line.starts_with(name)) {
      double kilobytes = 0;
      std::istringstream(line.substr(line.find(':') + 1)) >> kilobytes;
      return 1024 * kilobytes;
    }
  return std::nullopt;
}

enum class LinearSystems { none, cholesky, multigrid };

LinearSystems linear_systems(const CaseSettings& settings) {
  if (is_explicit_element(settings.method)) return LinearSystems::none;
  if (!is_finite_element(settings.method))
    return goes_through_time(settings) ? LinearSystems::none : LinearSystems::cholesky;
  const auto [nx, ny, nz] = element_nodes(settings);
  const bool multigrid = fem_reference::takes_multigrid(
      reference_settings(settings), settings.material.poisson_ratio,
      static_cast<std::size_t>(3 * nx * ny * nz));
  return multigrid ? LinearSystems::multigrid : LinearSystems::cholesky;
}

/// mss-affine couples a node with its neighbours' neighbours where its volume correction
/// acts on node stars. Peaks at 10^3 and 20^3 cubes: 221 and 714 MB, mss-cf's 188 and
/// 432.
double coupling(const CaseSettings& settings) {
  const auto* springs = std::get_if<mss::Method>(&settings.method.model);
  const bool has_stars = springs != nullptr && *springs == mss::Method::affine &&
                         settings.material.poisson_ratio > 0.25;
  return has_stars ? 2.8 : 1;
}

void refuse_if_too_large(const std::string& place, const std::string& what,
                         double bytes) {
  const double available = available_memory();
  if (bytes > available)
    throw InputError(
        place, what,
        fmt::format("cells for at most {:.3g} GB, which this machine has left",
                    available / 1e9),
        fmt::format("an estimate of {:.3g} GB", bytes / 1e9));
}

}  // namespace

double estimated_memory(const CaseSettings& settings) {
  std::array<double, 3> nodes = element_nodes(settings);
  std::ranges::sort(nodes);
  const double cells = (nodes[0] - 1) * (nodes[1] - 1) * (nodes[2] - 1);
  const double bytes = estimated_mesh_memory(settings.body);
  switch (linear_systems(settings)) {
    case LinearSystems::none:
      break;
    case LinearSystems::multigrid: {
      // Peak of `run compression`, Hooke and Hencky alike: 580 MB at 30^3 cells of
      // q1-sri, 3435 MB at 60^3; 1646 MB at 20^3 cells of q2, which are 40^3 here.
      const double per_cell =
          settings.elements.element.element == fem_reference::Element::q2 ? 24e3 : 13e3;
      return bytes + per_cell * cells;
    }
    case LinearSystems::cholesky: {
      // Peak of `run compression`, one method, at 10^3, 20^3, 30^3 cells: 188, 432, 1264
      // MB (mss-cf), 191, 400, 1181 MB (fem-stvk). Fitted: so much per cell for matrices,
      // and a Cholesky factor that grows like nested dissection's, nodes *
      // sqrt(cross-section).
      constexpr double matrices_per_cell = 12.5e3, factor = 740;
      return bytes + coupling(settings) * (matrices_per_cell * cells +
                                           factor * nodes[0] * nodes[1] * nodes[2] *
                                               std::sqrt(nodes[0] * nodes[1]));
    }
  }
  return bytes;
}

double available_memory() {
  return bytes_in("/proc/meminfo", "MemAvailable:").value_or(INFINITY);
}

double resident_memory() {
  return bytes_in("/proc/self/status", "VmRSS:").value_or(0);
}

double peak_memory() {
  return bytes_in("/proc/self/status", "VmHWM:").value_or(0);
}

void reset_peak_memory() {
  std::ofstream("/proc/self/clear_refs") << "5";
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
