#include "meshing/gmsh.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <mutex>
#include <unordered_map>

#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

enum class GmshTag : std::size_t {};  // as in gmsh's model: 1-based, with gaps

constexpr int gmsh_quadrilateral = 3;  // gmsh's element type numbers
constexpr int gmsh_hexahedron = 5;

/// gmsh keeps global state and is not thread-safe: one session at a time.
class GmshSession {
 public:
  explicit GmshSession(const std::string& model) : lock_(mutex()) {
    ::gmsh::initialize(0, nullptr, false);
    ::gmsh::option::setNumber("General.Terminal", 0);
    ::gmsh::model::add(model);
  }
  ~GmshSession() { ::gmsh::finalize(); }
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex the_only_one;
    return the_only_one;
  }
  std::lock_guard<std::mutex> lock_;
};

struct Side {
  const char* name;
  std::array<int, 4> corners;  // local numbers of the box, outward
};
// The box's corners in the order of CellNodes.
constexpr std::array<Side, 6> sides{{{"bottom", {0, 3, 2, 1}},
                                     {"top", {4, 5, 6, 7}},
                                     {"y_min", {0, 1, 5, 4}},
                                     {"y_max", {2, 3, 7, 6}},
                                     {"x_min", {0, 4, 7, 3}},
                                     {"x_max", {1, 2, 6, 5}}}};

std::string describe(const Block& block) {
  return fmt::format("block {} m in {} cells", fmt::join(block.size, " x "),
                     fmt::join(block.cells, " x "));
}

void check(const Block& block) {
  double nodes = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(block.size[axis] > 0) || !std::isfinite(block.size[axis]))
      throw InputError(describe(block), "size", "positive finite lengths",
                       fmt::format("{}", block.size[axis]));
    if (block.cells[axis] < 1)
      throw InputError(describe(block), "cells", "at least 1 along each axis",
                       std::to_string(block.cells[axis]));
    nodes *= block.cells[axis] + 1.0;
  }
  if (nodes > std::numeric_limits<NodeIndex>::max())
    throw InputError(describe(block), "nodes", "at most 2^32 - 1",
                     fmt::format("{:.3g}", nodes));
}

/// The box as gmsh geometry: transfinite, recombined, with named physical groups.
void add_geometry(const Block& block) {
  namespace geo = ::gmsh::model::geo;
  const auto [width, depth, height] = block.size;
  const std::array<std::array<double, 2>, 4> outline{
      {{0, 0}, {width, 0}, {width, depth}, {0, depth}}};
  std::array<int, 8> points{};
  for (std::size_t i = 0; i < 8; ++i)
    points[i] = geo::addPoint(outline[i % 4][0], outline[i % 4][1], i < 4 ? 0 : height);

  // Box edges by their two corners, with the axis each runs along.
  constexpr std::array<std::array<std::size_t, 3>, 12> edges{{{0, 1, 0},
                                                              {3, 2, 0},
                                                              {4, 5, 0},
                                                              {7, 6, 0},
                                                              {0, 3, 1},
                                                              {1, 2, 1},
                                                              {4, 7, 1},
                                                              {5, 6, 1},
                                                              {0, 4, 2},
                                                              {1, 5, 2},
                                                              {2, 6, 2},
                                                              {3, 7, 2}}};
  std::array<std::array<int, 8>, 8> line{};  // signed tag from corner to corner
  for (const auto& [a, b, axis] : edges) {
    const int tag = geo::addLine(points[a], points[b]);
    geo::mesh::setTransfiniteCurve(tag, block.cells[axis] + 1);
    line[a][b] = tag;
    line[b][a] = -tag;
  }
  std::vector<int> surfaces;
  for (const Side& side : sides) {
    std::vector<int> loop;
    for (std::size_t i = 0; i < 4; ++i)
      loop.push_back(line[static_cast<std::size_t>(side.corners[i])]
                         [static_cast<std::size_t>(side.corners[(i + 1) % 4])]);
    surfaces.push_back(geo::addPlaneSurface({geo::addCurveLoop(loop)}));
    geo::mesh::setTransfiniteSurface(surfaces.back());
    geo::mesh::setRecombine(2, surfaces.back());
  }
  const int volume = geo::addVolume({geo::addSurfaceLoop(surfaces)});
  geo::mesh::setTransfiniteVolume(volume);
  geo::synchronize();
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const int group = ::gmsh::model::addPhysicalGroup(2, {surfaces[i]});
    ::gmsh::model::setPhysicalName(2, group, sides[i].name);
  }
  ::gmsh::model::setPhysicalName(3, ::gmsh::model::addPhysicalGroup(3, {volume}), "body");
}

/// Grid node each gmsh tag stands for, x fastest.
std::unordered_map<GmshTag, NodeIndex> grid_numbers(const Block& block) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parametric;
  ::gmsh::model::mesh::getNodes(tags, coordinates, parametric);
  std::unordered_map<GmshTag, NodeIndex> numbers;
  for (std::size_t n = 0; n < tags.size(); ++n) {
    NodeIndex number = 0;
    for (std::size_t axis = 3; axis-- > 0;) {
      const double place =
          coordinates[3 * n + axis] / block.size[axis] * block.cells[axis];
      if (std::abs(place - std::round(place)) > 1e-6)
        throw std::runtime_error("gmsh placed a node off the transfinite grid");
      number = number * static_cast<NodeIndex>(block.cells[axis] + 1) +
               static_cast<NodeIndex>(std::lround(place));
    }
    numbers[GmshTag{tags[n]}] = number;
  }
  return numbers;
}

/// Cells or faces of one type and entity (-1: all).
template <class List>
std::vector<List> elements(int type, int entity,
                           const std::unordered_map<GmshTag, NodeIndex>& numbers) {
  std::vector<std::size_t> tags, nodes;
  ::gmsh::model::mesh::getElementsByType(type, tags, nodes, entity);
  std::vector<List> found(tags.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    found[i / (nodes.size() / tags.size())].push_back(numbers.at(GmshTag{nodes[i]}));
  return found;
}

std::vector<Vector3> grid_nodes(const Block& block) {
  std::vector<Vector3> nodes;
  const auto at = [&](std::size_t axis, int i) {
    // The last plane exactly at the size: the quotient may miss it by a rounding.
    return i == block.cells[axis] ? block.size[axis]
                                  : block.size[axis] * i / block.cells[axis];
  };
  for (int k = 0; k <= block.cells[2]; ++k)
    for (int j = 0; j <= block.cells[1]; ++j)
      for (int i = 0; i <= block.cells[0]; ++i)
        nodes.emplace_back(at(0, i), at(1, j), at(2, k));
  return nodes;
}

/// Turns the cell so that it starts at its lowest corner and runs along x first:
/// gmsh's transfinite cells may start at any corner of theirs.
CellNodes upright(const CellNodes& cell, const std::vector<Vector3>& nodes) {
  Vector3 low = nodes[cell[0]], high = low;
  for (const NodeIndex node : cell) {
    low = low.cwiseMin(nodes[node]);
    high = high.cwiseMax(nodes[node]);
  }
  const Vector3 middle = (low + high) / 2;
  constexpr std::array<std::size_t, 8> vtk_corner{0, 1, 3, 2, 4, 5, 7, 6};
  CellNodes turned = cell;
  for (const NodeIndex node : cell) {
    const Vector3& x = nodes[node];
    const std::size_t octant = static_cast<std::size_t>(x.x() > middle.x()) +
                               2 * static_cast<std::size_t>(x.y() > middle.y()) +
                               4 * static_cast<std::size_t>(x.z() > middle.z());
    turned[vtk_corner[octant]] = node;
  }
  return turned;
}

bool ends_with(const std::filesystem::path& file, std::string_view ending) {
  std::ifstream in(file, std::ios::binary);
  in.seekg(-static_cast<std::streamoff>(ending.size()), std::ios::end);
  std::string last(ending.size(), '\0');
  in.read(last.data(), static_cast<std::streamsize>(last.size()));
  return in && last == ending;
}

}  // namespace

Mesh generate_block(const Block& block) try {
  check(block);
  std::vector<Vector3> nodes = grid_nodes(block);
  std::vector<CellNodes> cells;
  std::map<std::string, std::vector<FaceNodes>> regions;
  {
    const GmshSession session("block");
    add_geometry(block);
    ::gmsh::model::mesh::generate(3);
    const auto numbers = grid_numbers(block);
    cells = elements<CellNodes>(gmsh_hexahedron, -1, numbers);
    for (CellNodes& cell : cells) cell = upright(cell, nodes);
    std::ranges::sort(cells);
    ::gmsh::vectorpair groups;
    ::gmsh::model::getPhysicalGroups(groups, 2);
    for (const auto& [dimension, group] : groups) {
      std::string name;
      ::gmsh::model::getPhysicalName(dimension, group, name);
      std::vector<int> surfaces;
      ::gmsh::model::getEntitiesForPhysicalGroup(dimension, group, surfaces);
      for (const int surface : surfaces) {
        auto faces = elements<FaceNodes>(gmsh_quadrilateral, surface, numbers);
        std::ranges::sort(faces);
        regions[name].insert(regions[name].end(), faces.begin(), faces.end());
      }
    }
  }
  Mesh mesh(describe(block), std::move(nodes), std::move(cells), std::move(regions));
  const double expected = block.size[0] * block.size[1] * block.size[2];
  if (std::abs(mesh.volume() - expected) > 1e-9 * expected)
    throw InputError(mesh.source(), "volume", fmt::format("{:.9g} m^3", expected),
                     fmt::format("{:.9g} m^3", mesh.volume()));
  return mesh;
} catch (const std::string& message) {  // what gmsh throws
  throw std::runtime_error("gmsh: " + message);
}

std::string gmsh_version() {
  const GmshSession session("version");
  std::string version;
  ::gmsh::option::getString("General.Version", version);
  return version;
}

void write_msh(const Mesh& mesh, const std::filesystem::path& file) try {
  const GmshSession session("mesh");
  ::gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
  const int volume = ::gmsh::model::addDiscreteEntity(3);

  std::vector<std::size_t> tags;
  std::vector<double> coordinates;
  for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
    tags.push_back(n + 1);
    for (const double x : mesh.nodes()[n]) coordinates.push_back(x);
  }
  ::gmsh::model::mesh::addNodes(3, volume, tags, coordinates);

  std::size_t next_element = 1;
  const auto add_elements = [&](int entity, int type, const auto& cells) {
    std::vector<std::size_t> element_tags, element_nodes;
    for (const auto& cell : cells) {
      element_tags.push_back(next_element++);
      for (const NodeIndex node : cell) element_nodes.push_back(node + 1);
    }
    ::gmsh::model::mesh::addElementsByType(entity, type, element_tags, element_nodes);
  };
  add_elements(volume, gmsh_hexahedron, mesh.cells());
  ::gmsh::model::setPhysicalName(3, ::gmsh::model::addPhysicalGroup(3, {volume}), "body");
  for (const auto& [name, region] : mesh.regions()) {
    const int surface = ::gmsh::model::addDiscreteEntity(2);
    add_elements(surface, gmsh_quadrilateral, region.faces);
    ::gmsh::model::setPhysicalName(2, ::gmsh::model::addPhysicalGroup(2, {surface}),
                                   name);
  }
  ::gmsh::write(file.string());
  if (!ends_with(file, "$EndElements\n"))  // gmsh does not tell of a full disk
    throw std::runtime_error(file.string() + ": could not be written whole (disk full?)");
} catch (const std::string& message) {
  throw std::runtime_error("gmsh: " + message);
}

}  // namespace springcheck
