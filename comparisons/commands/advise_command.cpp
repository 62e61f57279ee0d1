#include "comparisons/commands/advise_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "comparisons/chart/advise.hpp"
#include "comparisons/chart/chart_run.hpp"
#include "comparisons/running/simulate.hpp"
#include "comparisons/settings/named_values.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/sheets/text_table.hpp"
#include "meshing/input_error.hpp"
#include "meshing/output_file.hpp"

namespace springcheck {
namespace {

const char* const first_line = "# Advised by springcheck";

Wish wish_of(const AdviseOptions& options) {
  Wish wish{.measure = ChartMeasure::force,
            .tolerance = 0,
            .budget = options.budget,
            .threads = 1};
  const Given tolerance = Given::from_text("--tolerance", options.tolerance);
  wish.tolerance = tolerance.in(Dimension::fraction);
  if (!(wish.tolerance > 0 && wish.tolerance < 1))
    tolerance.refuse("a number above 0 and below 1, such as 0.08 or '8%'");
  wish.measure = named<ChartMeasure>(Given::from_text("--measure", options.measure));
  if (!options.real_time.empty()) {
    const Given frame = Given::from_text("--real-time", options.real_time);
    wish.frame = frame.in_si_units(Dimension::time).positive_number();
  }
  return wish;
}

/// A result file that is removed in the end.
class TemporaryFile {
 public:
  TemporaryFile() {
    std::string name =
        (std::filesystem::temp_directory_path() / "springcheck-advise-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("no folder could be made beside " + name);
    folder_ = name;
  }
  ~TemporaryFile() {
    std::error_code none;
    std::filesystem::remove_all(folder_, none);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] std::filesystem::path path() const { return folder_ / "advise.h5"; }

 private:
  std::filesystem::path folder_;
};

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
std::string scene_text(const std::string& scene, const std::vector<GivenSetting>& options,
                       const ChartPoint& chosen, const std::string& law,
                       const std::optional<Frame>& frame, const std::string& why) {
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
  if (frame) settings["dt"] = fmt::format("{}", frame->dt);
  std::string text = fmt::format("{}: {}\n", first_line, why);
  for (const auto& [key, value] : settings) text += fmt::format("{} = {}\n", key, value);
  return text;
}

std::vector<std::string> line_of(const std::string& role, const Advice& advice,
                                 const Wish& wish, std::size_t i) {
  const ChartPoint& point = advice.chart.points[i];
  const double error = *point.errors[advice.truth].of(wish.measure);
  const double unsure = *Judge(wish, advice.chart).error(i) - error;
  std::vector<std::string> line{
      role,
      name_of(point.place.model),
      std::to_string(point.place.across),
      fmt::format("{:.0f}", point.place.cells),
      fmt::format("{:.3g} +- {:.2g}", 100 * error, 100 * unsure),
      fmt::format("{:.3g}", *point.seconds())};
  if (wish.frame) {
    const auto frame = frame_of(point, *wish.frame);
    line.push_back(frame ? fmt::format("{:.0f} x {:.3g}", frame->steps, frame->dt)
                         : "none");
    line.push_back(frame ? fmt::format("{:.3g}", frame->seconds()) : "none");
  }
  line.push_back(point.place.key.substr(0, 12));
  return line;
}

/// What the advised steps of a motion, which keep their length, meet on the way; nothing
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

/// The shortest frame that the point can hold, if there is one.
std::string words_of_frame(const ChartPoint& point) {
  constexpr double one_second = 1;  // any time of many steps
  const auto frame = frame_of(point, one_second);
  if (!frame) return {};
  const double real = frame->seconds();
  if (real > 1) return fmt::format("It is {:.3g} times slower than real time.\n", real);
  return fmt::format("It holds frames of {:.2g} s, a step each, and longer ones.\n",
                     real / frame->steps);
}

std::string evidence_text(const Advice& advice, const Wish& wish) {
  TextLines lines{{"", "model", "across", "cells", "off [%]",
                   wish.frame ? "real s per simulated s" : "time [s]"}};
  if (wish.frame) {
    lines[0].emplace_back("steps of a frame [s]");
    lines[0].emplace_back("frame takes [s]");
  }
  lines[0].emplace_back("case");
  for (const auto& [role, point] :
       std::initializer_list<std::pair<const char*, std::optional<std::size_t>>>{
           {"cheaper, too far off", advice.cheaper},
           {"chosen", advice.chosen},
           {"nearest", advice.nearest},
           {"dearer, more accurate", advice.dearer}})
    if (point) lines.push_back(line_of(role, advice, wish, *point));
  return in_columns(lines);
}

/// Where no model could be shown to meet the tolerance.
std::string words_of_bar(const Advice& advice, const Wish& wish) {
  for (std::size_t i = 0; i < advice.chart.points.size(); ++i)
    if (advice.chart.bar(i, wish.measure, advice.truth).value_or(INFINITY) <
        wish.tolerance)
      return {};
  return "Nothing could: the truth itself is not known so well. A finer one (--truth) "
         "takes longer.\n";
}

std::string question(const Advice& advice, const Wish& wish) {
  const ChartTruth& truth = advice.chart.truths[advice.truth];
  const auto& bar = truth.bars.of(wish.measure);
  return fmt::format(
      "{}: {} within {:g} % of the truth of {}{}{}", advice.chart.stored.scene,
      name_of(wish.measure), 100 * wish.tolerance, truth.grids.law,
      bar ? fmt::format(", itself known to {:.2g} %", 100 * *bar) : "",
      wish.frame ? fmt::format(", frames of {:g} s in real time", *wish.frame) : "");
}

}  // namespace

ExitStatus advise_command(const std::string& scene,
                          const std::vector<GivenSetting>& options,
                          const AdviseOptions& given) {
  const Wish wish = wish_of(given);
  const Body body = chart_body(scene, options);
  if (wish.measure == ChartMeasure::deviation && body.shape != BodyShape::block)
    throw InputError("--measure", "",
                     "force or volume for a body whose meshes are not nested",
                     "'deviation'");
  const std::string name = read_scene(scene).name;
  const std::filesystem::path scene_file =
      given.scene_file.empty() ? std::filesystem::path(name + "-advised.toml")
                               : given.scene_file;
  check_scene_file(scene_file);
  for (const std::filesystem::path& other :
       {given.out, std::filesystem::path(read_scene(scene).file)})
    if (std::filesystem::weakly_canonical(scene_file) ==
        std::filesystem::weakly_canonical(other))
      throw InputError("--scene-file", "", "a file that is not read or written otherwise",
                       "'" + scene_file.string() + "'");
  std::optional<TemporaryFile> temporary;
  if (given.out.empty()) temporary.emplace();
  const ChartPlan plan{.scene = scene,
                       .options = options,
                       .threads = {wish.threads},
                       .budget = given.budget,
                       .repeat_for = std::min(1., given.budget),
                       .jobs = given.jobs,
                       .retime = false,
                       .least_models = 0,
                       .truth_across = given.truth_across};
  ChartRun run(plan, temporary ? temporary->path() : given.out);
  const Advice advice = springcheck::advise(wish, plan, run);
  fmt::print("{}\n\n{}", question(advice, wish), evidence_text(advice, wish));
  for (const std::string& caution : advice.cautions)
    fmt::print("\nCaution: {}\n", caution);
  if (!advice.chosen) {
    fmt::print("\nNothing that was tried within {:g} s per solution meets it.\n{}{}",
               given.budget, words_of_bar(advice, wish),
               wish.frame && advice.nearest
                   ? words_of_frame(advice.chart.points[*advice.nearest])
                   : "");
    return ExitStatus::fell_short;
  }
  const ChartPoint& chosen = advice.chart.points[*advice.chosen];
  const auto frame = wish.frame ? frame_of(chosen, *wish.frame) : std::nullopt;
  if (frame)
    if (const std::string caution = caution_of_steps(plan, chosen, *frame);
        !caution.empty())
      fmt::print("\nCaution: {}\n", caution);
  fmt::print("\nLeft out\n");
  for (const std::string& words : advice.left_out) fmt::print("- {}\n", words);
  const std::string text = scene_text(scene, options, chosen, advice.chart.stored.law,
                                      frame, question(advice, wish));
  write_whole_stream(scene_file, [&](std::ostream& out) { out << text; });
  fmt::print("\nRun it: springcheck run {}{}\n", scene_file.has_parent_path() ? "" : "./",
             scene_file.string());
  return ExitStatus::done;
}

}  // namespace springcheck
