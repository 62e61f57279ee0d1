#include "comparisons/settings/body_settings.hpp"

#include <algorithm>

#include "comparisons/settings/setting_values.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

CellPattern pattern_of(const Given& given) {
  const std::string name = given.text();
  const auto found = std::ranges::find(cell_patterns(), name, &CellPatternName::name);
  if (found == cell_patterns().end()) given.refuse("one of " + names_of(cell_patterns()));
  return found->pattern;
}

MeshUnit unit_of(const Given& given) {
  const std::string name = given.text();
  const auto found = std::ranges::find(mesh_units(), name, &MeshUnit::name);
  if (found == mesh_units().end()) given.refuse("one of " + names_of(mesh_units()));
  return *found;
}

BodyShape shape_of(const Given& given) {
  for (const BodyShape shape : {BodyShape::block, BodyShape::kidney, BodyShape::disc})
    if (given.text() == name_of(shape)) return shape;
  given.refuse("one of block, kidney, disc; a mesh of your own is given by 'mesh'");
}

/// A mesh stands in place of a block that a scene file describes; a block's settings
/// beside it, or given as options over it, are a contradiction.
void check_mesh_alone(const Settings& settings, const Given& mesh) {
  for (const char* key : {"size", "cells", "cell-type", "distortion", "body"})
    if (const auto found = settings.find(std::string_view(key));
        found != settings.end()) {
      const std::string source = found->second.source();
      if (source == mesh.source() || source == "--")
        throw InputError(found->second.place(), "",
                         "nothing of a block beside mesh '" + mesh.text() + "'",
                         "a value");
    }
}

/// Other bodies have no grid whose nodes could be moved.
void check_no_distortion(const Settings& settings, const Block& block) {
  if (block.distortion > 0) settings.at("distortion").refuse("none of it but in blocks");
}

/// Nor one that a kidney's cells could follow.
void check_kidney(const Settings& settings, const Block& block) {
  check_no_distortion(settings, block);
  if (block.pattern == CellPattern::free_tetrahedron ||
      block.pattern == CellPattern::free_hexahedron)
    return;
  const std::string expected = "free-tetrahedron or free-hexahedron for a kidney";
  if (const auto given = settings.find(std::string_view("cell-type"));
      given != settings.end())
    given->second.refuse(expected);
  throw InputError("key 'cell-type'", "", expected, "none");
}

/// A disc is round, and its cells are hexahedra.
void check_disc(const Settings& settings, const Block& block) {
  check_no_distortion(settings, block);
  if (block.pattern != CellPattern::hexahedron)
    settings.at("cell-type").refuse("hexahedron for a disc");
  if (block.size[0] != block.size[1])
    settings.at("size").refuse("a disc's diameter twice, and its height");
  if (block.cells[0] != block.cells[1])
    settings.at("cells").refuse("as many along x as along y of a disc");
  if (block.cells[0] < 3) settings.at("cells").refuse("at least 3 across a disc");
}

}  // namespace

const Given& required(const Settings& settings, const std::string& key,
                      const std::string& file, const std::string& expected) {
  const auto found = settings.find(key);
  if (found == settings.end())
    throw InputError(file + ":1:1", "key '" + key + "'", expected, "none");
  return found->second;
}

Body body_of(const Settings& settings, const std::string& file, Test test) {
  Body body;
  if (const auto mesh = settings.find(std::string_view("mesh")); mesh != settings.end()) {
    check_mesh_alone(settings, mesh->second);
    body.shape = BodyShape::file;
    body.file = mesh->second.path();
    body.unit = value_or(settings, "mesh-unit", mesh_units().front(), unit_of);
    body.fixed = value_or(settings, "fixed", body.fixed, &Given::text);
    body.moved = value_or(settings, "moved", body.moved, &Given::text);
  } else {
    for (const char* key : {"mesh-unit", "fixed", "moved"})
      if (const auto found = settings.find(std::string_view(key));
          found != settings.end())
        found->second.refuse("none of it without a mesh");
    body.shape = value_or(settings, "body", BodyShape::block, shape_of);
    body.block = {
        .size = size_of(required(settings, "size", file, "three lengths [m]")),
        .cells = cells_of(required(settings, "cells", file, "three counts")),
        .pattern = value_or(settings, "cell-type", CellPattern::hexahedron, pattern_of),
        .distortion = value_or(settings, "distortion", 0., not_negative_of)};
    if (body.shape == BodyShape::kidney) check_kidney(settings, body.block);
    if (body.shape == BodyShape::disc) check_disc(settings, body.block);
    if (reads_seed(body.block))
      body.block.seed = value_or(settings, "seed", body.block.seed, seed_of);
  }
  const bool slides = test == Test::uniaxial ||
                      value_or(settings, "plates", PlateContact::glued, plates_of) ==
                          PlateContact::sliding;
  if (slides && body.shape != BodyShape::block)
    throw InputError(body.shape == BodyShape::file ? settings.at("mesh").place() : file,
                     "sliding plates", "a block, at whose corners pins hold",
                     "a " + std::string(name_of(body.shape)));
  return body;
}

}  // namespace springcheck
