#pragma once

#include <Eigen/Geometry>  // Core with cross()
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace springcheck {

using Vector3 = Eigen::Vector3d;

/// Index into Mesh::nodes(); the same in both solvers and in every file written.
using NodeIndex = std::uint32_t;

/// Eight nodes in the order of gmsh and VTK: 0-1-2-3 around the lower face so that
/// its right-hand normal points into the cell, 4-5-6-7 above them.
using Hexahedron = std::array<NodeIndex, 8>;

/// Four nodes of a boundary face, right-handed about the outward normal.
using Quadrilateral = std::array<NodeIndex, 4>;

/// A part of the boundary.
struct Region {
  std::vector<Quadrilateral> faces;
  std::vector<NodeIndex> nodes;  // of the faces, ascending, each once
};

/// The mesh both solvers receive: nodes [m], cells by type (hexahedra today), named
/// boundary regions. Checked when built and never changed afterwards.
class Mesh {
 public:
  /// Throws InputError (naming `source`) unless there is at least one cell, every
  /// corner of every cell has a positive Jacobian, every face belongs to one or two
  /// cells, every node to a cell, and every region consists of boundary faces.
  Mesh(std::string source, std::vector<Vector3> nodes, std::vector<Hexahedron> hexahedra,
       std::map<std::string, std::vector<Quadrilateral>> regions);

  [[nodiscard]] const std::string& source() const { return source_; }
  [[nodiscard]] const std::vector<Vector3>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<Hexahedron>& hexahedra() const { return hexahedra_; }
  [[nodiscard]] const std::map<std::string, Region>& regions() const { return regions_; }

  /// Throws InputError listing the regions there are, when `name` is not one of them.
  [[nodiscard]] const Region& region(const std::string& name) const;

  /// The whole boundary: every face of exactly one cell, in the order of the cells.
  [[nodiscard]] const Region& boundary() const { return boundary_; }

  /// Exact volume of each cell, bilinear faces [m^3].
  [[nodiscard]] const std::vector<double>& cell_volumes() const { return cell_volumes_; }
  [[nodiscard]] double volume() const { return volume_; }

  /// SHA-256 of nodes, cells and regions, in hexadecimal.
  [[nodiscard]] const std::string& sha256() const { return sha256_; }

 private:
  std::string source_;
  std::vector<Vector3> nodes_;
  std::vector<Hexahedron> hexahedra_;
  std::map<std::string, Region> regions_;
  Region boundary_;
  std::vector<double> cell_volumes_;
  double volume_ = 0;
  std::string sha256_;
};

}  // namespace springcheck
