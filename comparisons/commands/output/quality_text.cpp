#include "comparisons/commands/output/quality_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace springcheck {
namespace {

TableRow row_of(std::string_view name, const CellQuality& cells) {
  return {.cells = {name, cells.cells, cells.volume, cells.smallest_volume,
                    cells.mean_volume, cells.largest_volume,
                    cells.smallest_scaled_jacobian, cells.mean_scaled_jacobian,
                    cells.largest_edge_ratio, cells.mean_edge_ratio},
          .in_json = {{"histogram", cells.histogram}}};
}

}  // namespace

Table quality_table(const Quality& quality) {
  const auto column = [](const char* key, const char* heading, const char* format) {
    return Column{.key = key, .heading = heading, .format = format};
  };
  Table table{
      .name = "quality",
      .title = "Cells of the mesh",
      .columns = {column("cells", "cells", ""), column("number", "number", "{:.0f}"),
                  column("volume", "volume m^3", "{:.6g}"),
                  column("volume_min", "smallest m^3", "{:.3g}"),
                  column("volume_mean", "mean m^3", "{:.3g}"),
                  column("volume_max", "largest m^3", "{:.3g}"),
                  column("scaled_jacobian_min", "scaled Jacobian min", "{:.3f}"),
                  column("scaled_jacobian_mean", "scaled Jacobian mean", "{:.3f}"),
                  column("edge_ratio_max", "edge ratio max", "{:.2f}"),
                  column("edge_ratio_mean", "edge ratio mean", "{:.2f}")}};
  for (const auto& [type, cells] : quality.by_type)
    table.rows.push_back(row_of(name_of(type), cells));
  if (quality.by_type.size() > 1) table.rows.push_back(row_of("all", quality.all));
  return table;
}

std::string histogram_text(const Quality& quality) {
  std::string text = "scaled Jacobian   cells\n";
  constexpr std::size_t longest_bar = 30;
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
