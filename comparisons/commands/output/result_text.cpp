#include "comparisons/commands/output/result_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "comparisons/command_line/screen.hpp"
#include "comparisons/commands/output/result_json.hpp"
#include "comparisons/measures/measures.hpp"
#include "comparisons/settings/setting.hpp"

namespace springcheck {
namespace {

/// A measure as a column, in the unit that people read.
struct Shown {
  std::string_view measure, format;
};
constexpr Shown first_measures[] = {{"volume_change", "{:.4f}"},
                                    {"plate_force", "{:.6g}"},
                                    {"plate_force_norm", "{:.6g}"},
                                    {"plate_torque", "{:.6g}"},
                                    {"tip_deflection", "{:.6g}"}},
                last_measures[] = {{"affine_deviation_relative", "{:.3g}"},
                                   {"deviation_l2_relative", "{:.3f}"},
                                   {"solve_wall_s", "{:.2f}"}};

/// A component of the mean stress.
struct StressComponent {
  int row, column;
  const char *key, *heading;
};
constexpr StressComponent stress_components[] = {
    {0, 0, "stress_xx", "stress xx [Pa]"}, {1, 1, "stress_yy", "stress yy [Pa]"},
    {2, 2, "stress_zz", "stress zz [Pa]"}, {1, 2, "stress_yz", "stress yz [Pa]"},
    {0, 2, "stress_xz", "stress xz [Pa]"}, {0, 1, "stress_xy", "stress xy [Pa]"}};

std::vector<Column> columns() {
  std::vector<Column> all{{.key = "method", .heading = "method"},
                          {.key = "status", .heading = "status"}};
  const auto add = [&](std::span<const Shown> shown) {
    for (const auto& [name, format] : shown) {
      const Measure& measure = *find_measure(name);
      all.push_back({.key = std::string(name),
                     .heading = heading_of(measure),
                     .format = std::string(format)});
    }
  };
  add(first_measures);
  all.push_back({.key = "face_z", .heading = "face z [m]", .format = "{:.6g}"});
  for (const StressComponent& component : stress_components)
    all.push_back(
        {.key = component.key, .heading = component.heading, .format = "{:.6g}"});
  add(last_measures);
  return all;
}

std::vector<Cell> cells_of(const CaseResult& result) {
  const Measures& m = result.measures;
  std::vector<Cell> cells{variant_label(result.request.settings), status_words(result)};
  const auto add = [&](std::span<const Shown> shown) {
    for (const auto& [name, format] : shown) {
      Measures::Value value = measure_of(m, name);
      if (value) *value *= shown_factor(*find_measure(name));
      cells.emplace_back(value);
    }
  };
  add(first_measures);
  cells.emplace_back(m.face_displacement ? Measures::Value(m.face_displacement->z())
                                         : std::nullopt);
  for (const auto& [i, j, key, heading] : stress_components)
    cells.emplace_back(m.mean_stress ? Measures::Value((*m.mean_stress)(i, j))
                                     : std::nullopt);
  add(last_measures);
  return cells;
}

void drop_empty_columns(Table& table) {
  for (std::size_t i = table.columns.size(); i-- > 0;) {
    const auto is_empty = [i](const TableRow& row) {
      return !row.cells[i].number && row.cells[i].text.empty();
    };
    if (!std::ranges::all_of(table.rows, is_empty)) continue;
    const auto place = static_cast<std::ptrdiff_t>(i);
    table.columns.erase(table.columns.begin() + place);
    for (TableRow& row : table.rows) row.cells.erase(row.cells.begin() + place);
  }
}

Colour colour_of_statuses(std::string_view head, std::string_view cell) {
  if (head != "status") return Colour::usual;
  const auto is = [&](Status status) { return cell == name_of(status); };
  if (is(Status::ok)) return Colour::good;
  const bool is_held = cell.starts_with(name_of(Status::ok)) || is(Status::wrinkled);
  return is_held ? Colour::doubtful : Colour::bad;
}

std::string stable_up_to(const Solution& solution) {
  if (!solution.dt_limit) return {};
  if (*solution.dt_limit == 0) return " (no step is stable)";
  return fmt::format(" (stable up to {:.4g} s)", *solution.dt_limit);
}

/// Says how many samples are lacking, if any: where they were asked for closer together
/// than steps, there is one a step.
std::string lacking_samples(const CaseResult& result) {
  const auto asked = static_cast<std::size_t>(result.request.settings.dynamics.history);
  const std::size_t taken = result.history.size();
  if (taken >= asked) return {};
  return fmt::format("; {} samples of {} asked for, one a step", taken, asked);
}

/// How a case went through time, in words; empty where it did not.
std::string dynamics_text(const CaseResult& result) {
  const Measures& m = result.measures;
  const Solution& solution = result.solution;
  if (!m.kinetic_energy || !solution.dt) return {};
  const CaseSettings& settings = result.request.settings;
  const std::string inertia =
      settings.method.is_elastic
          ? fmt::format(
                "{:.3g} runs of a pressure wave through the height, damping {:g}, ",
                m.transit_count.value_or(0), settings.dynamics.damping_ratio)
          : "";  // no modulus for a pressure wave, nor that damping
  const std::string energies =
      m.strain_energy ? fmt::format("kinetic energy {:.2g} of the strain energy",
                                    *m.kinetic_energy / *m.strain_energy)
                      : "strain energy infinite";
  return fmt::format("{}: {} {} of {:.4g} s to {:g} s{}, {}{}{}.",
                     variant_label(settings), solution.steps,
                     solution.steps == 1 ? "step" : "steps", *solution.dt,
                     settings.dynamics.duration, stable_up_to(solution), inertia,
                     energies, lacking_samples(result));
}

/// Says at what load bodies at rest are held beside a motion that ends below the whole
/// one.
std::string last_load_text(const std::vector<CaseResult>& results) {
  const bool any_at_rest = std::ranges::any_of(results, [](const CaseResult& result) {
    const auto& [settings, reference, grid, why] = result.request;
    return !has_history(settings) || (reference && !has_history(*reference));
  });
  if (!any_at_rest) return {};
  for (const CaseResult& result : results) {
    const double last = last_load(result.request.settings.dynamics);
    if (has_history(result.request.settings) && last != 1 && last != 0)
      return fmt::format(
          "The load ends at {:g} % of the whole one: bodies at rest are held at that.",
          100 * last);
  }
  return {};
}

/// What deviations are measured from, and what is to be known of it; empty without a
/// reference.
std::vector<std::string> notes_on_reference(const std::vector<CaseResult>& results) {
  const auto has_deviation = [](const CaseResult& result) {
    return result.request.reference &&
           result.measures.mean_deviation;  // or the reason tells
  };
  const auto found = std::ranges::find_if(results, has_deviation);
  if (found == results.end()) return {};
  const std::string reference = reference_label(found->request);
  const Measures& m = found->measures;
  std::vector<std::string> notes{fmt::format(
      "Deviations are from {}{}{}{}.", reference,
      reference.find('@') == std::string::npos ? " on the same mesh" : "",
      m.reference_bar ? fmt::format(", mean error bound {:.2g} m", *m.reference_bar) : "",
      m.reference_order ? fmt::format(", order {:.2f}", *m.reference_order) : "")};
  const CaseSettings& by = *found->request.reference;
  if (const std::string caution = caution_near_half(by.method, by); !caution.empty())
    notes.push_back("Caution: " + caution);
  return notes;
}

/// The table's notes, and before them those of its rows behind the methods' names.
std::string text_of_notes(const Table& table, const Screen& screen) {
  std::string text;
  for (const TableRow& row : table.rows)
    for (const std::string& note : row.notes)
      text += in_lines(row.cells.front().text + ": " + note, screen) + "\n";
  for (const std::string& note : table.notes) text += in_lines(note, screen) + "\n";
  return text;
}

}  // namespace

Table results_table(const std::string& scene, const std::vector<CaseResult>& results) {
  Table table{.name = "run", .title = scene, .columns = columns()};
  const auto note = [&](const std::string& text) {
    if (!text.empty()) table.notes.push_back(text);
  };
  for (const CaseResult& result : results) {
    table.rows.push_back({.cells = cells_of(result), .cases = {result.key}});
    if (!result.reason.empty()) table.rows.back().notes = {result.reason};
  }
  for (const CaseResult& result : results) note(dynamics_text(result));
  for (const CaseResult& result : results)
    if (!result.revision.empty())
      note(fmt::format("{}: computed by revisions {} of the numerics, as accepted.",
                       variant_label(result.request.settings), result.revision));
  note(last_load_text(results));
  for (const std::string& text : notes_on_reference(results)) note(text);
  drop_empty_columns(table);
  return table;
}

void print_results(const std::string& scene, const std::vector<CaseResult>& results,
                   const std::vector<std::optional<Split>>& splits,
                   const std::optional<TableFormat>& format, MeshStore& meshes) {
  if (format == TableFormat::json) {
    fmt::print("{}\n", run_json(scene, results, splits, meshes).dump(2));
    return;
  }
  const Table table = results_table(scene, results);
  const Screen screen = screen_of_output(colour_of_statuses);
  if (format)
    fmt::print("{}", format_table(table, *format));
  else
    fmt::print("{}{}", table_in_columns(table, screen), text_of_notes(table, screen));
}

}  // namespace springcheck
