#include "comparisons/commands/command_line.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <thread>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/commands/advise_command.hpp"
#include "comparisons/commands/chart_command.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/export_command.hpp"
#include "comparisons/commands/gate_command.hpp"
#include "comparisons/commands/measure_command.hpp"
#include "comparisons/commands/report_command.hpp"
#include "comparisons/commands/reproduce.hpp"
#include "comparisons/commands/stability_command.hpp"
#include "comparisons/commands/sweep_command.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/settings/suggestion.hpp"
#include "comparisons/studies/study.hpp"
#include "comparisons/system/blas.hpp"
#include "comparisons/system/environment.hpp"
#include "comparisons/system/memory.hpp"
#include "meshing/input_error.hpp"
#include "meshing/text.hpp"

namespace springcheck {
namespace {

/// The settings among a subcommand's options that were given, as text.
class SettingOptions {
 public:
  explicit SettingOptions(CLI::App* command, bool (*is_taken)(const Setting&)) {
    command->footer(
        "Values of a list have commas between them. Numbers are in SI units, or carry a "
        "unit: 10kPa, 5cm, 20ms, 5%, 45deg.");
    for (const Setting& setting : all_settings()) {
      if (!is_option(setting) || !is_taken(setting)) continue;
      const std::string name(setting.key), option = "--" + name;
      options_[name] = setting.access.type.kind == ValueType::Kind::truth
                           ? command->add_flag(option)->description(help_of(setting))
                           : command->add_option(option, texts_[name], help_of(setting));
    }
  }

  [[nodiscard]] std::vector<GivenSetting> given() const {
    std::vector<GivenSetting> settings;
    for (const auto& [name, option] : options_)
      if (option->count() > 0)
        settings.push_back(
            {name, Given::from_text("--" + name,
                                    texts_.contains(name) ? texts_.at(name) : "true")});
    return settings;
  }

 private:
  std::map<std::string, CLI::Option*> options_;
  std::map<std::string, std::string> texts_;
};

bool is_any(const Setting&) {
  return true;
}

bool is_no_method(const Setting& setting) {
  return setting.key != "method" && setting.key != "element";
}

bool is_taken_by_charts(const Setting& setting) {
  return setting.in_charts == InCharts::taken;
}

TableFormat table_format(const std::string& name) {
  if (name == "md") return TableFormat::markdown;
  if (name == "csv") return TableFormat::csv;
  if (name == "json") return TableFormat::json;
  if (name == "latex") return TableFormat::latex;
  throw InputError("--format", "", "one of md, csv, json, latex", "'" + name + "'");
}

FailOn fail_on_named(const std::string& name) {
  if (const auto* found = find_value<FailOn>(name)) return found->value;
  throw InputError("--fail-on", "", "one of any, all, none", "'" + name + "'");
}

std::optional<std::filesystem::path> path_or_none(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return text;
}

/// For options that are left out or hold something.
std::string check_not_empty(const std::string& text) {
  return text.empty() ? "expected a path, got ''" : "";
}

std::string check_seconds(const std::string& text) {
  char* end = nullptr;
  const double seconds = std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == '\0' && seconds >= 0) return "";
  return "expected a number of seconds, 0 or more, got '" + text + "'";
}

std::string check_positive_seconds(const std::string& text) {
  if (check_seconds(text).empty() && std::strtod(text.c_str(), nullptr) > 0) return "";
  return "expected a number of seconds above 0, got '" + text + "'";
}

/// All of them may come to stand in JSON and HDF5.
void check_utf8(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (!is_utf8(argv[i]))
      throw InputError("springcheck", fmt::format("argument {}", i), "text in UTF-8",
                       fmt::format("other bytes: {}", quotation(argv[i])));
}

/// The command that the first word names; nullptr where it is an option or nothing.
/// Throws InputError for another word, where CLI11 would only ask for a command.
const CLI::App* command_named(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return nullptr;
  std::vector<std::string_view> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == argv[1]) return command;
    names.push_back(command->get_name());
  }
  refuse_name("springcheck", "command", argv[1], names);
}

/// Refuses an option that the command does not have: CLI11 would name its value, too.
void check_options(const CLI::App& command, int argc, char** argv) {
  std::vector<std::string> options{"--verbose"};
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  const std::vector<std::string_view> names(options.begin(), options.end());
  for (int i = 2; i < argc; ++i) {
    const std::string_view word(argv[i]);
    if (word == "--" || word == "--help") return;
    if (!word.starts_with("--")) continue;
    const std::string_view name = word.substr(0, word.find('='));
    if (std::ranges::count(names, name) == 0)
      refuse_name("springcheck " + command.get_name(), "option", name, names);
  }
}

/// Where the address space is limited (ulimit -v): refuses what OpenBLAS could not work
/// in, and takes what it needs.
void check_address_space(int threads) {
  constexpr double for_all_else = 50e6;
  const double room = room_of_address_space();
  if (std::isinf(room)) return;
  const double needed = threads * blas_buffer_bytes + for_all_else;
  if (room < needed)
    throw InputError("springcheck", "address space (ulimit -v)",
                     fmt::format("{:.2g} GB more for {} threads (see --help for fewer)",
                                 needed / 1e9, threads),
                     fmt::format("{:.2g} GB", room / 1e9));
  reserve_blas_buffers(threads);
}

/// What was printed must have arrived: a full disk or a closed pipe is a failure.
void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw std::runtime_error("standard output could not be written whole");
}

int run_arguments(int argc, char** argv) {
  restart_with_one_blas_thread(argv);
  check_utf8(argc, argv);
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  CLI::App app("Compares mass-spring soft-tissue models with finite elements.");
  app.require_subcommand(1);
  const std::string version =
      std::string("springcheck ") + build_info::version + " (" + build_info::commit + ")";
  bool verbose = false;
  app.add_flag("--verbose", verbose, "log every Newton iteration to stderr");

  std::vector<std::filesystem::path> from;
  std::string scene, out, name, reference, format = "md", what, results, junit;
  std::string displacements, forces, checkpoint, fail_on;
  Watch watch{.shows_progress = true};
  std::string shard = "1/1";
  SweepOptions sweep_options{.jobs = cores};
  bool json = false, split = false, all = false, bless = false, quality = false;
  int threads = cores;
  int status = ExitStatus::done;
  bool accepts_others = false;
  const auto revisions = [&] { return accepts_others ? Revisions::all : Revisions::own; };
  const auto add_revisions = [&](CLI::App* command, const char* taken) {
    return command->add_flag(
        "--accept-other-revisions", accepts_others,
        std::string(taken) +
            " of other revisions of the numerics are taken, where there are "
            "none of this program's, and what is made of them says so");
  };
  const auto output = [&] { return json ? Output::json : Output::text; };
  const auto add_threads = [&](CLI::App* command) {
    command->add_option("--threads", threads, "at most this many (default: all cores)")
        ->check(CLI::Range(1, 1024));
  };

  CLI::App* run = app.add_subcommand("run", "Run one scene with one or more methods");
  run->add_option("scene", scene, "name of a shipped scene, or a .toml file")->required();
  const SettingOptions run_options(run, is_any);
  run->add_option("--out", out, "HDF5 file for measures and fields")
      ->check(check_not_empty);
  run->add_flag("--split", split,
                "split the errors of spring methods into law and discretisation; runs "
                "finite elements on up to 4 times as many cells along each axis");
  run->add_flag("--json", json, "print one JSON document");
  run->add_option("--fail-on", fail_on,
                  "exit with 3 when a status is not one that the scene expects: of any "
                  "method, of all, or none (default any with one method; none with "
                  "several: they may all fail, and the exit status is 0)");
  CLI::Option* const checkpoint_file =
      run->add_option(
             "--checkpoint", checkpoint,
             "HDF5 file to which dynamics is saved on the way, and from which it "
             "goes on if it is there")
          ->check(check_not_empty);
  run->add_option("--checkpoint-every", watch.seconds_between_checkpoints,
                  "seconds between two savings (default 60)")
      ->check(check_seconds)
      ->needs(checkpoint_file);
  add_revisions(run, "with --checkpoint: saved states")->needs(checkpoint_file);
  add_threads(run);

  CLI::App* table =
      app.add_subcommand("table",
                         "Print one of the thesis's tables beside ours, or one "
                         "of our own");
  CLI::Option* table_name = table->add_option(
      "name", name, "one of those that --list tells, with the minutes that each takes");
  CLI::Option* table_from =
      table
          ->add_option("--from", from,
                       "result files to take cases from; computes the rest")
          ->check(check_not_empty);
  CLI::Option* table_out =
      table->add_option("--out", out, "HDF5 file for the cases behind the table")
          ->check(check_not_empty);
  CLI::Option* table_reference =
      table->add_option("--reference", reference,
                        "METHOD[:ELEMENT][@CELLS|@converged] for the thesis's tables");
  table->add_option("--format", format, "md (default), csv, json or latex");
  bool lists_tables = false;
  CLI::Option* table_list =
      table->add_flag("--list", lists_tables, "print what tables there are instead");
  for (CLI::Option* other : {table_name, table_from, table_out, table_reference})
    table_list->excludes(other);
  add_revisions(table, "cases of --from files");
  add_threads(table);

  CLI::App* everything =
      app.add_subcommand("reproduce", "Regenerate every table and the page");
  everything->add_option("--out", out, "folder for page, tables, results and summary")
      ->required()
      ->check(check_not_empty);
  CLI::Option* all_tables = everything->add_flag(
      "--all", all, "the tables of ten minutes and more too, most of an hour");
  bool quick = false;
  everything->add_flag("--quick", quick, "the thesis's five tests alone, in two minutes")
      ->excludes(all_tables);
  add_threads(everything);

  CLI::App* measure = app.add_subcommand(
      "measure", "Measure what another program computed on a scene's mesh");
  measure->add_option("scene", scene, "name of a shipped scene, or a .toml file")
      ->required();
  const SettingOptions measure_options(measure, is_no_method);
  measure
      ->add_option("--displacements", displacements,
                   ".vtu or .csv file of the nodes' displacements [m]")
      ->required()
      ->check(check_not_empty);
  measure
      ->add_option("--forces", forces,
                   ".csv file of the forces that the plates apply to the nodes [N]")
      ->check(check_not_empty);
  measure->add_option("--label", name, "name that stands for the method")->required();
  measure->add_option("--out", out, "HDF5 file for measures and fields")
      ->check(check_not_empty);
  measure->add_flag("--json", json, "print one JSON document");
  add_threads(measure);

  CLI::App* sweep =
      app.add_subcommand("sweep", "Run the cases of a sweep that a result file lacks");
  sweep->add_option("sweep", name, "name of a shipped sweep, or a .toml file")
      ->required();
  sweep->add_option("--out", out, "HDF5 file to add the cases to")
      ->required()
      ->check(check_not_empty);
  sweep
      ->add_option("--jobs", threads, "simulations at once, at most (default: all cores)")
      ->check(CLI::Range(1, 1024));
  sweep->add_flag("--dry-run", sweep_options.dry_run, "count and estimate only");
  sweep->add_flag("--only-failed", sweep_options.only_failed,
                  "run again what the file holds with a status other than ok");
  sweep->add_flag("--recompute", sweep_options.recompute,
                  "run again all that the file holds");
  sweep->add_option("--shard", shard, "I/N: every N-th case from the I-th on");
  sweep->add_flag("--yes", sweep_options.yes,
                  "more than a million combinations are meant");
  add_revisions(sweep, "cases in the file");

  CLI::App* merge = app.add_subcommand(
      "merge", "Add the cases of result files to another; may be repeated");
  merge->add_option("out", out, "HDF5 file to add to")
      ->required()
      ->check(check_not_empty);
  merge->add_option("from", from, "result files")->required()->check(check_not_empty);

  StabilityOptions stability_options;
  CLI::App* stability = app.add_subcommand(
      "stability", "Map where methods fail over one or two settings, and their limits");
  stability->add_option("scene", scene, "name of a shipped scene, or a .toml file")
      ->required();
  const SettingOptions stability_settings(stability, is_any);
  stability
      ->add_option("--over", stability_options.over,
                   "KEY=FROM:TO:COUNT, KEY=FROM:TO:log:COUNT or KEY=A,B,C, once or "
                   "twice, or KEY[,KEY] over usual "
                   "values; limits are along the first")
      ->required();
  stability->add_option("--out", out, "HDF5 file to add the cases to")
      ->check(check_not_empty);
  stability->add_option("--format", format,
                        "md, csv, json or latex (default: maps and limits)");
  stability->add_flag("--locking", stability_options.locking,
                      "judge locking, too, by a control for every point");
  add_revisions(stability, "cases in the file");
  stability
      ->add_option("--jobs", threads, "simulations at once, at most (default: all cores)")
      ->check(CLI::Range(1, 1024));

  const auto add_truth_law = [](CLI::App* command, std::string& law) {
    command->add_option(
        "--converged-law", law,
        "method of the law whose converged solution errors are told from: " +
            names_of(laws()) + " (default: that of the scene's reference)");
  };
  ChartOptions chart_options;
  CLI::App* chart = app.add_subcommand(
      "chart", "Measure time against accuracy of every model on a scene");
  chart
      ->add_option("scene", scene,
                   "name of a shipped scene, a .toml file, or all: the thesis's five")
      ->required();
  const SettingOptions chart_settings(chart, is_taken_by_charts);
  chart->add_option("--out", chart_options.out, "HDF5 file to add the chart to")
      ->required()
      ->check(check_not_empty);
  chart->add_option("--sizes", chart_options.sizes,
                    "cells across the shortest edge (default 4,6,10,16)");
  chart->add_option("--on-threads", chart_options.threads,
                    "numbers of threads that are timed (default: 1 and all cores)");
  chart
      ->add_option("--budget", chart_options.budget,
                   "seconds that a point's solution may take (default 8)")
      ->check(check_positive_seconds);
  chart
      ->add_option("--repeat-for", chart_options.repeat_for,
                   "seconds for the repetitions of each point (default 1)")
      ->check(check_positive_seconds);
  chart->add_option(
      "--format", format,
      "md, csv, json or latex (default: converged solutions, fronts and claims)");
  chart
      ->add_option("--jobs", threads,
                   "converged solutions' grids at once, at most (default: all cores)")
      ->check(CLI::Range(1, 1024));
  chart
      ->add_option("--converged-across", chart_options.truth_across,
                   "cells across of the coarsest of the three grids of q2 that tell the "
                   "converged solution (default 4; 2 for bodies much longer than wide)")
      ->check(CLI::Range(1, 1000));
  add_truth_law(chart, chart_options.law);
  chart->add_flag("--retime", chart_options.retime,
                  "time again what the file has a time of, and nothing else");
  chart
      ->add_option("--least-models", chart_options.least_models,
                   "models at equilibrium that get to the finest cells and are ok there, "
                   "the cheapest first, whatever the budget (default 12)")
      ->check(CLI::Range(0, 1000));
  CLI::Option* quick_chart = chart->add_flag(
      "--quick", chart_options.quick,
      "the models that people want to see first, on 4, 6 and 10 cells across, beside the "
      "converged solution of the scene's own law alone, in about a minute a scene");
  for (const char* option :
       {"--sizes", "--on-threads", "--budget", "--repeat-for", "--converged-across",
        "--converged-law", "--retime", "--least-models"})
    quick_chart->excludes(chart->get_option(option));

  AdviseOptions advise_options;
  CLI::App* advise = app.add_subcommand(
      "advise", "Find the cheapest model of a scene that meets a tolerance");
  advise->add_option("scene", scene, "name of a shipped scene, or a .toml file")
      ->required();
  const SettingOptions advise_settings(advise, is_taken_by_charts);
  advise
      ->add_option("--tolerance", advise_options.tolerance,
                   "largest error, such as 0.08 or 8%")
      ->required();
  advise
      ->add_option("--measure", advise_options.measures,
                   "of what: force (torque, or a tip's drop), volume, deviation (the "
                   "shape); several with commas between (default: all that the body has)")
      ->delimiter(',')
      ->allow_extra_args(false);
  advise->add_option("--real-time", advise_options.real_time,
                     "seconds of a frame of motion that must be simulated in as many "
                     "(default: an equilibrium is wanted)");
  advise
      ->add_option("--budget", advise_options.budget,
                   "seconds that a solution may take (default 20)")
      ->check(check_positive_seconds);
  advise
      ->add_option("--out", advise_options.out,
                   "HDF5 file to keep what was measured in, and to take it from")
      ->check(check_not_empty);
  advise
      ->add_option("--scene-file", advise_options.scene_file,
                   "the scene file to write (default SCENE-advised.toml)")
      ->check(check_not_empty);
  advise
      ->add_option("--converged-across", advise_options.truth_across,
                   "cells across of the coarsest of the three grids of q2 that tell the "
                   "converged solution (default 4; 2 for bodies much longer than wide)")
      ->check(CLI::Range(1, 1000));
  add_truth_law(advise, advise_options.law);
  advise
      ->add_option("--jobs", threads,
                   "converged solutions' grids at once, at most (default: all cores)")
      ->check(CLI::Range(1, 1024));

  CLI::App* list = app.add_subcommand("list", "List what there is");
  list->add_option("what", what, "one of " + list_names() + " (default: all)");
  list->add_flag("--json", json, "print one JSON document");

  CLI::App* mesh = app.add_subcommand("mesh", "Write the mesh that both solvers use");
  mesh->add_option("scene", scene, "name of a shipped scene, or a .toml file")
      ->required();
  const SettingOptions mesh_options(mesh, is_any);
  mesh->add_option("--out", out, "a .msh, .vtu or .inp file")->check(check_not_empty);
  mesh->add_flag("--quality", quality,
                 "print volumes, scaled Jacobians and edge ratios of the cells");

  CLI::App* schema = app.add_subcommand(
      "schema",
      "Print the JSON schema of a kind of file, by which editors complete and check it");
  schema->add_option("kind", what, "scene, sweep, gate, or result: what --json prints")
      ->required();

  CLI::App* gate = app.add_subcommand("gate", "Judge results by bands, as a CI does");
  gate->add_option("gates", name, "a gate file (.toml), or accuracy or thesis")
      ->required();
  gate->add_option("results", results, "HDF5 file of results")->required();
  gate->add_option("--junit", junit, "JUnit XML file to write")->check(check_not_empty);
  gate->add_flag("--json", json, "print one JSON document");
  gate->add_flag("--bless", bless,
                 "replace stored values that are outside their bands in the gate file");
  add_revisions(gate, "cases in the file");

  CLI::App* report = app.add_subcommand(
      "report", "Make page, figures and tables of a result file; computes nothing");
  report->add_option("results", results, "HDF5 file of results")->required();
  report->add_option("--out", out, "folder for them")->required()->check(check_not_empty);
  add_revisions(report, "cases in the file");

  std::vector<std::string> columns;
  CLI::App* exported = app.add_subcommand(
      "export", "Write the cases of a result file as a table for other programs");
  exported->add_option("results", results, "HDF5 file of results")->required();
  exported->add_option("--out", out, "a .csv, .parquet or .json file")
      ->required()
      ->check(check_not_empty);
  exported
      ->add_option("--columns", columns,
                   "settings, measures and columns of 'springcheck list columns', with "
                   "commas between (default: what differs between cases, and what was "
                   "measured)")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_revisions(exported, "cases in the file");

  app.set_version_flag("--version", version);
  for (CLI::App* command : app.get_subcommands({}))
    command->set_version_flag("--version", version);

  if (const CLI::App* command = command_named(app, argc, argv))
    check_options(*command, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    fmt::print(stderr, "springcheck: {} (see --help)\n", error.what());
    return ExitStatus::bad_input;
  }
  spdlog::set_default_logger(spdlog::stderr_color_mt("springcheck"));
  spdlog::set_level(verbose ? spdlog::level::debug : spdlog::level::warn);
  if (*run || *table || *sweep || *stability || *chart || *advise || *everything) {
    restart_with_fitting_blas(argv);
    check_address_space(threads);
  }
  const ThreadsInUse in_use(*chart || *advise ? std::max(threads, cores) : threads);

  if (*run) {
    watch.checkpoint = path_or_none(checkpoint);
    watch.revisions = revisions();
    status =
        run_command(scene, run_options.given(),
                    {.out = path_or_none(out),
                     .output = output(),
                     .error_split = split ? ErrorSplit::wanted : ErrorSplit::not_wanted,
                     .fail_on = fail_on.empty() ? std::nullopt
                                                : std::optional(fail_on_named(fail_on)),
                     .parallel = threads},
                    watch);
  } else if (*measure)
    status = measure_command(scene, measure_options.given(),
                             {displacements, path_or_none(forces), name},
                             path_or_none(out), output());
  else if (lists_tables)
    status = list_tables_command(table->count("--format") > 0
                                     ? std::optional(table_format(format))
                                     : std::nullopt);
  else if (*table)
    status = table_command(name, {from, path_or_none(out), revisions()}, reference,
                           table_format(format), threads);
  else if (*sweep) {
    sweep_options.jobs = threads;
    sweep_options.revisions = revisions();
    set_shard(sweep_options, shard);
    status = sweep_command(name, out, sweep_options);
  } else if (*stability) {
    stability_options.jobs = threads;
    stability_options.revisions = revisions();
    stability_options.out = path_or_none(out);
    if (stability->count("--format") > 0) stability_options.format = table_format(format);
    status = stability_command(scene, stability_settings.given(), stability_options);
  } else if (*chart) {
    chart_options.jobs = threads;
    if (chart->count("--format") > 0) chart_options.format = table_format(format);
    status = chart_command(scene, chart_settings.given(), chart_options);
  } else if (*advise) {
    advise_options.jobs = threads;
    status = advise_command(scene, advise_settings.given(), advise_options);
  } else if (*merge)
    status = merge_command(out, from);
  else if (*list)
    status = list_command(what, output());
  else if (*schema)
    status = schema_command(what);
  else if (*gate)
    status = gate_command(name, results, path_or_none(junit), output(),
                          bless ? Bless::yes : Bless::no, revisions());
  else if (*mesh)
    status = mesh_command(scene, mesh_options.given(), path_or_none(out),
                          quality ? MeshReport::quality : MeshReport::counts);
  else if (*report)
    status = report_command(results, out, revisions());
  else if (*exported)
    status = export_command(results, out, columns, revisions());
  else
    status = reproduce_command(out,
                               all     ? Extent::all
                               : quick ? Extent::quick
                                       : Extent::without_long_tables,
                               threads);
  flush_output();
  return status;
}

}  // namespace

int command_line(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error like others
  try {
    return run_arguments(argc, argv);
  } catch (const InputError& error) {
    std::string line = error.what();  // what users wrote may hold line ends
    std::ranges::replace_if(
        line, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    fmt::print(stderr, "{}\n", line);
    return ExitStatus::bad_input;
  } catch (const NoAnswer& error) {
    fmt::print(stderr, "springcheck: {}\n", error.what());
    return ExitStatus::unexpected_status;
  } catch (const std::exception& error) {
    fmt::print(stderr, "springcheck: {}\n", error.what());
    return ExitStatus::fell_short;
  }
}

}  // namespace springcheck
