#include "comparisons/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "meshing/input_error.hpp"

namespace springcheck {

double estimated_memory(const CaseSettings& settings) {
  const auto [nx, ny, nz] = settings.block.cells;
  const double cells = 1. * nx * ny * nz;
  // A direct solver's factor grows with the nodes of the largest separator; these
  // constants were fitted to peak memories, see the tests.
  std::array<double, 3> sides{nx + 1., ny + 1., nz + 1.};
  std::ranges::sort(sides);
  const double separator = sides[0] * sides[1];
  const double nodes = separator * sides[2];
  constexpr double program = 200e6, mesh = 2e3, assembly = 15e3, factor = 60;
  double bytes = program + mesh * cells;
  const bool is_direct = is_finite_element(settings.method) ||
                         settings.solver == mss::Solver::static_equilibrium;
  if (is_direct) bytes += assembly * cells + factor * nodes * separator;
  return bytes;
}

double available_memory() {
  std::ifstream info("/proc/meminfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("MemAvailable:")) {
      double kilobytes = 0;
      std::istringstream(line.substr(line.find(':') + 1)) >> kilobytes;
      return 1024 * kilobytes;
    }
  return INFINITY;  // not Linux: nothing to compare with
}

void check_memory(const std::vector<Request>& requests, int parallel) {
  double largest = 0;
  const CaseSettings* settings = nullptr;
  const auto consider = [&](const CaseSettings& candidate) {
    const double bytes = estimated_memory(candidate);
    if (bytes > largest) {
      largest = bytes;
      settings = &candidate;
    }
  };
  for (const Request& request : requests) {
    consider(request.settings);
    if (request.reference) consider(*request.reference);
  }
  const double available = available_memory();
  if (settings != nullptr && parallel * largest > available)
    throw InputError(
        fmt::format("{} x {} cells", settings->scene,
                    fmt::join(settings->block.cells, " x ")),
        label(*settings), fmt::format("at most {:.1f} GB, available here", available / 1e9),
        fmt::format("an estimate of {:.1f} GB{}", parallel * largest / 1e9,
                    parallel > 1 ? fmt::format(" for {} at once", parallel) : ""));
}

}  // namespace springcheck
