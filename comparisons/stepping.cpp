#include "comparisons/stepping.hpp"

#include <memory>
#include <random>

#include "comparisons/naive_springs.hpp"
#include "meshing/generators/block.hpp"
#include "mss/dynamics.hpp"

namespace springcheck {
namespace {

constexpr double edge = 0.005;      // [m] of a cell
constexpr double time_step = 5e-5;  // [s] below half of mss-cf's limit up to nu = .499

Scene scene_of(const Material& material) {
  const RigidMotion still{.translation = Vector3::Zero(),
                          .axis = Vector3::UnitZ(),
                          .centre = Vector3::Zero(),
                          .angle = 0};
  return {.material = material,
          .plates = {{"bottom", still, all_components}, {"top", still, all_components}},
          .gravity = Vector3::Zero()};
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
  mss::Network network;
  std::unique_ptr<dynamics::Motion> motion{};
};

}  // namespace

std::function<void()> stepping(const SteppedBody& body) {
  const Material material{
      .young_modulus = 1e4, .poisson_ratio = body.poisson_ratio, .density = 1000};
  const bool is_naive = body.method == "naive";
  const int n = body.cells;
  const auto stepped = std::make_shared<Stepped>(Stepped{
      .mesh =
          generate_block({.size = {n * edge, n * edge, n * edge}, .cells = {n, n, n}}),
      .scene = scene_of(material),
      .network = {}});
  const auto method =
      std::get<mss::Method>(find_method(is_naive ? "mss-cf" : body.method)->model);
  stepped->network =
      mss::build_network(stepped->mesh, material,
                         {.method = method,
                          .stiffness_form = mss::StiffnessForm::shear_modulus,
                          .diagonal_ratio = 1});
  const std::vector<Vector3> moves = disturbance(stepped->mesh.nodes().size());
  if (is_naive) {
    const auto naive = std::make_shared<NaiveSprings>(stepped->network, moves);
    return [naive] { naive->advance(time_step); };
  }
  const dynamics::Integrator semi_implicit = dynamics::Integrator::semi_implicit_euler;
  stepped->motion = mss::motion_of(stepped->mesh, stepped->scene, stepped->network,
                                   {.protocol = {.integrator = semi_implicit,
                                                 .duration = 1,
                                                 .time_step = time_step,
                                                 .force_time_step = true},
                                    .damping_ratio = body.damping_ratio,
                                    .precision = body.precision,
                                    .threads = body.threads},
                                   body.instruction_set);
  stepped->motion->restore(
      {.displacements = moves,
       .velocities = std::vector<Vector3>(moves.size(), Vector3::Zero())});
  const auto still = dynamics::support_motions(stepped->scene, 0);
  return [stepped, step = dynamics::StepTo{.dt = time_step,
                                           .kick = time_step,
                                           .load_fraction = 0,
                                           .motions_before = still,
                                           .motions = still}] {
    stepped->motion->advance(step);
  };
}

}  // namespace springcheck
