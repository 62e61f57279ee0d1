#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "comparisons/names/named.hpp"
#include "meshing/cutting/wanted_cut.hpp"
#include "meshing/generators/generate_block.hpp"

namespace springcheck {

/// What is deformed: a block, a kidney-like solid, a disc, or the mesh of a file.
enum class BodyShape { block, kidney, disc, file };

template <>
inline constexpr std::array value_names<BodyShape>{
    Named{BodyShape::block, "block"}, Named{BodyShape::kidney, "kidney"},
    Named{BodyShape::disc, "disc"}, Named{BodyShape::file, "file"}};

template <>
inline constexpr std::array value_names<CutKind>{Named{CutKind::split, "split"},
                                                 Named{CutKind::remove, "remove"}};

/// A length unit of mesh files.
struct MeshUnit {
  std::string_view name;
  double metres;

  friend bool operator==(const MeshUnit&, const MeshUnit&) = default;
};
const std::vector<MeshUnit>& mesh_units();

/// A body and how it is cut into cells.
struct Body {
  BodyShape shape = BodyShape::block;
  // The block. For a kidney it holds the extents of its ellipsoid and the numbers of
  // cells along them; for a disc its diameter twice and its height, and the cells
  // likewise; for a file it is not read:
  Block block;
  std::string file{};  // of the user's mesh
  MeshUnit unit{};
  // Regions on the lower, fixed and on the upper, moved or loaded plate:
  std::string fixed = "bottom";
  std::string moved = "top";
  std::vector<WantedCut> cuts{};  // in the order in which they are made

  friend bool operator==(const Body&, const Body&) = default;
};

/// Whether the mesh of the block depends on its seed.
bool reads_seed(const Block& block);

/// Whether it is a block whose cells are those of the regular grid, distorted or not.
bool is_grid_of_hexahedra(const Body& body);

/// Whether its nodes are those of a regular grid and the centres of its cells, without
/// cells of gmsh's, not distorted and not cut. Only then do whole layers and lines of
/// nodes lie in the middle.
bool has_nodes_in_layers(const Body& body);

/// Whether it is a grid of cubes, to 1e-6 of their edge, before they are distorted.
bool is_grid_of_cubes(const Body& body);

/// Throws InputError where a body is cut: `what` needs one that is whole.
void check_not_cut(const Body& body, const std::string& what);

/// The body on a regular grid of so many hexahedra. It must be a block.
Body on_hexahedra(Body body, const std::array<int, 3>& cells);

/// Numbers of cells and nodes over those of the grid that a pattern starts from, for
/// estimates: about right in large blocks.
struct Multiplicity {
  double cells;
  double nodes;
};
Multiplicity multiplicity(CellPattern pattern);

/// Numbers of cells along x, y, z of a grid with about as many nodes, for estimates; for
/// a file they are judged by its length.
std::array<double, 3> equivalent_grid(const Body& body);

/// The approximate number of cells that the mesh will have.
double estimated_cells(const Body& body);

/// Builds the mesh of a body. Throws InputError as generate_block, generate_kidney,
/// generate_disc, read_msh and make_cut do.
Mesh build_mesh(const Body& body);

/// The same, and what each of its cuts did to it.
struct BuiltBody {
  Mesh mesh;
  std::vector<CutFigures> cuts;
};
BuiltBody build_body(const Body& body);

/// Meshes of bodies, each built once. They may be asked for from any thread.
class MeshStore {
 public:
  const Mesh& mesh(const Body& body);

  /// The number of cells of all meshes together.
  [[nodiscard]] std::size_t cells();

 private:
  std::mutex one_at_a_time_;
  std::vector<std::pair<Body, std::unique_ptr<const Mesh>>> meshes_;
};

/// SHA-256 of bodies' meshes, each of which is built once and let go.
class MeshHashes {
 public:
  const std::string& of(const Body& body);

 private:
  std::vector<std::pair<Body, std::string>> hashes_;
};

}  // namespace springcheck
