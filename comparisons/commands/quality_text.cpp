#include "comparisons/commands/quality_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "comparisons/formats/text_table.hpp"

namespace springcheck {
namespace {

std::vector<std::string> row(std::string_view name, const CellQuality& cells) {
  return {std::string(name),
          fmt::format("{}", cells.cells),
          fmt::format("{:.6g}", cells.volume),
          fmt::format("{:.3g}", cells.smallest_volume),
          fmt::format("{:.3g}", cells.mean_volume),
          fmt::format("{:.3g}", cells.largest_volume),
          fmt::format("{:.3f}", cells.smallest_scaled_jacobian),
          fmt::format("{:.3f}", cells.mean_scaled_jacobian),
          fmt::format("{:.2f}", cells.largest_edge_ratio),
          fmt::format("{:.2f}", cells.mean_edge_ratio)};
}

}  // namespace

std::string quality_text(const Quality& quality) {
  std::vector<std::vector<std::string>> rows{{"cells", "number", "volume m^3", "smallest",
                                              "mean", "largest", "scaled Jacobian min",
                                              "mean", "edge ratio max", "mean"}};
  for (const auto& [type, cells] : quality.by_type)
    rows.push_back(row(name_of(type), cells));
  if (quality.by_type.size() > 1) rows.push_back(row("all", quality.all));
  std::string text = in_columns(rows) + "\nscaled Jacobian   cells\n";
  constexpr std::size_t longest_bar = 50;
  const auto& histogram = quality.all.histogram;
  const std::size_t most = std::max<std::size_t>(1, *std::ranges::max_element(histogram));
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    const std::string bar((longest_bar * histogram[i] + most - 1) / most, '#');
    text += fmt::format("{:.1f} to {:.1f}  {:>12}{}{}\n", static_cast<double>(i) / 10,
                        static_cast<double>(i + 1) / 10, histogram[i],
                        bar.empty() ? "" : "  ", bar);
  }
  return text;
}

}  // namespace springcheck
