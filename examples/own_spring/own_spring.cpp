// A spring model of one's own beside finite elements: a cube pressed between glued plates.
// All springs of a cell are equally stiff, so that a cube pulled along its edges has
// Young's modulus E: C_11 = 28 k/(3h), C_12 = 10 k/(3h), E = 144 k/(19 h).
#include <cstdio>
#include <fem_reference/solve.hpp>
#include <meshing/generators/generate_block.hpp>
#include <mss/solve.hpp>

using namespace springcheck;

double force_on(const Mesh& mesh, const Solution& solution) {
  double force = 0;
  for (const NodeIndex node : mesh.region("top").nodes)
    force -= solution.reactions[node].z();
  return force;
}

int main() {
  const double side = 0.05;  // [m]
  const int cells = 8;
  const Mesh mesh = generate_block({.size = {side, side, side}, .cells = {8, 8, 8}});
  const Material material{.young_modulus = 10e3, .poisson_ratio = 0.25, .density = 1000};
  const RigidMotion still{Vector3::Zero(), Vector3::UnitZ(), Vector3::Zero(), 0};
  RigidMotion down = still;
  down.translation = Vector3(0, 0, -0.05 * side);
  const Scene scene{.material = material,
                    .plates = {{"bottom", still, all_components},
                               {"top", down, all_components}},
                    .gravity = Vector3::Zero()};

  const double k = 19.0 / 144 * material.young_modulus * side / cells;  // [N/m], of a cell
  const mss::LatticeConstants constants{{4 * k, 2 * k, k}, 0};  // four cells share an edge
  const Solution springs = mss::solve(
      mesh, scene, {.network = {.model = mss::SpringModel::custom, .constants = constants}});
  const Solution elements = fem_reference::solve(
      mesh, scene,
      {.law = fem_reference::Law::hencky, .element = fem_reference::Element::q1_sri});
  std::printf("springs %.4f N, finite elements %.4f N\n", force_on(mesh, springs),
              force_on(mesh, elements));
}
