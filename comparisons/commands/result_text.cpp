#include "comparisons/commands/result_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/settings/setting.hpp"
#include "comparisons/sheets/text_table.hpp"

namespace springcheck {
namespace {

std::string shown(const std::optional<double>& value, const char* format,
                  double factor = 1) {
  return value ? fmt::format(fmt::runtime(format), factor * *value) : "-";
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
  std::vector<std::vector<std::string>> rows{
      {"method", "status", "volume change %", "plate force N", "resultant N",
       "torque N m", "tip m", "face z m", "stress xx Pa", "yy Pa", "zz Pa", "yz Pa",
       "xz Pa", "xy Pa", "affine deviation %", "deviation L2 %", "solve s"}};
  for (const CaseResult& result : results) {
    const Measures& m = result.measures;
    const auto stress = [&](Eigen::Index i, Eigen::Index j) {
      return shown(m.mean_stress ? Measures::Value((*m.mean_stress)(i, j)) : std::nullopt,
                   "{:.6g}");
    };
    rows.push_back(
        {variant_label(result.request.settings), status_words(result),
         shown(m.volume_change, "{:.4f}", 100), shown(m.plate_force, "{:.6g}"),
         shown(m.plate_force_norm, "{:.6g}"), shown(m.plate_torque, "{:.6g}"),
         shown(m.tip_deflection, "{:.6g}"),
         m.face_displacement ? fmt::format("{:.6g}", m.face_displacement->z()) : "-",
         stress(0, 0), stress(1, 1), stress(2, 2), stress(1, 2), stress(0, 2),
         stress(0, 1), shown(m.affine_deviation_relative, "{:.3g}", 100),
         shown(m.deviation_l2_relative, "{:.3f}", 100),
         result.request.settings.method.solve ? fmt::format("{:.2f}", result.solve_wall_s)
                                              : "-"});
  }
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
