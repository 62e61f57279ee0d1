#pragma once

#include <random>

#include "meshing/cutting/cut_body.hpp"

namespace springcheck {

/// A distorted block of one to four cells a side; the seed draws its pattern.
Mesh random_body(unsigned seed);

/// A cut of what is there: faces or cells anywhere, all inner faces of a cell, those
/// between cells at a node or beside a plane of cells, all cells at a node. One in twenty
/// asks for what cannot be: a face twice, a face of one cell, a cell twice, all cells.
Cut random_cut(const CellComplex& cells, std::mt19937& random);

}  // namespace springcheck
