#include "comparisons/commands/measure_command.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/commands/result_json.hpp"
#include "comparisons/commands/result_text.hpp"
#include "comparisons/measured/measured_case.hpp"
#include "comparisons/measured/nodal_csv.hpp"
#include "comparisons/measured/vtu_file.hpp"
#include "comparisons/results/result_file.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/running/progress.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/setting.hpp"
#include "meshing/input_error.hpp"

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

MeasuredFields read_fields(const MeasuredFiles& files, const Mesh& mesh) {
  MeasuredFields fields{.displacements = read_displacements(files.displacements, mesh)};
  if (files.forces)
    fields.forces = read_nodal_csv(*files.forces, mesh, NodalQuantity::force);
  return fields;
}

/// Refuses options that only the scene's own methods would read. On a path of load those
/// stay that say how far it goes.
void check_read(const RunSettings& run, const Method& measured,
                const std::vector<GivenSetting>& options) {
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

}  // namespace

ExitStatus measure_command(const std::string& scene,
                           const std::vector<GivenSetting>& options,
                           const MeasuredFiles& files,
                           const std::optional<std::filesystem::path>& result_file,
                           Output output) {
  const RunSettings run = read_run(scene, options);
  check_memory(run.cells_place, requests(run));
  if (result_file) check_results_writable(*result_file);
  MeshStore meshes;
  const Mesh& mesh = meshes.mesh(run.common.body);
  const MeasuredFields fields = read_fields(files, mesh);
  check_read(run, measured_method(files.label, fields), options);
  const CaseSettings measured = at_load(run.common, last_load(run.common.dynamics));
  for (const std::string& words :
       contradictions(mesh, mechanical_scene(measured, mesh), fields))
    spdlog::warn("{}", words);
  std::vector<CaseResult> results;
  {
    Progress progress("simulations");
    results.push_back(measured_case(
        run, files.label, fields, meshes,
        [&](std::size_t done, std::size_t of) { progress.show(done, of); }));
  }
  if (result_file) write_results(*result_file, results, meshes);
  if (output == Output::json)
    fmt::print("{}\n",
               run_json(run.common.scene, results, {std::nullopt}, meshes).dump(2));
  else
    fmt::print("{}", results_text(results));
  return std::ranges::count(run.expect, results.front().status) > 0
             ? ExitStatus::done
             : ExitStatus::unexpected_status;
}

}  // namespace springcheck
