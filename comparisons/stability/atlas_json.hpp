#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace springcheck {

/// The maps of a result file, for figures:
///
///     failures   name and letter of each kind, in the order of Failure
///     maps       scene; axes: key, values (as written), numbers (of values, null unless
///                they ascend) and unit ("", "%" or "deg"); points: method, values, case
///                (its key), failure (a name, null where the file lacks the case); limits
///                along the first axis, in its unit: method, other (value of the second
///                axis), low, high, failure, case
///
/// In the order of scenes and axes. Throws like read_results.
nlohmann::ordered_json atlas_json(const std::filesystem::path& file, Revisions revisions);

}  // namespace springcheck
