#include "comparisons/commands/result_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "comparisons/formats/text_table.hpp"
#include "comparisons/measures/measures.hpp"
#include "comparisons/settings/setting.hpp"

namespace springcheck {
namespace {

/// A measure as a column: before and behind the components of vectors and matrices.
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

std::vector<std::string> heads() {
  std::vector<std::string> heads{"method", "status"};
  const auto add = [&](std::span<const Shown> shown) {
    for (const auto& [name, format] : shown) {
      const Measure& measure = *find_measure(name);
      heads.push_back(fmt::format("{} {}", measure.label, shown_unit(measure)));
    }
  };
  add(first_measures);
  for (const char* component :
       {"face z m", "stress xx Pa", "yy Pa", "zz Pa", "yz Pa", "xz Pa", "xy Pa"})
    heads.emplace_back(component);
  add(last_measures);
  return heads;
}

std::vector<std::string> row_of(const CaseResult& result) {
  const Measures& m = result.measures;
  std::vector<std::string> row{variant_label(result.request.settings),
                               status_words(result)};
  const auto number = [](const Measures::Value& value, std::string_view format) {
    return value ? fmt::format(fmt::runtime(format), *value) : "-";
  };
  const auto add = [&](std::span<const Shown> shown) {
    for (const auto& [name, format] : shown) {
      Measures::Value value = measure_of(m, name);
      if (value) *value *= shown_factor(*find_measure(name));
      row.push_back(number(value, format));
    }
  };
  add(first_measures);
  row.push_back(number(
      m.face_displacement ? Measures::Value(m.face_displacement->z()) : std::nullopt,
      "{:.6g}"));
  constexpr std::pair<int, int> components[] = {{0, 0}, {1, 1}, {2, 2},
                                                {1, 2}, {0, 2}, {0, 1}};
  for (const auto& [i, j] : components)
    row.push_back(
        number(m.mean_stress ? Measures::Value((*m.mean_stress)(i, j)) : std::nullopt,
               "{:.6g}"));
  add(last_measures);
  return row;
}

std::string stable_up_to(const Solution& solution) {
  if (!solution.dt_limit) return {};
  if (*solution.dt_limit == 0) return " (no step is stable)";
  return fmt::format(" (stable up to {:.4g} s)", *solution.dt_limit);
}

/// Of samples asked for closer together than steps, there is one a step.
std::string lacking_samples(const CaseResult& result) {
  const auto asked = static_cast<std::size_t>(result.request.settings.dynamics.history);
  const std::size_t taken = result.history.size();
  if (taken >= asked) return {};
  return fmt::format("; {} samples of {} asked for, one a step", taken, asked);
}

/// How a case went through time, if it did.
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
  return fmt::format("{}: {} {} of {:.4g} s to {:g} s{}, {}{}{}.\n",
                     variant_label(settings), solution.steps,
                     solution.steps == 1 ? "step" : "steps", *solution.dt,
                     settings.dynamics.duration, stable_up_to(solution), inertia,
                     energies, lacking_samples(result));
}

/// At what load bodies at rest are held beside a motion that ends below the whole one.
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
          "The load ends at {:g} % of the whole one: bodies at rest are held at that.\n",
          100 * last);
  }
  return {};
}

}  // namespace

std::string results_text(const std::vector<CaseResult>& results) {
  std::vector<std::vector<std::string>> rows{heads()};
  for (const CaseResult& result : results) rows.push_back(row_of(result));
  std::string text = in_columns(without_empty_columns(std::move(rows), "-"));
  for (const CaseResult& result : results)
    if (!result.reason.empty())
      text +=
          fmt::format("{}: {}\n", variant_label(result.request.settings), result.reason);
  for (const CaseResult& result : results) text += dynamics_text(result);
  for (const CaseResult& result : results)
    if (!result.revision.empty())
      text += fmt::format("{}: computed by revisions {} of the numerics, as accepted.\n",
                          variant_label(result.request.settings), result.revision);
  text += last_load_text(results);
  for (const CaseResult& result : results)
    if (result.request.reference) {
      const std::string reference = reference_label(result.request);
      const Measures& m = result.measures;
      if (!m.mean_deviation) continue;  // the reason tells
      text += fmt::format(
          "Deviations are from {}{}{}{}.\n", reference,
          reference.find('@') == std::string::npos ? " on the same mesh" : "",
          m.reference_bar ? fmt::format(", mean error bound {:.2g} m", *m.reference_bar)
                          : "",
          m.reference_order ? fmt::format(", order {:.2f}", *m.reference_order) : "");
      const CaseSettings& by = *result.request.reference;
      if (const std::string caution = caution_near_half(by.method, by); !caution.empty())
        text += fmt::format("Caution: {}\n", caution);
      break;
    }
  return text;
}

}  // namespace springcheck
