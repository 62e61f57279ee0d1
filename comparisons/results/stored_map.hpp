#pragma once

#include <hdf5.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/running/case_result.hpp"

namespace springcheck {

/// Whether limits and controls are known, or its cases still have to be computed.
enum class MapState { planned, complete };

/// A map of `springcheck stability` as a result file keeps it: which of its cases stand
/// where, and the limits between them. How a case fails is not kept: failure_of says so.
struct StoredMap {
  struct Point {
    std::string method;                    // its label
    std::vector<std::string> values;       // of the axes, as the user wrote them
    std::string key;                       // of a case that the file may still lack
    std::optional<std::string> control{};  // key of that by which locking was judged
  };
  /// A limit as in AtlasLimit, in the unit of the first axis's values.
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
  std::string revision{};  // of the numerics of the program that made it
  // Revisions of cases of others that it was asked to take, with commas:
  std::string other_revisions{};
  MapState state = MapState::planned;
};

/// The revisions whose numerics a map is of, with commas, where they are not this
/// program's alone.
std::string revisions_of(const StoredMap& map);

/// The identity of a map, made of scene, axes, points and revision: the same map has the
/// same identity, with and without limits.
std::string identity_of(const StoredMap& map);

/// Layout, within the group `maps` of a result file:
///
///     IDENTITY         attributes scene, first and, of two axes, second; revision,
///                      other_revisions, complete
///     IDENTITY/points  columns method, first, second, key, control
///     IDENTITY/limits  columns method, second, low, high, failure, key; no rows until
///                      the command has come to its end
///
/// Replaces the map of the same identity, but a complete one by a planned one; a complete
/// one replaces planned ones of its revision, scene, axes and points, whatever their
/// keys.
void write_map(hid_t maps, const StoredMap& map);

/// Adds the maps of one group to those of another, see write_map.
void merge_maps(hid_t from, hid_t to);

/// The maps of a result file: those of this program's revision alone, and with
/// Revisions::all those of others, where there is no complete one of its own; of several
/// others the newest, by the dates of their revisions' sessions. Throws like read_cases.
std::vector<StoredMap> read_maps(const std::filesystem::path& file, Revisions revisions);

}  // namespace springcheck
