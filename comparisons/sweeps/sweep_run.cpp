#include "comparisons/sweeps/sweep_run.hpp"

#include <optional>

#include "comparisons/results/result_writer.hpp"
#include "comparisons/running/progress.hpp"

namespace springcheck {

void run_into(ResultFile& file, const std::vector<Request>& requests, bool with_fields,
              MeshStore& meshes, int parallel, const KnownResult& known,
              const Finished& finished, SweepOutcome& outcome) {
  ResultWriter writer(file, with_fields, meshes);
  bool is_lost = false;  // what cannot be written; what cannot be computed is not
  const Deliver deliver = [&](std::size_t, CaseResult&& result) {
    ++outcome.count[result.status];
    if (!result.reason.empty())
      ++outcome.reasons[{result.status, label(result.request.settings), result.reason}];
    try {
      writer.put(std::move(result));
    } catch (...) {
      is_lost = true;
      throw;
    }
  };
  try {
    run_study(requests, meshes, parallel, finished, known, deliver);
  } catch (...) {
    if (is_lost) throw;
    if (!outcome.failure) outcome.failure = std::current_exception();
  }
  writer.finish();
}

SweepOutcome run_cases(ResultFile& file, const Sweep& sweep,
                       std::span<const PlannedCase> cases, int parallel) {
  constexpr std::size_t at_once = 1000;
  constexpr std::size_t most_cells = 1'000'000;  // of meshes that are kept, some .5 GB
  SweepOutcome outcome;
  Progress progress("cases");
  std::optional<MeshStore> meshes(std::in_place);
  for (std::size_t first = 0; first < cases.size();) {
    std::vector<Request> requests;
    double cells = 0;
    const Body* last = nullptr;
    while (first + requests.size() < cases.size() && requests.size() < at_once &&
           cells < most_cells) {
      requests.push_back(request_of(sweep, cases[first + requests.size()]));
      const Body& body = requests.back().settings.body;
      if (last == nullptr || body != *last) cells += estimated_cells(body);
      last = &body;
    }
    const std::size_t before = first;
    first += requests.size();
    const Finished finished = [&](std::size_t done, std::size_t of) {
      const std::size_t part = of == 0 ? 0 : requests.size() * done / of;
      progress.show(before + part, cases.size());
    };
    run_into(file, requests, sweep.with_fields, *meshes, parallel, {}, finished, outcome);
    if (meshes->cells() > most_cells) meshes.emplace();
  }
  return outcome;
}

}  // namespace springcheck
