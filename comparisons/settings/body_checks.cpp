#include "comparisons/settings/body_checks.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "comparisons/settings/setting.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

/// Refuses distortion: bodies other than blocks have no grid whose nodes could be moved.
void check_no_distortion(const Settings& settings, const Block& block) {
  if (block.distortion > 0)
    find(settings, "distortion")->refuse("none of it but in blocks");
}

/// Refuses distortion for a kidney, and all cells but free ones.
void check_kidney(const Settings& settings, const Block& block) {
  check_no_distortion(settings, block);
  if (block.pattern == CellPattern::free_tetrahedron ||
      block.pattern == CellPattern::free_hexahedron)
    return;
  const std::string expected = "free-tetrahedron or free-hexahedron for a kidney";
  if (const Given* given = find(settings, "cell-type")) given->refuse(expected);
  throw InputError("key 'cell-type'", "", expected, "none");
}

/// Refuses what does not suit a disc, which is round and whose cells are hexahedra.
void check_disc(const Settings& settings, const Block& block) {
  check_no_distortion(settings, block);
  if (block.pattern != CellPattern::hexahedron)
    find(settings, "cell-type")->refuse("hexahedron for a disc");
  if (block.size[0] != block.size[1])
    find(settings, "size")->refuse("a disc's diameter twice, and its height");
  const Given& cells = *find(settings, "cells");
  if (block.cells[0] != block.cells[1])
    cells.refuse("as many along x as along y of a disc");
  if (block.cells[0] < 3) cells.refuse("at least 3 across a disc");
}

}  // namespace

const Given* find(const Settings& settings, std::string_view key) {
  if (!key.empty() && find_setting(key) == nullptr)
    throw std::logic_error(fmt::format("setting '{}' is read and not declared", key));
  const auto found = settings.find(key);
  return found == settings.end() ? nullptr : &found->second;
}

void check_body(const CaseSettings& common, const Settings& settings,
                const std::string& file) {
  const Body& body = common.body;
  if (body.shape == BodyShape::kidney) check_kidney(settings, body.block);
  if (body.shape == BodyShape::disc) check_disc(settings, body.block);
  const bool slides =
      entry_of(common.test).slides || common.plates == PlateContact::sliding;
  if (slides && body.shape != BodyShape::block)
    throw InputError(
        body.shape == BodyShape::file ? find(settings, "mesh")->place() : file,
        "sliding plates", "a block, at whose corners pins hold",
        "a " + std::string(name_of(body.shape)));
}

}  // namespace springcheck
