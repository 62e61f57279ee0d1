#include "comparisons/commands/options/input_options.hpp"

#include <CLI/CLI.hpp>

#include "comparisons/command_line/options.hpp"

namespace springcheck {

CLI::Option* add_scene(CLI::App& parser, std::string& scene) {
  return parser.add_option("scene", scene, "name of a shipped scene, or a .toml file")
      ->required()
      ->type_name("SCENE|FILE");
}

CLI::Option* add_results(CLI::App& parser, std::filesystem::path& results) {
  return add_path(parser, "results", results, "FILE", "HDF5 file of results")->required();
}

CLI::Option* add_revisions(CLI::App& parser, Revisions& revisions,
                           const std::string& taken) {
  return parser.add_flag_callback(
      "--accept-other-revisions", [&revisions] { revisions = Revisions::all; },
      taken +
          " of other revisions of the numerics are taken, where there are none of this "
          "program's, and what is made of them says so");
}

}  // namespace springcheck
