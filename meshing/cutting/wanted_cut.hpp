#pragma once

#include <cstddef>
#include <string>

#include "meshing/cutting/cut_body.hpp"
#include "meshing/cutting/cut_choice.hpp"

namespace springcheck {

enum class CutKind { split, remove };

/// A cut as it is asked for.
struct WantedCut {
  std::string name;  // of the surfaces that it makes
  CutKind kind;
  CutPlace where;  // to remove cells: a surface that encloses them
  std::string
      place{};  // where it was asked for, as messages tell it; else without meaning

  friend bool operator==(const WantedCut& a, const WantedCut& b) {
    return a.name == b.name && a.kind == b.kind && a.where == b.where;
  }
};

/// What a cut did to a body.
struct CutFigures {
  std::size_t faces_split = 0, cells_removed = 0, nodes_added = 0;
  double area = 0;            // of the faces that were split, of each side [m^2]
  double volume_removed = 0;  // [m^3]
  double farthest = 0;        // of the split faces' nodes from the surface [m]
};

/// The body with the cut, which meets it where its nodes are at rest, and what became of
/// it. Throws InputError as faces_along, cells_within and cut do.
struct MadeCut {
  CutBody body;
  CutFigures figures;
};
MadeCut make_cut(const Mesh& body, const WantedCut& wanted);

}  // namespace springcheck
