#include "comparisons/running/stepping.hpp"

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <random>
#include <string_view>

#include "comparisons/running/naive_springs.hpp"
#include "fem_reference/explicit/explicit_dynamics.hpp"
#include "meshing/generators/generate_block.hpp"
#include "mss/motion/dynamics.hpp"
#include "mss/tissue/tissue_motion.hpp"
#include "tissue/maxwell_fit.hpp"

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
  mss::Network network{};    // of springs
  mss::TissueBody tissue{};  // of mss-tissue
  std::unique_ptr<dynamics::Motion> motion{};
};

/// Spleen, with five branches.
mss::TissueBody tissue_of(const Mesh& mesh, const Material& material) {
  const tissue::MaxwellFit fit =
      tissue::fit_maxwell_model(tissue::law_of_organ("spleen"));
  return mss::build_tissue_body(
      mesh,
      {.shear = fit.model, .bulk_ratio = tissue::bulk_ratio_of(material.poisson_ratio)},
      material.density);
}

mss::Network network_of(const Mesh& mesh, const Material& material, mss::Method method) {
  return mss::build_network(mesh, material,
                            {.method = method,
                             .stiffness_form = mss::StiffnessForm::shear_modulus,
                             .diagonal_ratio = 1});
}

constexpr std::string_view plain_affine = "mss-affine-plain";

const Method& method_of(const SteppedBody& body) {
  return *find_method(body.method == plain_affine ? "mss-affine" : body.method);
}

std::unique_ptr<dynamics::Motion> motion_of(const Stepped& stepped,
                                            const SteppedBody& body) {
  const dynamics::Protocol protocol{
      .integrator = dynamics::Integrator::semi_implicit_euler,
      .duration = 1,
      .time_step = time_step,
      .force_time_step = true};
  if (const auto* element =
          std::get_if<fem_reference::ExplicitElement>(&method_of(body).model))
    return fem_reference::motion_of(stepped.mesh, stepped.scene,
                                    {.element = *element,
                                     .protocol = protocol,
                                     .damping_ratio = body.damping_ratio,
                                     .precision = body.precision,
                                     .threads = body.threads},
                                    body.instruction_set);
  if (is_tissue(method_of(body))) {
    std::vector<Vector3> load = stepped.tissue.rest_positions;
    for (std::size_t n = 0; n < load.size(); ++n)
      load[n] = stepped.tissue.masses[n] * stepped.scene.gravity;
    return std::make_unique<mss::TissueMotion>(
        stepped.mesh, stepped.scene, stepped.tissue, load,
        mss::TissueMotionSettings{.integrator = protocol.integrator,
                                  .threads = body.threads},
        body.instruction_set);
  }
  return mss::motion_of(
      stepped.mesh, stepped.scene, stepped.network,
      {.protocol = protocol,
       .damping_ratio = body.damping_ratio,
       .precision = body.precision,
       .threads = body.threads,
       .kernel = body.method == plain_affine ? mss::Kernel::plain : mss::Kernel::fast},
      body.instruction_set);
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
  if (body.method == "naive") {
    const auto naive = std::make_shared<NaiveSprings>(
        network_of(stepped->mesh, material, mss::Method::cf), moves);
    return {.advance = [naive] { naive->advance(time_step); }, .bytes = 0};
  }
  if (const auto* method = std::get_if<mss::Method>(&method_of(body).model))
    stepped->network = network_of(stepped->mesh, material, *method);
  if (is_tissue(method_of(body))) stepped->tissue = tissue_of(stepped->mesh, material);
  const double before = heap_bytes();
  stepped->motion = motion_of(*stepped, body);
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
  constexpr double seconds = 0.1;  // of each
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
