// springcheck_bench: time per step of every method's explicit dynamics, beside plain
// loops.
//
//     springcheck_bench [--benchmark_filter=REGEX] [other options of Google Benchmark]
//
// Names are method/cells/precision/instruction set/threads; the time per_cell_step is
// what counts. Sizes up to 10^6 cells: the largest take minutes to prepare.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <map>

#include "comparisons/stepping.hpp"

namespace {

using namespace springcheck;

double cell_count(const SteppedBody& body) {
  return double{1} * body.cells[0] * body.cells[1] * body.cells[2];
}

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
      fmt::format("{}/{:.0f}/{}/{}/{}", body.method, cell_count(body),
                  name_of(body.precision), name_of(body.instruction_set), body.threads);
  benchmark::RegisterBenchmark(name.c_str(), [name, body](benchmark::State& state) {
    const std::function<void()>& advance = prepared(name, body);
    for (auto _ : state) advance();
    state.counters["per_cell_step"] = benchmark::Counter(
        cell_count(body),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  })->UseRealTime();
}

}  // namespace

int main(int count, char** arguments) {
  using mss::Precision;
  const dynamics::InstructionSet best = dynamics::best_instruction_set();
  for (const int cells : {10, 20, 30, 50, 100}) {
    SteppedBody body{.method = "naive",
                     .cells = {cells, cells, cells},
                     .load = SteppedLoad::plates,
                     .poisson_ratio = 0.4,
                     .damping_ratio = 0,
                     .precision = Precision::double_precision,
                     .instruction_set = best,
                     .threads = 1};
    add(body);
    for (const char* method : {"mss-cf", "mss-nfd", "mss-fd", "mss-baudet",
                               "fem-explicit-1p", "fem-explicit-8p"}) {
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
