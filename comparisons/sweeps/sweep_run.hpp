#pragma once

#include <compare>
#include <map>
#include <string>
#include <vector>

#include "comparisons/results/result_file.hpp"

namespace springcheck {

/// How the cases of a sweep ended: how many with each status, and how many for which
/// reason, where they have one.
struct SweepOutcome {
  struct Reason {
    Status status;
    std::string method;
    std::string words;

    auto operator<=>(const Reason&) const = default;
  };
  std::map<Status, int> count;
  std::map<Reason, int> reasons;
};

/// Runs the requests, `parallel` at a time, and adds each to the file as soon as it is
/// complete; see run_study for `known`.
SweepOutcome run_into(ResultFile& file, const std::vector<Request>& requests,
                      bool with_fields, MeshStore& meshes, int parallel,
                      const KnownResult& known);

}  // namespace springcheck
