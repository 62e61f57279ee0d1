#pragma once

#include "meshing/scene.hpp"

namespace springcheck::fem_reference {

/// Constitutive laws; formulas and sources in materials.hpp.
enum class Law { hooke, st_venant_kirchhoff };

/// Trilinear hexahedra with 2x2x2 Gauss points, fully or selectively integrated:
/// `q1_sri` takes the volumetric part of the law from the cell's mean dilatation
/// (cell.hpp; for Hooke's law on parallelepipeds: at the centroid), which avoids
/// volumetric locking.
enum class Element { q1, q1_sri };

struct Settings {
  Law law;
  Element element;
};

/// Static equilibrium of the body by finite elements (deal.II). Node numbers are the
/// mesh's. A failed simulation is a Solution with the status that says so; bad input
/// throws InputError.
Solution solve(const Mesh& mesh, const Scene& scene, const Settings& settings);

}  // namespace springcheck::fem_reference
