#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>

#include "comparisons/advice/advice_text.hpp"
#include "comparisons/advice/advise.hpp"
#include "comparisons/advice/chart_measurements.hpp"
#include "comparisons/command_line/options.hpp"
#include "comparisons/command_line/screen.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/options/chart_options.hpp"
#include "comparisons/commands/options/computing.hpp"
#include "comparisons/commands/options/input_options.hpp"
#include "comparisons/commands/options/interrupted.hpp"
#include "comparisons/commands/options/setting_options.hpp"
#include "comparisons/running/simulate.hpp"
#include "comparisons/settings/named_values.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/system/temporary_folder.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/output_file.hpp"

namespace springcheck {
namespace {

const char* const first_line = "# Advised by springcheck";

struct AdviseOptions {
  std::string scene{};
  SettingOptions settings{};
  std::string tolerance{};              // "0.08" or "8%"
  std::vector<std::string> measures{};  // force, volume, deviation; empty: all there are
  std::string law{};                    // of the truth; empty: the scene's
  std::string real_time{};              // [s] of a frame; empty: an equilibrium is wanted
  double budget = 20;                   // [s] that a solution may take
  std::filesystem::path out{};          // result file; empty: none is kept
  std::filesystem::path scene_file{};   // empty: NAME-advised.toml
  std::optional<int> truth_across{};    // see truth_grids
  std::optional<TableFormat> format{};
  int jobs = all_cores();  // truths at once, at most
};

/// The measures that are asked for, or all that bodies of this kind have.
std::vector<ChartMeasure> measures_of(const std::vector<std::string>& names,
                                      const Body& body) {
  std::vector<ChartMeasure> measures;
  for (const std::string& name : names) {
    const auto measure = named<ChartMeasure>(Given::from_text("--measure", name));
    if (std::ranges::count(measures, measure) == 0) measures.push_back(measure);
    if (measure == ChartMeasure::deviation && !is_nested(body))
      throw InputError("--measure", "",
                       "force or volume for a body whose meshes are not nested",
                       "'deviation'");
  }
  if (!measures.empty()) return measures;
  measures = {ChartMeasure::force, ChartMeasure::volume};
  if (is_nested(body)) measures.push_back(ChartMeasure::deviation);
  return measures;
}

Wish wish_of(const AdviseOptions& options, const Body& body) {
  Wish wish{.measures = measures_of(options.measures, body),
            .tolerance = 0,
            .budget = options.budget,
            .threads = 1};
  const Given tolerance = Given::from_text("--tolerance", options.tolerance);
  wish.tolerance = tolerance.in(Dimension::fraction);
  if (!(wish.tolerance > 0 && wish.tolerance < 1))
    tolerance.refuse("a number above 0 and below 1, such as 0.08 or '8%'");
  if (!options.real_time.empty()) {
    const Given frame = Given::from_text("--real-time", options.real_time);
    wish.frame = frame.in_si_units(Dimension::time).positive_number();
  }
  return wish;
}

/// Refuses a file that somebody else wrote.
void check_scene_file(const std::filesystem::path& file) {
  if (file.extension() != ".toml")
    throw InputError("--scene-file", "", "a name that ends in .toml",
                     "'" + file.string() + "'");
  check_writable(file);
  std::ifstream in(file);
  std::string line;
  if (in && std::getline(in, line) && !line.starts_with(first_line))
    throw InputError(file.string(), "", "the scene of earlier advice, or none",
                     "another file, which would be lost");
}

/// The scene with what the chosen point changes, beside the law that it is judged by.
std::string scene_text(const std::string& scene, const GivenSettings& options,
                       const ChartPoint& chosen, const std::string& law,
                       const std::string& time_step, const std::string& why) {
  std::map<std::string, std::string> settings;
  for (const GivenSetting& setting : read_scene(scene).settings)
    if (!is_chosen_by_charts(setting.key)) settings[setting.key] = setting.value.toml();
  for (const GivenSetting& option : options) {
    const int group = find_setting(option.key)->replaces;
    for (const Setting& other : all_settings())
      if (group != 0 && other.replaces == group) settings.erase(std::string(other.key));
    settings[option.key] = option.value.toml();
  }
  const Body body = chart_body(scene, options);
  const ChartModel& model = chart_model(chosen.place.model, body.shape);
  for (const auto& [key, value] : model.changes) settings[key] = value.toml();
  const Cells cells = cells_across(body.block.size, chosen.place.across);
  settings["cells"] = fmt::format("[{}, {}, {}]", cells[0], cells[1], cells[2]);
  settings["reference"] = Given::from_text("advise", law).toml();
  if (!time_step.empty()) settings["dt"] = time_step;
  std::string text = fmt::format("{}: {}\n", first_line, why);
  for (const auto& [key, value] : settings) text += fmt::format("{} = {}\n", key, value);
  return text;
}

/// What the advised steps of a motion, which keep their length, meet on the way; empty
/// where all is well.
std::string caution_of_steps(const ChartPlan& plan, const ChartPoint& chosen,
                             const Frame& frame) {
  CaseSettings settings = settings_of(plan, chosen.place);
  settings.dynamics.time_step = frame.dt;
  const CaseResult result = simulate(settings, build_mesh(settings.body));
  if (result.status == Status::ok && result.reason.empty()) return {};
  return fmt::format("with steps of {:.3g} s it is {}{}", frame.dt,
                     name_of(result.status),
                     result.reason.empty() ? "" : ": " + result.reason);
}

/// The file that the advised scene goes to. Throws InputError where something else would
/// be lost.
std::filesystem::path scene_file_of(const AdviseOptions& options) {
  const SceneFile scene = read_scene(options.scene);
  const std::filesystem::path scene_file =
      options.scene_file.empty() ? std::filesystem::path(scene.name + "-advised.toml")
                                 : options.scene_file;
  check_scene_file(scene_file);
  for (const std::filesystem::path& other :
       {options.out, std::filesystem::path(scene.file)})
    if (std::filesystem::weakly_canonical(scene_file) ==
        std::filesystem::weakly_canonical(other))
      throw InputError("--scene-file", "", "a file that is not read or written otherwise",
                       "'" + scene_file.string() + "'");
  return scene_file;
}

ChartPlan plan_of(const AdviseOptions& options, const GivenSettings& settings,
                  int threads) {
  return {.scene = options.scene,
          .options = settings,
          .law = truth_law_named(options.law),
          .threads = {threads},
          .budget = options.budget,
          .repeat_for = std::min(1., options.budget),
          .jobs = options.jobs,
          .retime = false,
          .least_models = 0,
          .truth_across = options.truth_across,
          .truths_file = users_truths_file()};
}

/// What is said beside the evidence.
struct Said {
  std::vector<std::string> cautions{};
  std::vector<std::string> left_out{};
  std::string failure{};               // where nothing is advised
  std::filesystem::path scene_file{};  // where something is advised
};

std::string run_it(const std::filesystem::path& scene_file) {
  return fmt::format("Run it: springcheck run {}{}",
                     scene_file.has_parent_path() ? "" : "./", scene_file.string());
}

void print_text(const Advice& advice, const Wish& wish, const Said& said) {
  const Screen screen = screen_of_output();
  const auto print = [&](const std::string& text) {
    fmt::print("{}\n", in_lines(text, screen));
  };
  Table table = evidence_table(advice, wish);
  table.columns.push_back({.key = "case", .heading = "case"});
  for (TableRow& row : table.rows)
    row.cells.emplace_back(row.cases.front().substr(0, 12));
  print(question(advice, wish));
  print(truth_text(advice));
  fmt::print("\n{}", table_in_columns(table, screen));
  const std::vector<std::string> notes = notes_on_evidence(advice);
  if (!notes.empty()) fmt::print("\n");
  for (const std::string& note : notes) print(note);
  for (const std::string& caution : said.cautions) {
    fmt::print("\n");
    print("Caution: " + caution);
  }
  if (!said.failure.empty()) {
    fmt::print("\n");
    print(said.failure);
    return;
  }
  fmt::print("\nLeft out\n");
  for (const std::string& words : said.left_out) print("- " + words);
  fmt::print("\n{}\n", run_it(said.scene_file));
}

void print_formatted(const Advice& advice, const Wish& wish, const Said& said,
                     TableFormat format) {
  Table table = evidence_table(advice, wish);
  table.in_json["cautions"] = said.cautions;
  table.in_json["left_out"] = said.left_out;
  if (advice.chosen) table.in_json["scene_file"] = said.scene_file.string();
  table.notes = notes_on_evidence(advice);
  table.notes.insert(table.notes.begin(), truth_text(advice));
  for (const std::string& caution : said.cautions)
    table.notes.push_back("Caution: " + caution);
  for (const std::string& words : said.left_out)
    table.notes.push_back("Left out: " + words);
  table.notes.push_back(said.failure.empty() ? run_it(said.scene_file) : said.failure);
  fmt::print("{}", format_table(table, format));
}

/// Writes the scene of the chosen point, and says what is to be known of it.
void write_advised_scene(const AdviseOptions& options, const Advice& advice,
                         const Wish& wish, const ChartPlan& plan,
                         const std::filesystem::path& scene_file, Said& said) {
  const ChartPoint& chosen = advice.chart.points[*advice.chosen];
  std::string time_step;
  if (wish.frame) {
    const Frame frame = frame_of(chosen, *wish.frame).value();
    time_step = fmt::format("{}", frame.dt);
    if (const std::string caution = caution_of_steps(plan, chosen, frame);
        !caution.empty())
      said.cautions.push_back(caution);
  }
  said.left_out = advice.left_out;
  said.scene_file = scene_file;
  const std::string text =
      scene_text(options.scene, options.settings.given(), chosen, advice.chart.stored.law,
                 time_step, question(advice, wish));
  write_whole_stream(scene_file, [&](std::ostream& out) { out << text; });
}

/// Advises the cheapest model of a scene that meets a tolerance, with its neighbours and
/// a scene file that runs it. Where none does it tells what comes closest, and ends with
/// fell_short.
ExitStatus advise_scene(const AdviseOptions& options) {
  const Computing computing(std::max(options.jobs, all_cores()), options.jobs);
  const GivenSettings settings = options.settings.given();
  const Wish wish = wish_of(options, chart_body(options.scene, settings));
  const std::filesystem::path scene_file = scene_file_of(options);
  std::optional<TemporaryFolder> temporary;
  if (options.out.empty()) temporary.emplace("advise");
  const ChartPlan plan = plan_of(options, settings, wish.threads);
  const BeforeInterruption kept = tell_when_interrupted([&options] {
    return options.out.empty()
               ? std::string("Converged solutions are kept; --out FILE keeps the rest.")
               : fmt::format(
                     "What was complete is in {}. The same command goes on from "
                     "there.",
                     options.out.string());
  });
  ChartMeasurements measurements(
      plan, temporary ? temporary->path() / "advise.h5" : options.out);
  const Advice advice = advise(wish, plan, measurements);
  Said said{.cautions = advice.cautions};
  if (const std::string of_law = caution_of_truth(plan); !of_law.empty())
    said.cautions.push_back(of_law + " Another is taken by --converged-law.");
  if (advice.chosen)
    write_advised_scene(options, advice, wish, plan, scene_file, said);
  else
    said.failure = failure_text(advice, wish);
  if (options.format)
    print_formatted(advice, wish, said, *options.format);
  else
    print_text(advice, wish, said);
  return advice.chosen ? ExitStatus::done : ExitStatus::fell_short;
}

Action declare_advise(CLI::App& parser) {
  const auto options = std::make_shared<AdviseOptions>();
  constexpr auto of_wish = "what is wished for";
  add_scene(parser, options->scene);
  parser
      .add_option("--tolerance", options->tolerance, "largest error, such as 0.08 or 8%")
      ->required()
      ->type_name("FRACTION")
      ->group(of_wish);
  parser
      .add_option("--measure", options->measures,
                  "of what: force (torque, or a tip's drop), volume, deviation (the "
                  "shape); several with commas between (default: all that the body has)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("force|volume|deviation")
      ->group(of_wish);
  parser
      .add_option("--real-time", options->real_time,
                  "seconds of a frame of motion that must be simulated in as many "
                  "(default: an equilibrium is wanted)")
      ->type_name("SECONDS")
      ->group(of_wish);
  add_seconds(parser, "--budget", options->budget, false,
              "seconds that a solution may take")
      ->group(of_wish);
  add_converged_across(parser, options->truth_across)->group(of_wish);
  add_converged_law(parser, options->law)->group(of_wish);
  options->settings.add_to(parser, is_taken_by_charts);
  add_path(parser, "--out", options->out, "FILE",
           "HDF5 file to keep what was measured in, and to take it from")
      ->group(of_output);
  add_path(parser, "--scene-file", options->scene_file, "FILE",
           "the scene file to write (default SCENE-advised.toml)")
      ->group(of_output);
  add_formats(parser, options->format);
  add_jobs(parser, options->jobs, "converged solutions' grids");
  return [options] { return advise_scene(*options); };
}

}  // namespace

Command advise_command() {
  return {.name = "advise",
          .summary = "Find the cheapest model of a scene that meets a tolerance",
          .description = "Writes a scene file that runs it.",
          .examples = {{"springcheck advise compression --tolerance 5%",
                        "the fastest equilibrium with errors of at most 5 %"},
                       {"springcheck advise shearing --tolerance 8% --measure force "
                        "--real-time 0.02",
                        "what follows 50 frames a second, if anything does"}},
          .declare = declare_advise};
}

}  // namespace springcheck
