// cutting_bench times cuts of a cube of hexahedra beside CGAL's combinatorial map.
//
//     cutting_bench [--benchmark_filter=REGEX] [other options of Google Benchmark]
//
// Names are what is done/by whom/cells a side. A slit is of 100 faces in the middle, a
// hole of 100 cells. "choose" finds the slit's faces by a plane, "rebuild" makes a Mesh
// of the cut body, with all its checks. bytes_per_cell is what building takes from the
// heap.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <malloc.h>

#include "meshing/cutting/cut_choice.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tests/meshing/cutting/three_map.hpp"

namespace {

using namespace springcheck;

/// The cube of the size that was asked for last.
const Mesh& cube(int cells) {
  static std::unique_ptr<const Mesh> last;
  static int size = 0;
  if (size != cells)
    last = std::make_unique<const Mesh>(
        generate_block({.size = {1, 1, 1}, .cells = {size = cells, cells, cells}}));
  return *last;
}

/// In the middle, ten cells a side.
CutPlace plane(int cells) {
  const double half = 5. / cells;
  return {.surface = Plane{.normal = {0, 0, 1}, .offset = 0.5},
          .within = Box{.low = Vector3::Constant(0.5 - half),
                        .high = Vector3::Constant(0.5 + half)}};
}

Cut slit(int cells) {
  const Mesh& mesh = cube(cells);
  return {
      .name = "slit",
      .parted = faces_along("", "", CellComplex(mesh), mesh.nodes(), plane(cells)).faces};
}

Cut hole(int cells) {
  Cut hole{.name = "hole"};
  for (const CellSide& face : slit(cells).parted) hole.removed.push_back(face.cell);
  return hole;
}

void apply(CellComplex& cells, const Cut& cut) {
  cells.part(cut.parted);
  cells.remove(cut.removed);
}
void apply(ThreeMap& map, const Cut& cut) {
  map.cut(cut);
}

double heap() {
  return static_cast<double>(mallinfo2().uordblks) +
         static_cast<double>(mallinfo2().hblkhd);
}

template <class Body, class From>
void time_building(benchmark::State& state, const From& from, double cells) {
  double bytes = 0;
  for (auto _ : state) {
    const double before = heap();
    const Body body(from);
    bytes = heap() - before;
    benchmark::DoNotOptimize(&body);
  }
  state.counters["bytes_per_cell"] = bytes / cells;
}

/// Times one cut on a body that is made anew each time.
template <class Body, class From>
void time_cut(benchmark::State& state, const From& from, const Cut& cut) {
  for (auto _ : state) {
    state.PauseTiming();
    auto body = std::make_unique<Body>(from);
    state.ResumeTiming();
    apply(*body, cut);
    state.PauseTiming();
    body.reset();
    state.ResumeTiming();
  }
}

void add(const std::string& name, int cells,
         const std::function<void(benchmark::State&)>& run) {
  benchmark::RegisterBenchmark(fmt::format("{}/{}", name, cells).c_str(),
                               [run](benchmark::State& state) { run(state); })
      ->Iterations(10)
      ->Unit(benchmark::kMicrosecond);
}

void add_all(int n) {
  const double count = double{1} * n * n * n;
  const auto one_face = [n] {
    Cut cut = slit(n);
    cut.parted.resize(1);
    return cut;
  };
  add("build/arrays", n,
      [=](auto& state) { time_building<CellComplex>(state, cube(n), count); });
  add("build/3-map", n,
      [=](auto& state) { time_building<ThreeMap>(state, CellComplex(cube(n)), count); });
  for (const auto& [name, cut] :
       {std::pair<std::string, std::function<Cut()>>{"face", one_face},
        {"slit", [n] { return slit(n); }},
        {"hole", [n] { return hole(n); }}}) {
    add(name + "/arrays", n,
        [=, cut = cut](auto& state) { time_cut<CellComplex>(state, cube(n), cut()); });
    add(name + "/3-map", n, [=, cut = cut](auto& state) {
      time_cut<ThreeMap>(state, CellComplex(cube(n)), cut());
    });
  }
  add("choose/arrays", n, [n](auto& state) {
    const CellComplex cells(cube(n));
    for (auto _ : state)
      benchmark::DoNotOptimize(faces_along("", "", cells, cube(n).nodes(), plane(n)));
  });
  add("rebuild/arrays", n, [n](auto& state) {
    const Cut wanted = slit(n);
    for (auto _ : state)
      benchmark::DoNotOptimize(cut("", cube(n), CellComplex(cube(n)), wanted));
  });
}

}  // namespace

int main(int argc, char** argv) {
  for (const int cells : {20, 60}) add_all(cells);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
