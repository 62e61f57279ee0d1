#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "comparisons/command_line/options.hpp"
#include "comparisons/command_line/screen.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/options/input_options.hpp"
#include "comparisons/commands/options/setting_options.hpp"
#include "comparisons/commands/output/quality_text.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/output_file.hpp"
#include "meshing/files/mesh_files.hpp"

namespace springcheck {
namespace {

/// "8 prisms, 20 hexahedra".
std::string cell_counts(const Mesh& mesh) {
  std::vector<std::string> counts;
  for (const CellType type : all_cell_types)
    if (const std::size_t count = mesh.count(type); count > 0)
      counts.push_back(fmt::format("{} {}", count, plural_of(type)));
  return fmt::format("{}", fmt::join(counts, ", "));
}

struct MeshOptions {
  std::string scene{};
  SettingOptions settings{};
  std::optional<std::filesystem::path> file{};
  bool quality = false;
  std::optional<TableFormat> format{};
};

/// The mesh in a line or two: cells, volume, hash.
std::vector<std::string> notes_on(const Mesh& mesh, const std::string& name) {
  std::vector<std::string> notes{fmt::format("{}: {} nodes, {}, {:.6g} m^3, SHA-256 {}",
                                             name, mesh.nodes().size(), cell_counts(mesh),
                                             mesh.volume(), mesh.sha256())};
  if (!mesh.surfaces_elsewhere().empty())
    notes.push_back(
        fmt::format("surfaces that are not on the boundary, and hold nothing: {}",
                    fmt::join(mesh.surfaces_elsewhere(), ", ")));
  return notes;
}

std::string note_on(const WantedCut& cut, const CutFigures& figures) {
  if (cut.kind == CutKind::remove)
    return fmt::format("cut '{}': {} cells removed, {:.6g} m^3, {} nodes added", cut.name,
                       figures.cells_removed, figures.volume_removed,
                       figures.nodes_added);
  return fmt::format(
      "cut '{}': {} faces split, {:.6g} m^2, {} nodes added, the faces' nodes up to "
      "{:.3g} m "
      "off the surface",
      cut.name, figures.faces_split, figures.area, figures.nodes_added, figures.farthest);
}

ExitStatus write_scene_mesh(const MeshOptions& options) {
  const auto& file = options.file;
  if (!file && !options.quality)
    throw InputError("--out", "", "a .msh, .vtu or .inp file, or --quality alone",
                     "neither");
  if (options.format && !options.quality)
    throw InputError("--format", "", "--quality with it", "none");
  const RunSettings run = read_run(options.scene, options.settings.given());
  check_mesh_memory(run.cells_place, run.common.body);
  if (file) check_writable(*file);
  const BuiltBody built = build_body(run.common.body);
  const Mesh& mesh = built.mesh;
  if (file) write_mesh(mesh, *file);
  std::vector<std::string> notes = notes_on(mesh, file ? file->string() : mesh.source());
  for (std::size_t i = 0; i < built.cuts.size(); ++i)
    notes.push_back(note_on(run.common.body.cuts[i], built.cuts[i]));
  if (options.format) {
    Table table = quality_table(quality_of(mesh));
    table.notes = notes;
    fmt::print("{}", format_table(table, *options.format));
    return ExitStatus::done;
  }
  const Screen screen = screen_of_output();
  for (const std::string& note : notes) fmt::print("{}\n", in_lines(note, screen));
  if (options.quality) {
    const Quality quality = quality_of(mesh);
    fmt::print("\n{}\n{}", table_in_columns(quality_table(quality), screen),
               histogram_text(quality));
  }
  return ExitStatus::done;
}

Action declare_mesh(CLI::App& parser) {
  const auto options = std::make_shared<MeshOptions>();
  add_scene(parser, options->scene);
  options->settings.add_to(parser, is_of_mesh);
  add_path(parser, "--out", options->file, "FILE", "a .msh, .vtu or .inp file")
      ->group(of_output);
  parser
      .add_flag("--quality", options->quality,
                "print volumes, scaled Jacobians and edge ratios of the cells")
      ->group(of_output);
  add_formats(parser, options->format);
  return [options] { return write_scene_mesh(*options); };
}

}  // namespace

Command mesh_command() {
  return {.name = "mesh",
          .summary = "Write the mesh that both solvers use, or tell how good it is",
          .description = "",
          .examples = {{"springcheck mesh compression --out block.msh",
                        "the scene's block for gmsh"},
                       {"springcheck mesh compression --mesh body.msh --quality",
                        "how good the cells of a mesh of yours are"}},
          .declare = declare_mesh};
}

}  // namespace springcheck
