// springcheck_bench: time per step of every method's explicit dynamics, beside plain
// loops.
//
//     springcheck_bench [--benchmark_filter=REGEX] [other options of Google Benchmark]
//
// Names are method/cells/precision/instruction set/threads; ns_per_cell_step is what
// counts. Sizes up to 10^6 cells: the largest take minutes to prepare.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <map>

#include "comparisons/stepping.hpp"

namespace {

using namespace springcheck;

/// One body at a time is kept: benchmarks are repeated to find how many steps to time.
std::function<void()>& prepared(const std::string& name, const SteppedBody& body) {
  static std::string last;
  static std::function<void()> advance;
  if (name != last) {
    advance = {};  // its memory first
    advance = stepping(body);
    last = name;
  }
  return advance;
}

void add(const SteppedBody& body) {
  const std::string name =
      fmt::format("{}/{}/{}/{}/{}", body.method, body.cells * body.cells * body.cells,
                  name_of(body.precision), name_of(body.instruction_set), body.threads);
  benchmark::RegisterBenchmark(name.c_str(), [name, body](benchmark::State& state) {
    const std::function<void()>& advance = prepared(name, body);
    for (auto _ : state) advance();
    const double cells = std::pow(body.cells, 3);
    state.counters["ns_per_cell_step"] =
        benchmark::Counter(cells * 1e-9, benchmark::Counter::kIsIterationInvariantRate |
                                             benchmark::Counter::kInvert);
  })->UseRealTime();
}

}  // namespace

int main(int count, char** arguments) {
  using mss::Precision;
  const dynamics::InstructionSet best = dynamics::best_instruction_set();
  for (const int cells : {10, 20, 30, 50, 100}) {
    SteppedBody body{.method = "naive",
                     .cells = cells,
                     .poisson_ratio = 0.4,
                     .damping_ratio = 0,
                     .precision = Precision::double_precision,
                     .instruction_set = best,
                     .threads = 1};
    add(body);
    for (const char* method : {"mss-cf", "mss-nfd", "mss-fd", "mss-baudet"}) {
      body.method = method;
      for (const Precision precision :
           {Precision::double_precision, Precision::single_precision})
        for (const dynamics::InstructionSet set : dynamics::all_instruction_sets)
          for (const int threads : {1, 2, 4}) {
            if (!dynamics::is_available(set) || (set != best && threads > 1)) continue;
            body.precision = precision;
            body.instruction_set = set;
            body.threads = threads;
            add(body);
          }
    }
  }
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
