#include "comparisons/cases/body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "meshing/basics/input_error.hpp"
#include "meshing/files/msh_reader.hpp"
#include "meshing/generators/disc.hpp"
#include "meshing/generators/generate_block.hpp"
#include "meshing/generators/kidney.hpp"
#include "mss/networks/box_lattice.hpp"

namespace springcheck {

const std::vector<MeshUnit>& mesh_units() {
  static const std::vector<MeshUnit> all{{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}};
  return all;
}

bool reads_seed(const Block& block) {
  return block.distortion > 0 || block.pattern == CellPattern::mixed;
}

bool is_grid_of_hexahedra(const Body& body) {
  return body.shape == BodyShape::block && body.block.pattern == CellPattern::hexahedron;
}

bool has_nodes_in_layers(const Body& body) {
  constexpr std::array of_gmsh{CellPattern::free_tetrahedron, CellPattern::free_prism,
                               CellPattern::free_hexahedron, CellPattern::transition};
  return body.shape == BodyShape::block && body.block.distortion == 0 &&
         body.cuts.empty() && std::ranges::count(of_gmsh, body.block.pattern) == 0;
}

bool is_grid_of_cubes(const Body& body) {
  std::array<double, 3> edges = body.block.size;
  for (std::size_t i = 0; i < 3; ++i) edges[i] /= body.block.cells[i];
  return is_grid_of_hexahedra(body) && mss::is_cube(edges);
}

void check_not_cut(const Body& body, const std::string& what) {
  if (!body.cuts.empty())
    throw InputError(body.cuts.front().place, "", "no cut where there is " + what,
                     "cut '" + body.cuts.front().name + "'");
}

Body on_hexahedra(Body body, const std::array<int, 3>& cells) {
  body.block = {.size = body.block.size, .cells = cells};
  return body;
}

Multiplicity multiplicity(CellPattern pattern) {
  switch (pattern) {
    case CellPattern::hexahedron:
      return {.cells = 1, .nodes = 1};
    case CellPattern::prism:
      return {.cells = 2, .nodes = 1};
    case CellPattern::tetrahedron_5:
      return {.cells = 5, .nodes = 1};
    case CellPattern::tetrahedron:
      return {.cells = 6, .nodes = 1};
    case CellPattern::pyramid:
      return {.cells = 6, .nodes = 2};
    case CellPattern::tetrahedron_12:
      return {.cells = 12, .nodes = 2};
    case CellPattern::mixed:
      return {.cells = 4, .nodes = 1.5};
    case CellPattern::free_tetrahedron:
    case CellPattern::transition:
      return {.cells = 8, .nodes = 1.5};
    case CellPattern::free_prism:
      return {.cells = 2.5, .nodes = 1.3};
    case CellPattern::free_hexahedron:
      return {.cells = 4, .nodes = 4};
  }
  return {};
}

namespace {

/// A cell of an ASCII file with its share of nodes takes about as many bytes.
constexpr double bytes_per_cell = 50, cells_per_node = 4;

double cells_in_file(const std::string& file) {
  std::error_code none;
  const auto bytes = std::filesystem::file_size(file, none);
  return none ? 0 : static_cast<double>(bytes) / bytes_per_cell;
}

}  // namespace

std::array<double, 3> equivalent_grid(const Body& body) {
  std::array<double, 3> grid{};
  if (body.shape == BodyShape::file) {
    grid.fill(std::cbrt(cells_in_file(body.file) / cells_per_node));
    return grid;
  }
  const double finer = std::cbrt(multiplicity(body.block.pattern).nodes);
  std::ranges::transform(body.block.cells, grid.begin(),
                         [&](int cells) { return finer * cells; });
  return grid;
}

double estimated_cells(const Body& body) {
  if (body.shape == BodyShape::file) return cells_in_file(body.file);
  double cells = multiplicity(body.block.pattern).cells;
  for (const int along : body.block.cells) cells *= along;
  return cells;
}

namespace {

Mesh whole_mesh(const Body& body) {
  switch (body.shape) {
    case BodyShape::block:
      break;
    case BodyShape::kidney:
      return generate_kidney({.size = body.block.size,
                              .cells = body.block.cells,
                              .pattern = body.block.pattern});
    case BodyShape::disc:
      return generate_disc({.diameter = body.block.size[0],
                            .height = body.block.size[2],
                            .across = body.block.cells[0],
                            .layers = body.block.cells[2]});
    case BodyShape::file:
      return read_msh(body.file, body.unit.metres);
  }
  return generate_block(body.block);
}

/// Refuses a cut that takes a part of a plate's surface: but for blocks its centre says
/// where the plate is, and about what it turns.
void check_plate(const Mesh& before, const Mesh& after, const WantedCut& cut,
                 const std::string& plate) {
  if (!before.regions().contains(plate) || !after.regions().contains(plate)) return;
  const std::size_t all = before.region(plate).faces.size(),
                    left = after.region(plate).faces.size();
  if (left < all)
    throw InputError(cut.place, fmt::format("cut '{}'", cut.name),
                     fmt::format("all {} faces of '{}' left, whose centre is the plate's "
                                 "of a body that is no block",
                                 all, plate),
                     std::to_string(left));
}

}  // namespace

BuiltBody build_body(const Body& body) {
  BuiltBody built{.mesh = whole_mesh(body), .cuts = {}};
  for (const WantedCut& wanted : body.cuts) {
    MadeCut made = make_cut(built.mesh, wanted);
    if (body.shape != BodyShape::block)
      for (const std::string& plate : {body.fixed, body.moved})
        check_plate(built.mesh, made.body.mesh, wanted, plate);
    built.mesh = std::move(made.body.mesh);
    built.cuts.push_back(made.figures);
  }
  return built;
}

Mesh build_mesh(const Body& body) {
  return build_body(body).mesh;
}

const Mesh& MeshStore::mesh(const Body& body) {
  const std::lock_guard lock(one_at_a_time_);
  const auto known =
      std::ranges::find(meshes_, body, &decltype(meshes_)::value_type::first);
  if (known != meshes_.end()) return *known->second;
  meshes_.emplace_back(body, std::make_unique<const Mesh>(build_mesh(body)));
  return *meshes_.back().second;
}

std::size_t MeshStore::cells() {
  const std::lock_guard lock(one_at_a_time_);
  std::size_t all = 0;
  for (const auto& [body, mesh] : meshes_) all += mesh->cells().size();
  return all;
}

const std::string& MeshHashes::of(const Body& body) {
  const auto known =
      std::ranges::find(hashes_, body, &decltype(hashes_)::value_type::first);
  if (known != hashes_.end()) return known->second;
  return hashes_.emplace_back(body, build_mesh(body).sha256()).second;
}

}  // namespace springcheck
