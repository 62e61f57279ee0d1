#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "meshing/basics/vector3.hpp"
#include "meshing/cell_type.hpp"

namespace springcheck {

/// A part of the boundary.
struct Region {
  std::vector<FaceNodes> faces;
  std::vector<NodeIndex> nodes{};  // of the faces, ascending, each once
};

/// The mesh both solvers receive: nodes [m], cells of any types, named boundary regions.
/// Checked when built and never changed afterwards.
class Mesh {
 public:
  /// Sorts the cells by type, tetrahedra first, and otherwise leaves their order.
  ///
  /// Throws InputError (naming `source`) unless there is at least one cell, every
  /// corner of every cell has a positive Jacobian, every face belongs to one cell or to
  /// two that lie on its two sides, every node to a cell, and every region consists of
  /// boundary faces. Takes time in proportion to the number of cells.
  /// Messages number nodes and cells from 1, as files that are written do.
  Mesh(std::string source, std::vector<Vector3> nodes, std::vector<CellNodes> cells,
       std::map<std::string, std::vector<FaceNodes>> regions,
       std::set<std::string> surfaces_elsewhere = {});

  [[nodiscard]] const std::string& source() const { return source_; }
  [[nodiscard]] const std::vector<Vector3>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<CellNodes>& cells() const { return cells_; }

  /// How many cells of the type there are.
  [[nodiscard]] std::size_t count(CellType type) const;

  [[nodiscard]] const std::map<std::string, Region>& regions() const { return regions_; }

  /// Names of surfaces that are not on the boundary throughout, where nothing can hold
  /// the body.
  [[nodiscard]] const std::set<std::string>& surfaces_elsewhere() const {
    return surfaces_elsewhere_;
  }

  /// Throws InputError listing the regions there are, when `name` is not one of them.
  [[nodiscard]] const Region& region(const std::string& name) const;

  /// The whole boundary: every face of exactly one cell, in the order of the cells.
  [[nodiscard]] const Region& boundary() const { return boundary_; }

  /// Exact volume of each cell, bilinear faces [m^3].
  [[nodiscard]] const std::vector<double>& cell_volumes() const { return cell_volumes_; }
  [[nodiscard]] double volume() const { return volume_; }
  /// (V/number of cells)^(1/3) [m]
  [[nodiscard]] double mean_cell_edge() const;

  /// SHA-256 of nodes, cells and regions, in hexadecimal.
  [[nodiscard]] const std::string& sha256() const { return sha256_; }

 private:
  std::string source_;
  std::vector<Vector3> nodes_;
  std::vector<CellNodes> cells_;
  std::map<std::string, Region> regions_;
  std::set<std::string> surfaces_elsewhere_;
  Region boundary_;
  std::vector<double> cell_volumes_;
  double volume_ = 0;
  std::string sha256_;
};

}  // namespace springcheck
