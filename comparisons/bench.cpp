// springcheck_bench measures the time per step of every method's explicit dynamics,
// beside plain loops.
//
//     springcheck_bench [--benchmark_filter=REGEX] [other options of Google Benchmark]
//
// Names are method/cells/precision/instruction set/threads, the method with -damped for
// dashpots of zeta = .05 and -distorted for cells of all shapes. Baselines: "naive", of
// mss-cf's springs, and mss-affine-plain. Springs of Hencky's law have plain loops alone.
// The time per_cell_step is what counts; bytes_per_cell is the memory of what moves,
// without mesh and network. Sizes up to 10^6 cells: the largest take minutes to prepare.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "comparisons/methods/methods.hpp"
#include "comparisons/running/stepping.hpp"

namespace {

using namespace springcheck;

double cell_count(const SteppedBody& body) {
  return double{1} * body.cells[0] * body.cells[1] * body.cells[2];
}

/// One body at a time is kept: benchmarks are repeated to find how many steps to time.
Stepping& prepared(const std::string& name, const SteppedBody& body) {
  static std::string last;
  static Stepping now;
  if (name != last) {
    now = {};  // its memory first
    now = stepping(body);
    last = name;
  }
  return now;
}

std::string stepper_of(const SteppedBody& body) {
  if (body.loops == Loops::naive) return "naive";
  return body.method + (body.loops == Loops::plain ? "-plain" : "");
}

void add(const SteppedBody& body) {
  const std::string name = fmt::format(
      "{}{}{}/{:.0f}/{}/{}/{}", stepper_of(body), body.damping_ratio > 0 ? "-damped" : "",
      body.distortion > 0 ? "-distorted" : "", cell_count(body), name_of(body.precision),
      name_of(body.instruction_set), body.threads);
  benchmark::RegisterBenchmark(name.c_str(), [name, body](benchmark::State& state) {
    const auto& [advance, bytes] = prepared(name, body);
    for (auto _ : state) advance();
    // The counter is not a number where nothing counts the bytes: CSV wants the same
    // counters everywhere.
    state.counters["bytes_per_cell"] = bytes > 0 ? bytes / cell_count(body) : NAN;
    state.counters["per_cell_step"] = benchmark::Counter(
        cell_count(body),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  })->UseRealTime();
}

/// Adds a body's benchmarks in every precision that the method has, by every instruction
/// set, and by the best one on several threads.
void add_all(SteppedBody body) {
  const dynamics::InstructionSet best = dynamics::best_instruction_set();
  for (const mss::Precision precision :
       {mss::Precision::double_precision, mss::Precision::single_precision})
    for (const dynamics::InstructionSet set : dynamics::all_instruction_sets)
      for (const int threads : {1, 2, 4}) {
        if (!dynamics::is_available(set) || (set != best && threads > 1)) continue;
        if (precision == mss::Precision::single_precision &&
            !reads(*find_method(body.method), "precision"))
          continue;
        body.precision = precision;
        body.instruction_set = set;
        body.threads = threads;
        add(body);
      }
}

struct Variant {
  const char* method;
  double damping_ratio = 0;
  double distortion = 0;  // in cell edges
};
constexpr double zeta = 0.05;

}  // namespace

int main(int count, char** arguments) {
  using mss::Precision;
  const dynamics::InstructionSet best = dynamics::best_instruction_set();
  for (const int cells : {10, 20, 30, 50, 100}) {
    SteppedBody body{.method = "mss-cf",
                     .cells = {cells, cells, cells},
                     .load = SteppedLoad::plates,
                     .poisson_ratio = 0.4,
                     .damping_ratio = 0,
                     .precision = Precision::double_precision,
                     .instruction_set = best,
                     .threads = 1,
                     .loops = Loops::naive};
    add(body);
    body.loops = Loops::plain;
    for (const char* method : {"mss-affine", "mss-hencky", "mss-affine-hencky"}) {
      body.method = method;
      add(body);
    }
    body.loops = Loops::kernel;
    for (const auto& [method, damping_ratio, distortion] :
         {Variant{"mss-cf"}, Variant{"mss-cf", zeta}, Variant{"mss-nfd"},
          Variant{"mss-fd"}, Variant{"mss-baudet"}, Variant{"mss-stvk"},
          Variant{"mss-stvk", zeta}, Variant{"mss-affine"}, Variant{"mss-affine", zeta},
          Variant{"mss-affine", 0, 0.2}, Variant{"mss-affine-stvk"},
          Variant{"mss-affine-stvk", 0, 0.2}, Variant{"mss-tissue"},
          Variant{"mss-tissue", 0, 0.2}, Variant{"fem-explicit-1p"},
          Variant{"fem-explicit-8p"}}) {
      body.method = method;
      body.damping_ratio = damping_ratio;
      body.distortion = distortion;
      add_all(body);
    }
  }
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
