#pragma once

#include <hdf5.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/cases/model.hpp"
#include "comparisons/names/named.hpp"
#include "comparisons/running/case_result.hpp"
#include "comparisons/running/timing.hpp"
#include "comparisons/studies/formal_order.hpp"

namespace springcheck {

/// What a time is of: a static equilibrium, or a second of motion by explicit steps of .9
/// of the method's own stability limit. Times of one kind are never compared with the
/// other's.
enum class ChartKind { equilibrium, motion };

template <>
inline constexpr std::array value_names<ChartKind>{
    Named{ChartKind::equilibrium, "equilibrium"}, Named{ChartKind::motion, "motion"}};

/// What `springcheck chart` measured of a scene, as a result file keeps it: times, and
/// the keys of the cases by which errors are told.
struct StoredChart {
  /// Three grids, from coarse to fine.
  struct Grids {
    std::array<double, 3> cell_sizes{};
    std::array<std::string, 3> keys{};         // of their cases
    double formal_order = least_formal_order;  // in older files none
  };
  /// What a law converges to: the limit of grids of q2, or of others, by which it is
  /// checked.
  struct Truth {
    std::string law;  // its method
    Grids grids{};
    std::optional<Grids> check{};  // in older files none
    // How far the limits of the two fields are apart, see apart_in_places:
    std::optional<double> places_apart{};

    /// Whether a case is one of those grids.
    [[nodiscard]] bool has(const std::string& key) const;
  };
  struct Point {
    Model model;
    ChartKind kind;
    int across;
    double cells, nodes;  // of its mesh
    int threads;
    std::string key;
    std::optional<std::string> left_out{};  // why it was not run
    TimedRounds times{};                    // [s] behind the timing
    std::optional<Timing> timing{};         // none of what was left out
    std::optional<double> setup{};          // [s] of the time, median
    std::optional<double> simulated;        // [s] of motions
    std::string family{};                   // of the method; empty in older files
  };
  /// The case `compared` is the case `key` with its deviations from the truth of `law`.
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
  std::optional<double> imposed{};
  std::string machine;  // processor, compiler and commit
  std::vector<Truth> truths{};
  std::vector<Point> points{};
  std::vector<Comparison> comparisons{};
  std::string revision{};  // of the numerics; empty in older files
};

/// The identity of a chart, made of scene, settings, the truth of its own law and the
/// machine: charts with the same of these have the same identity, whatever points they
/// hold. Times of two machines, or of two versions of the program, are never of one
/// chart.
std::string identity_of(const StoredChart& chart);

/// The point of a model's case on so many threads; nullptr where there is none.
StoredChart::Point* find_point(StoredChart& chart, const Model& model,
                               const std::string& key, int threads);

/// A chart with the points, truths and comparisons that another of the same identity has
/// beyond its own; points of its own that were left out give way to those that were run.
StoredChart merged(StoredChart chart, const StoredChart& other);

/// Layout, within the group `charts` of a result file:
///
///     IDENTITY              attributes scene, settings, law, answer, height, imposed,
///                           machine, revision
///     IDENTITY/truths       columns law, size_1 to size_3, key_1 to key_3, formal_order,
///                           the same of the check with check_ before, places_apart
///     IDENTITY/points       columns model (its name) and its parts method, element,
///                           cell-type, linear-solver, precision, its family, then kind,
///                           across, cells, nodes, threads, key, left_out, repetitions,
///                           minimum, lower_quartile, median, upper_quartile, maximum,
///                           setup, simulated, times (all of them, rounds with ';'
///                           between, as the figures follow from)
///     IDENTITY/comparisons  columns key, law, compared
///
/// Replaces the chart of the same identity.
void write_chart(hid_t charts, const StoredChart& chart);

/// Adds the charts of one group to those of another, see merged.
void merge_charts(hid_t from, hid_t to);

/// The charts of a result file by scene, of one scene the fullest first: those of this
/// program's revision, or all. Throws like read_cases.
std::vector<StoredChart> read_charts(const std::filesystem::path& file,
                                     Revisions revisions);

}  // namespace springcheck
