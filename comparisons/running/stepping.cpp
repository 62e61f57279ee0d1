#include "comparisons/running/stepping.hpp"

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <random>

#include "comparisons/methods/methods.hpp"
#include "comparisons/running/naive_springs.hpp"
#include "meshing/generators/generate_block.hpp"

namespace springcheck {
namespace {

constexpr double edge = 0.005;      // [m] of a cell
constexpr double time_step = 5e-5;  // [s] below half of mss-cf's limit up to nu = .499

Scene scene_of(const Material& material, SteppedLoad load) {
  const RigidMotion still{.translation = Vector3::Zero(),
                          .axis = Vector3::UnitZ(),
                          .centre = Vector3::Zero(),
                          .angle = 0};
  Scene scene{.material = material,
              .plates = {{"bottom", still, all_components}},
              .gravity = Vector3::Zero()};
  if (load == SteppedLoad::plates)
    scene.plates.push_back({"top", still, all_components});
  else
    scene.gravity = {-10, 0, 0};
  return scene;
}

std::vector<Vector3> disturbance(std::size_t nodes) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> component(-0.02 * edge, 0.02 * edge);
  std::vector<Vector3> moves(nodes);
  for (Vector3& move : moves)
    move = {component(random), component(random), component(random)};
  return moves;
}

/// What a motion refers to, and the motion.
struct Stepped {
  Mesh mesh;
  Scene scene;
  MakeMotion make{};
  std::unique_ptr<dynamics::Motion> motion{};
};

/// Tissue is spleen.
CaseSettings settings_of(const SteppedBody& body, const Method& method,
                         const Material& material) {
  CaseSettings settings{};
  settings.material = material;
  settings.method = method;
  settings.solver = Solver::semi_implicit_euler;
  settings.dynamics = {.duration = 1,
                       .time_step = time_step,
                       .step_ratio = 1,
                       .force_time_step = true,
                       .damping_ratio = body.damping_ratio,
                       .precision = body.precision,
                       .history = 0};
  settings.tissue = {.law = tissue::law_of_organ("spleen"), .branches = 5, .steps = 1};
  return settings;
}

/// What this process has from the heap.
double heap_bytes() {
  const struct mallinfo2 now = mallinfo2();
  return static_cast<double>(now.uordblks + now.hblkhd);
}

}  // namespace

Stepping stepping(const SteppedBody& body) {
  const Material material{
      .young_modulus = 1e4, .poisson_ratio = body.poisson_ratio, .density = 1000};
  std::array<double, 3> size{};
  std::ranges::transform(body.cells, size.begin(), [](int n) { return n * edge; });
  const auto stepped = std::make_shared<Stepped>(
      Stepped{.mesh = generate_block(
                  {.size = size, .cells = body.cells, .distortion = body.distortion}),
              .scene = scene_of(material, body.load)});
  const std::vector<Vector3> moves = disturbance(stepped->mesh.nodes().size());
  const Method& method = *find_method(body.method);
  const CaseSettings settings = settings_of(body, method, material);
  if (body.loops == Loops::naive) {
    const auto naive = std::make_shared<NaiveSprings>(
        method.network(settings, stepped->mesh).value(), moves);
    return {.advance = [naive] { naive->advance(time_step); }, .bytes = 0};
  }
  stepped->make = method.stepping(settings, stepped->mesh, stepped->scene);
  const double before = heap_bytes();
  stepped->motion = stepped->make({.instruction_set = body.instruction_set,
                                   .threads = body.threads,
                                   .by_plain_loops = body.loops == Loops::plain});
  const double bytes = heap_bytes() - before;
  stepped->motion->restore(
      {.displacements = moves,
       .velocities = std::vector<Vector3>(moves.size(), Vector3::Zero())});
  const auto still = dynamics::support_motions(stepped->scene, 1);
  const auto advance = [stepped, step = dynamics::StepTo{.dt = time_step,
                                                         .kick = time_step,
                                                         .load_fraction = 1,
                                                         .motions_before = still,
                                                         .motions = still}] {
    stepped->motion->advance(step);
  };
  return {.advance = advance, .bytes = bytes};
}

StepTime time_of_steps(const std::function<void()>& advance) {
  constexpr int measurements = 5;
  constexpr double seconds = 0.04;  // of each
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const auto processor_time = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
  };
  advance();  // into the caches
  StepTime time{.real = std::numeric_limits<double>::infinity(), .user_over_real = 0};
  double real = 0;
  const double user = processor_time();
  for (int i = 0; i < measurements; ++i) {
    const auto start = Clock::now();
    int steps = 0;
    do {
      advance();
      ++steps;
    } while (since(start) < seconds);
    const double passed = since(start);
    real += passed;
    time.real = std::min(time.real, passed / steps);
  }
  time.user_over_real = (processor_time() - user) / real;
  return time;
}

}  // namespace springcheck
