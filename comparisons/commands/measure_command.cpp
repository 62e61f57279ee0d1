#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/command_line/options.hpp"
#include "comparisons/command_line/screen.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/options/computing.hpp"
#include "comparisons/commands/options/input_options.hpp"
#include "comparisons/commands/options/interrupted.hpp"
#include "comparisons/commands/options/setting_options.hpp"
#include "comparisons/commands/output/result_json.hpp"
#include "comparisons/commands/output/result_text.hpp"
#include "comparisons/imported/imported_case.hpp"
#include "comparisons/imported/nodal_csv.hpp"
#include "comparisons/imported/vtu_file.hpp"
#include "comparisons/results/result_file.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/running/progress.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/setting.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

std::vector<Vector3> read_displacements(const std::filesystem::path& file,
                                        const Mesh& mesh) {
  if (file.extension() == ".csv")
    return read_nodal_csv(file, mesh, NodalQuantity::displacement);
  if (file.extension() == ".vtu") return read_vtu_displacements(file, mesh);
  throw InputError(file.string(), "extension", ".vtu or .csv",
                   file.has_extension() ? file.extension().string() : "none");
}

constexpr auto of_measured = "what was computed";

struct MeasureOptions {
  std::string scene{};
  SettingOptions settings{};
  std::filesystem::path displacements{};          // .vtu or .csv
  std::optional<std::filesystem::path> forces{};  // .csv
  std::string label{};                            // stands for the method
  std::optional<std::filesystem::path> out{};     // result file
  std::optional<TableFormat> format{};
  int threads = all_cores();
};

ImportedFields read_fields(const MeasureOptions& files, const Mesh& mesh) {
  ImportedFields fields{.displacements = read_displacements(files.displacements, mesh)};
  if (files.forces)
    fields.forces = read_nodal_csv(*files.forces, mesh, NodalQuantity::force);
  return fields;
}

/// Refuses options that only the scene's own methods would read. On a path of load those
/// stay that say how far it goes.
void check_read(const RunSettings& run, const Method& measured,
                const GivenSettings& options) {
  RunSettings of_measured = run;
  of_measured.methods = {{.method = measured}};
  const Request request = requests(of_measured).front();
  constexpr std::string_view of_path[] = {"solver",   "load-times", "load-fractions",
                                          "duration", "rate",       "angular-frequency",
                                          "cycles"};
  const bool has_path = !run.common.dynamics.load.empty();
  for (const GivenSetting& option : options) {
    const Setting& setting = *find_setting(option.key);
    const bool is_of_path = has_path && std::ranges::count(of_path, option.key) > 0;
    if (is_of_path || setting.standing == Standing::plan ||
        reads(request.settings, setting) ||
        (request.reference && reads(*request.reference, setting)))
      continue;
    option.value.refuse(fmt::format(
        "no {}, which neither what is measured nor its reference reads", option.key));
  }
}

ExitStatus measure(const MeasureOptions& options) {
  const Computing computing(options.threads);
  const GivenSettings given = options.settings.given();
  const RunSettings run = read_run(options.scene, given);
  check_memory(run.cells_place, requests(run));
  if (options.out) check_results_writable(*options.out);
  MeshStore meshes;
  const Mesh& mesh = meshes.mesh(run.common.body);
  const ImportedFields fields = read_fields(options, mesh);
  check_read(run, imported_method(options.label, fields), given);
  const CaseSettings measured = at_load(run.common, last_load(run.common.dynamics));
  for (const std::string& words :
       contradictions(mesh, mechanical_scene(measured, mesh), fields))
    spdlog::warn("{}", words);
  const BeforeInterruption told =
      tell_when_interrupted([] { return "Nothing is kept."; });
  std::vector<CaseResult> results;
  {
    Progress progress("simulations");
    results.push_back(imported_case(
        run, options.label, fields, meshes,
        [&](std::size_t done, std::size_t of) { progress.show(done, of); }));
  }
  if (options.out) write_results(*options.out, results, meshes);
  print_results(run.common.scene, results, {std::nullopt}, options.format, meshes);
  return std::ranges::count(run.expect, results.front().status) > 0
             ? ExitStatus::done
             : ExitStatus::unexpected_status;
}

Action declare_measure(CLI::App& parser) {
  const auto options = std::make_shared<MeasureOptions>();
  add_scene(parser, options->scene);
  add_path(parser, "--displacements", options->displacements, "FILE",
           ".vtu or .csv file of the nodes' displacements [m]")
      ->required()
      ->group(of_measured);
  add_path(parser, "--forces", options->forces, "FILE",
           ".csv file of the forces that the plates apply to the nodes [N]")
      ->group(of_measured);
  parser.add_option("--label", options->label, "name that stands for the method")
      ->required()
      ->type_name("NAME")
      ->group(of_measured);
  options->settings.add_to(parser, is_no_method);
  add_path(parser, "--out", options->out, "FILE", "HDF5 file for measures and fields")
      ->group(of_output);
  add_formats(parser, options->format);
  add_threads(parser, options->threads);
  return [options] { return measure(*options); };
}

}  // namespace

Command measure_command() {
  return {.name = "measure",
          .summary = "Measure what another program computed on a scene's mesh",
          .description =
              "'springcheck mesh' writes that mesh. Warnings tell what "
              "contradicts the scene.",
          .examples = {{"springcheck measure compression --displacements nodes.csv "
                        "--label their-solver",
                        "its volume error and distance from the reference"}},
          .declare = declare_measure};
}

}  // namespace springcheck
