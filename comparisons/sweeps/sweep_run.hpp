#pragma once

#include <map>
#include <vector>

#include "comparisons/results/result_file.hpp"

namespace springcheck {

/// Runs the requests, `parallel` at a time, and adds each to the file as soon as it is
/// complete; see run_study for `known`. Returns how many ended with each status.
std::map<Status, int> run_into(ResultFile& file, const std::vector<Request>& requests,
                               bool with_fields, MeshStore& meshes, int parallel,
                               const KnownResult& known);

}  // namespace springcheck
