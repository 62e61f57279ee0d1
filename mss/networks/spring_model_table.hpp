#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meshing/cell_geometry.hpp"
#include "mss/networks/cells.hpp"
#include "mss/networks/spring_model.hpp"

namespace springcheck::mss {

/// The cells that a model has springs for; boxes are those that box_lattice covers.
enum class CellShapes { any, tetrahedra, cubes, boxes };

/// What springs of one cell are made of.
struct SpringCell {
  const CornerPositions& x;
  double volume;  // [m^3]
  const Material& material;
  const NetworkSettings& settings;
};

/// What tells one model from another.
struct SpringModelEntry {
  SpringModel model;
  CellShapes cells;
  /// Springs of one cell of its shapes.
  std::vector<CellSpring> (*springs)(const SpringCell&);
  /// kappa of the volume correction [Pa]; nothing without.
  std::optional<double> (*volume_modulus)(const Material&, const NetworkSettings&);
  /// Virtual springs in every cell (VirtualSprings), beside which its own resist
  /// hourglasses alone.
  bool has_virtual_springs = false;
  /// Why it cannot treat a material; nullptr: it takes all.
  std::optional<std::string> (*refuses)(const Material&) = nullptr;
};

const SpringModelEntry& entry_of(SpringModel model);

}  // namespace springcheck::mss
