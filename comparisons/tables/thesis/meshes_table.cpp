#include "comparisons/tables/thesis/meshes_table.hpp"

#include <fmt/format.h>

#include <array>
#include <set>

#include "meshing/generators/generate_block.hpp"
#include "mss/networks/cell_springs.hpp"

namespace springcheck {
namespace {

/// A row as printed (Golec 2018, table 5.5).
struct PrintedMesh {
  std::array<int, 3> cells;
  double volumes, vertices, springs_nfd, springs_fd;
};
constexpr std::array<PrintedMesh, 8> printed_meshes{{
    {{10, 10, 10}, 1000, 1331, 7630, 19630},
    {{15, 15, 15}, 3375, 4096, 25020, 65520},
    {{20, 20, 20}, 8000, 9261, 58460, 154460},
    {{30, 30, 30}, 27000, 29791, 194490, 518490},
    {{4, 4, 24}, 384, 625, 3136, 7744},
    {{8, 8, 48}, 3072, 3969, 23232, 60096},
    {{10, 10, 60}, 6000, 7381, 44680, 116680},
    {{16, 16, 96}, 24576, 28033, 178816, 473728},
}};

/// Springs by the thesis's counting: edges once, inner diagonals by cell, and of face
/// diagonals all twelve of every cell, so that those between two cells count twice. And
/// each spring once.
struct SpringCounts {
  double nfd = 0, fd = 0, distinct = 0;
};

SpringCounts count_springs(const Mesh& mesh) {
  using Pair = std::pair<NodeIndex, NodeIndex>;
  std::set<Pair> edge_pairs, diagonal_pairs;
  SpringCounts counts;
  for (const CellNodes& nodes : mesh.cells()) {
    const CellType type = type_of(nodes);
    const auto pair = [&](const LocalEdge& ends) {
      return Pair(std::minmax(nodes[ends[0]], nodes[ends[1]]));
    };
    for (const LocalEdge& edge : edges(type)) edge_pairs.insert(pair(edge));
    for (const LocalEdge& edge : mss::face_diagonals(type))
      diagonal_pairs.insert(pair(edge));
    counts.nfd += static_cast<double>(mss::inner_diagonals(type).size());
    counts.fd += static_cast<double>(mss::face_diagonals(type).size());
  }
  counts.nfd += static_cast<double>(edge_pairs.size());
  counts.distinct = counts.nfd + static_cast<double>(diagonal_pairs.size());
  counts.fd += counts.nfd;
  return counts;
}

Table meshes_table() {
  Table table{.columns = {{"mesh", "mesh"},
                          {"volumes_printed", "cells, printed", "{:.0f}"},
                          {"volumes", "cells", "{:.0f}"},
                          {"vertices_printed", "nodes, printed", "{:.0f}"},
                          {"vertices", "nodes", "{:.0f}"},
                          {"springs_nfd_printed", "mss-nfd springs, printed", "{:.0f}"},
                          {"springs_nfd", "mss-nfd springs", "{:.0f}"},
                          {"springs_fd_printed", "mss-fd springs, printed", "{:.0f}"},
                          {"springs_fd", "mss-fd springs", "{:.0f}"},
                          {"springs_distinct", "each spring once", "{:.0f}"}},
              .notes = {"The thesis stores face diagonals with each cell, so that those "
                        "between two cells count twice; the last column counts every "
                        "spring of mss-fd and mss-cf once."}};
  for (const PrintedMesh& printed : printed_meshes) {
    const auto [nx, ny, nz] = printed.cells;
    const Mesh mesh =
        generate_block({.size = {0.05, 0.05, 0.05 * nz / nx}, .cells = printed.cells});
    const SpringCounts springs = count_springs(mesh);
    const auto count = [](std::size_t n) { return static_cast<double>(n); };
    table.rows.push_back(
        {.cells = {fmt::format("{}x{}x{}", nx, ny, nz), printed.volumes,
                   count(mesh.cells().size()), printed.vertices,
                   count(mesh.nodes().size()), printed.springs_nfd, springs.nfd,
                   printed.springs_fd, springs.fd, springs.distinct}});
  }
  return table;
}

}  // namespace

TablePlan plan_meshes_table() {
  return without_cases(meshes_table);
}

}  // namespace springcheck
