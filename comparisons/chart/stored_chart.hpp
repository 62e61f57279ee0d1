#pragma once

#include <hdf5.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/chart/chart_models.hpp"
#include "comparisons/chart/timing.hpp"

namespace springcheck {

/// What `springcheck chart` measured of a scene, as a result file keeps it: times, and
/// the keys of the cases by which errors are told.
struct StoredChart {
  /// Three grids of q2, from coarse to fine; their limit is the law's truth.
  struct Truth {
    std::string law;  // its method
    std::array<double, 3> cell_sizes;
    std::array<std::string, 3> keys;
  };
  struct Point {
    std::string model;  // its name
    ChartKind kind;
    int across;
    double cells, nodes;  // of its mesh
    int threads;
    std::string key;
    // None where the point would have taken more than the budget:
    std::optional<Timing> timing;
    std::optional<double> setup;      // [s] of the time, median
    std::optional<double> simulated;  // [s] of motions
  };
  /// The same case with its deviations from a truth.
  struct Comparison {
    std::string key, law, compared;
  };
  std::string scene;
  std::string settings;  // hash of what else determines its models
  std::string law;       // of the scene's own reference
  std::string answer;    // measure that answers the scene's load: "plate_force", ...
  double height;         // [m] along the axis
  // Largest displacement that is imposed [m]; none in bending, where it is the truth's
  // tip deflection:
  std::optional<double> imposed;
  std::string machine;  // processor, compiler and commit
  std::vector<Truth> truths;
  std::vector<Point> points;
  std::vector<Comparison> comparisons;
};

/// Of scene, settings and the truth of its own law: charts of the same have the same,
/// whatever points they hold.
std::string identity_of(const StoredChart& chart);

/// Layout, within the group `charts` of a result file:
///
///     IDENTITY              attributes scene, settings, law, answer, height, imposed,
///     machine IDENTITY/truths       columns law, size_1 to size_3, key_1 to key_3
///     IDENTITY/points       columns model, kind, across, cells, nodes, threads, key,
///                           repetitions, minimum, lower_quartile, median,
///                           upper_quartile, maximum, setup, simulated
///     IDENTITY/comparisons  columns key, law, compared
///
/// Replaces the chart of the same identity.
void write_chart(hid_t charts, const StoredChart& chart);

/// The charts of a result file by scene, of one scene the fullest first; none of one
/// without. Throws like read_cases.
std::vector<StoredChart> read_charts(const std::filesystem::path& file);

}  // namespace springcheck
