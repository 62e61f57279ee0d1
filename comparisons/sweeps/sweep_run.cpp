#include "comparisons/sweeps/sweep_run.hpp"

#include "comparisons/results/result_writer.hpp"
#include "comparisons/running/progress.hpp"

namespace springcheck {

SweepOutcome run_into(ResultFile& file, const std::vector<Request>& requests,
                      bool with_fields, MeshStore& meshes, int parallel,
                      const KnownResult& known) {
  SweepOutcome outcome;
  Progress progress("simulations");
  ResultWriter writer(file, with_fields, meshes);
  run_study(
      requests, meshes, parallel,
      [&](std::size_t done, std::size_t of) { progress.show(done, of); }, known,
      [&](std::size_t, CaseResult&& result) {
        ++outcome.count[result.status];
        if (!result.reason.empty())
          ++outcome
                .reasons[{result.status, label(result.request.settings), result.reason}];
        writer.put(std::move(result));
      });
  writer.finish();
  return outcome;
}

}  // namespace springcheck
