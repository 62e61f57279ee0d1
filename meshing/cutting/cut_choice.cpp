#include "meshing/cutting/cut_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

constexpr double rounding = 1e-9;  // of a cell's size

template <class Nodes>
Vector3 mean(const Nodes& nodes, std::span<const Vector3> positions) {
  Vector3 sum = Vector3::Zero();
  for (const NodeIndex node : nodes) sum += positions[node];
  return sum / static_cast<double>(nodes.size());
}

/// How far a point is outside the box [m].
double outside(const std::optional<Box>& box, const Vector3& x) {
  return box ? (x - x.cwiseMax(box->low).cwiseMin(box->high)).norm() : 0;
}

/// The nearest of the things that a cut might have met.
struct Nearest {
  double rank = std::numeric_limits<double>::infinity();  // the lowest is taken [m]
  double off = 0;                                         // [m]
  Vector3 place{};

  void look_at(const Nearest& other) {
    if (other.rank < rank) *this = other;
  }
  [[nodiscard]] std::string told(std::string_view what, std::string_view many) const {
    if (std::isinf(rank)) return fmt::format("a body without {}", many);
    return fmt::format(
        "none: the nearest {} is at ({:.6g}, {:.6g}, {:.6g}) m, {:.3g} m off", what,
        place.x(), place.y(), place.z(), off);
  }
};

struct HeightsOfFace {
  double lowest = std::numeric_limits<double>::infinity();    // of its nodes [m]
  double highest = -std::numeric_limits<double>::infinity();  // [m]

  [[nodiscard]] double farthest() const { return std::max({-lowest, highest, 0.}); }
  [[nodiscard]] double spread() const { return highest - lowest; }
};

HeightsOfFace heights_of(const FaceNodes& face, std::span<const Vector3> positions,
                         const CutPlace& where) {
  HeightsOfFace heights;
  for (const NodeIndex node : face) {
    const double height = height_over(where.surface, positions[node]);
    heights.lowest = std::min(heights.lowest, height);
    heights.highest = std::max(heights.highest, height);
  }
  return heights;
}

bool is_crossed(const CutPlace& where, const Vector3& below, double height_below,
                const Vector3& above, double height_above) {
  const double tolerance = rounding * (above - below).norm();
  if (height_below >= -tolerance || height_above < -tolerance) return false;
  const Vector3 crossing =
      below + height_below / (height_below - height_above) * (above - below);
  return past_end(where.surface, crossing) <= tolerance &&
         outside(where.within, crossing) <= tolerance;
}

/// Of faces as near, that along the surface.
Nearest nearest_face(const CellComplex& cells, std::span<const Vector3> positions,
                     const CutPlace& where) {
  Nearest nearest;
  for (std::uint32_t c = 0; c < cells.cell_count(); ++c)
    for (std::uint8_t f = 0; f < cells.face_count(c); ++f) {
      if (cells.across({c, f}) == CellComplex::none) continue;
      const FaceNodes nodes = cells.nodes_of(CellSide{c, f});
      const HeightsOfFace heights = heights_of(nodes, positions, where);
      const Vector3 centre = mean(nodes, positions);
      const double off = outside(where.within, centre) + past_end(where.surface, centre);
      nearest.look_at({.rank = heights.farthest() + heights.spread() + off,
                       .off = std::max(heights.farthest(), off),
                       .place = centre});
    }
  return nearest;
}

}  // namespace

FaceChoice faces_along(const std::string& source, const std::string& place,
                       const CellComplex& cells, std::span<const Vector3> positions,
                       const CutPlace& where) {
  std::vector<Vector3> centres(cells.cell_count());
  std::vector<double> heights(cells.cell_count());
  for (std::uint32_t c = 0; c < cells.cell_count(); ++c) {
    if (cells.is_removed(c)) continue;
    centres[c] = mean(cells.nodes_of(c), positions);
    heights[c] = height_over(where.surface, centres[c]);
  }
  FaceChoice choice;
  for (std::uint32_t c = 0; c < cells.cell_count(); ++c)
    for (std::uint8_t f = 0; f < cells.face_count(c); ++f) {
      const CellSide face{c, f};
      const std::uint32_t other = cells.across(face);
      if (other == CellComplex::none ||
          !is_crossed(where, centres[c], heights[c], centres[other], heights[other]))
        continue;
      choice.faces.push_back(face);
      choice.farthest = std::max(
          choice.farthest, heights_of(cells.nodes_of(face), positions, where).farthest());
    }
  if (choice.faces.empty())
    throw InputError(source, place, "a face between cells on its two sides",
                     nearest_face(cells, positions, where)
                         .told("face between two cells", "faces between two cells"));
  return choice;
}

std::vector<std::uint32_t> cells_within(const std::string& source,
                                        const std::string& place,
                                        const CellComplex& cells,
                                        std::span<const Vector3> positions,
                                        const CutPlace& where) {
  std::vector<std::uint32_t> chosen;
  Nearest nearest;
  for (std::uint32_t c = 0; c < cells.cell_count(); ++c) {
    if (cells.is_removed(c)) continue;
    const Vector3 centre = mean(cells.nodes_of(c), positions);
    const double height = height_over(where.surface, centre);
    const double off = outside(where.within, centre) + past_end(where.surface, centre);
    const double tolerance = rounding * (positions[cells.nodes_of(c)[0]] - centre).norm();
    if (height < -tolerance && off <= tolerance)
      chosen.push_back(c);
    else
      nearest.look_at({.rank = std::max(height, 0.) + off,
                       .off = std::max(height, 0.) + off,
                       .place = centre});
  }
  if (chosen.empty())
    throw InputError(source, place, "a cell whose centre is inside",
                     nearest.told("cell's centre", "cells"));
  return chosen;
}

}  // namespace springcheck
