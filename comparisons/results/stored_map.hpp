#pragma once

#include <hdf5.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace springcheck {

/// A map of `springcheck stability` as a result file keeps it: which of its cases stand
/// where, and the limits between them. How a case fails is not kept: failure_of says so.
struct StoredMap {
  struct Point {
    std::string method;                    // its label
    std::vector<std::string> values;       // of the axes, as the user wrote them
    std::string key;                       // of a case that the file may still lack
    std::optional<std::string> control{};  // key of that by which locking was judged
  };
  /// See AtlasLimit, in the unit of the first axis's values.
  struct Limit {
    std::string method;
    std::optional<std::string> other;
    std::optional<double> low, high;
    std::string failure;             // its name
    std::optional<std::string> key;  // of the case that fails first
  };
  std::string scene;
  std::vector<std::string> axes{};  // keys, one or two
  std::vector<Point> points{};
  std::vector<Limit> limits{};
};

/// Whether limits and controls are known, or its cases still have to be computed.
enum class MapState { planned, complete };

/// Of scene, axes and points: the same map has the same, with and without limits.
std::string identity_of(const StoredMap& map);

/// Layout, within the group `maps` of a result file:
///
///     IDENTITY         attributes scene, first and, of two axes, second
///     IDENTITY/points  columns method, first, second, key, control
///     IDENTITY/limits  columns method, second, low, high, failure, key; no rows until
///                      the command has come to its end
///
/// Replaces the map of the same identity; a planned one leaves it as it is.
void write_map(hid_t maps, const StoredMap& map, MapState state);

/// The maps of a result file, none of one that was written before there were any. Throws
/// like read_cases.
std::vector<StoredMap> read_maps(const std::filesystem::path& file);

}  // namespace springcheck
