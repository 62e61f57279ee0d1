#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck::dynamics {

/// Some of the cells of a grid with these planes, kept with a probability, in random
/// order with random numbers and every cell turned at random: whatever a file may hold.
inline Mesh shuffled_cells(const std::array<std::vector<double>, 3>& planes, double kept,
                           unsigned seed) {
  std::mt19937 random(seed);
  const std::size_t nx = planes[0].size(), ny = planes[1].size();
  std::vector<CellNodes> cells;
  std::vector<std::size_t> used;
  // The cube's rotations that keep it right-handed, as images of gmsh's corners.
  const std::array<std::array<std::uint8_t, 8>, 4> turns{{{0, 1, 2, 3, 4, 5, 6, 7},
                                                          {1, 2, 3, 0, 5, 6, 7, 4},
                                                          {0, 3, 7, 4, 1, 2, 6, 5},
                                                          {5, 4, 7, 6, 1, 0, 3, 2}}};
  std::uniform_real_distribution<double> chance(0, 1);
  for (std::size_t k = 0; k + 1 < planes[2].size(); ++k)
    for (std::size_t j = 0; j + 1 < ny; ++j)
      for (std::size_t i = 0; i + 1 < nx; ++i) {
        if (chance(random) > kept) continue;
        const auto at = [&](std::size_t x, std::size_t y, std::size_t z) {
          return static_cast<NodeIndex>(x + nx * (y + ny * z));
        };
        const std::array<NodeIndex, 8> corners{at(i, j, k),
                                               at(i + 1, j, k),
                                               at(i + 1, j + 1, k),
                                               at(i, j + 1, k),
                                               at(i, j, k + 1),
                                               at(i + 1, j, k + 1),
                                               at(i + 1, j + 1, k + 1),
                                               at(i, j + 1, k + 1)};
        CellNodes cell;
        const auto& turn = turns[random() % turns.size()];
        for (const std::uint8_t c : turn) cell.push_back(corners[c]);
        cells.push_back(cell);
        used.insert(used.end(), corners.begin(), corners.end());
      }
  std::ranges::sort(used);
  used.erase(std::ranges::unique(used).begin(), used.end());
  std::ranges::shuffle(used, random);
  std::ranges::shuffle(cells, random);
  std::vector<NodeIndex> number(nx * ny * planes[2].size());
  std::vector<Vector3> nodes;
  for (const std::size_t node : used) {
    number[node] = static_cast<NodeIndex>(nodes.size());
    nodes.emplace_back(planes[0][node % nx], planes[1][node / nx % ny],
                       planes[2][node / nx / ny]);
  }
  for (CellNodes& cell : cells)
    for (NodeIndex& node : cell) node = number[node];
  return Mesh("shuffled", std::move(nodes), std::move(cells), {});
}

/// Planes at distances of h [m].
inline std::vector<double> even(int cells, double h) {
  std::vector<double> planes;
  for (int i = 0; i <= cells; ++i) planes.push_back(i * h);
  return planes;
}

/// Planes at distances that grow from h on [m].
inline std::vector<double> graded(int cells, double h) {
  std::vector<double> planes;
  for (int i = 0; i <= cells; ++i) planes.push_back(i * h * (1 + 0.02 * i));
  return planes;
}

}  // namespace springcheck::dynamics
