#pragma once

#include <optional>
#include <span>

#include "meshing/cutting/cell_complex.hpp"
#include "meshing/cutting/cutting_surface.hpp"

namespace springcheck {

/// Where a cut goes.
struct CutPlace {
  CuttingSurface surface;
  std::optional<Box> within{};  // no further

  friend bool operator==(const CutPlace&, const CutPlace&) = default;
};

/// The faces that a cut along a surface parts.
struct FaceChoice {
  std::vector<CellSide> faces{};  // as the cells below the surface have them
  double farthest = 0;            // of their nodes from the surface [m]
};

/// The faces between two cells whose centres, the means of their nodes, lie on two sides
/// of the surface, where it reaches the line between them within the box. A centre on the
/// surface, to 1e-9 of the line, is above it. `positions` are of the nodes, at rest or
/// deformed.
///
/// Throws InputError, with place `place`, when there is no such face; it tells the
/// nearest face between two cells, by its centre.
FaceChoice faces_along(const std::string& source, const std::string& place,
                       const CellComplex& cells, std::span<const Vector3> positions,
                       const CutPlace& where);

/// The cells whose centres are within the surface, which must enclose a part of space,
/// and within the box. A centre on the surface, to 1e-9 of its distance from the cell's
/// nodes, is outside; one on the box is inside.
///
/// Throws InputError, with place `place`, when there is none; it tells the cell that is
/// nearest.
std::vector<std::uint32_t> cells_within(const std::string& source,
                                        const std::string& place,
                                        const CellComplex& cells,
                                        std::span<const Vector3> positions,
                                        const CutPlace& where);

}  // namespace springcheck
