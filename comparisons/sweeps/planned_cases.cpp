#include "comparisons/sweeps/planned_cases.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "comparisons/running/case_result.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/system/memory.hpp"

namespace springcheck {
namespace {

/// What was asked, without the mesh of a body that its settings describe: generating that
/// takes long, and is not needed to tell cases apart.
std::string question_of(const Request& request, MeshHashes& meshes) {
  const Body& body = request.settings.body;
  return case_identity(request, body.shape == BodyShape::file ? meshes.of(body) : "");
}

/// The simulation that its cases share, one of their own where there is none.
std::string group_of(const Request& request, MeshHashes& meshes) {
  return question_of({.settings = request.reference.value_or(request.settings)}, meshes);
}

}  // namespace

Request request_of(const Sweep& sweep, const PlannedCase& planned) {
  return std::move(requests_of(sweep, planned.combination).at(planned.request));
}

std::vector<PlannedCase> planned_cases(const Sweep& sweep, MeshHashes& meshes, int shard,
                                       int shards) {
  struct Grouped {
    std::size_t group;  // in the order in which they are met
    PlannedCase planned;
  };
  std::vector<Grouped> cases;
  std::set<std::string> seen;
  std::map<std::string, std::size_t> groups;
  const double available = available_memory();
  const std::size_t count = combination_count(sweep);
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<Request> requests = requests_of(sweep, i);
    check_memory(sweep.file, requests, available);
    for (std::size_t place = 0; place < requests.size(); ++place) {
      if (!seen.insert(question_of(requests[place], meshes)).second) continue;
      const std::size_t turn = (seen.size() - 1) % static_cast<std::size_t>(shards);
      if (turn + 1 != static_cast<std::size_t>(shard)) continue;
      const std::size_t group =
          groups.try_emplace(group_of(requests[place], meshes), groups.size())
              .first->second;
      cases.push_back({.group = group,
                       .planned = {.combination = static_cast<std::uint32_t>(i),
                                   .request = static_cast<std::uint32_t>(place)}});
    }
  }
  std::ranges::stable_sort(cases, {}, &Grouped::group);
  std::vector<PlannedCase> planned;
  for (const Grouped& one : cases) planned.push_back(one.planned);
  return planned;
}

}  // namespace springcheck
