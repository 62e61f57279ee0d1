#include <algorithm>
#include <cmath>

#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/measures/beam_measures.hpp"
#include "comparisons/measures/displacement_norms.hpp"
#include "comparisons/measures/measures.hpp"

namespace springcheck {
namespace {

constexpr double in_layer = 1e-9;  // of the block's height: coordinates are exact

/// The length deviations are divided by: the largest displacement that the settings' load
/// imposes, or the reference's tip deflection in bending and face displacement in
/// traction.
std::optional<double> imposed_length(const CaseSettings& settings, const Scene& scene,
                                     const Mesh& mesh, const Solution& reference) {
  if (settings.test == Test::bending) {
    const auto tip = tip_deflection(settings, mesh, reference.displacements);
    return tip ? std::optional(std::abs(*tip)) : std::nullopt;
  }
  if (settings.test == Test::traction)
    return loaded_face_displacement(mesh, scene, reference).norm();
  return largest_imposed_displacement(mesh, scene);
}

}  // namespace

void measure_deviation(Measures& measures, const CaseSettings& settings, const Mesh& mesh,
                       const Solution& solution, const Solution& reference) {
  const CaseSettings on_the_way = at_largest_load(settings, solution.load_fraction);
  const Scene scene = mechanical_scene(on_the_way, mesh);
  const double height = settings.body.block.size[2];
  const bool has_layers = has_nodes_in_layers(settings.body);
  const auto distance = [&](std::size_t n) {
    return (solution.displacements[n] - reference.displacements[n]).norm();
  };
  double sum = 0, largest = 0, layer_sum = 0;
  int layer_nodes = 0;
  for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
    sum += distance(n);
    largest = std::max(largest, distance(n));
    if (has_layers && std::abs(mesh.nodes()[n].z() - height / 2) < in_layer * height) {
      layer_sum += distance(n);
      ++layer_nodes;
    }
  }
  measures.mean_deviation = sum / static_cast<double>(mesh.nodes().size());
  measures.max_deviation = largest;
  if (layer_nodes > 0) measures.middle_layer_deviation = layer_sum / layer_nodes;
  const auto length = imposed_length(on_the_way, scene, mesh, reference);
  const auto free = over_free_nodes(mesh, scene, distance);
  const bool is_answer =
      settings.test == Test::bending || settings.test == Test::traction;
  const bool has_length = !is_answer || solution.load_fraction != 0;
  if (has_length && length && *length > 0 && free) {
    measures.deviation_l2_relative = free->root_mean_square / *length;
    measures.deviation_max_relative = free->largest / *length;
  }

  const auto volumes = deformed_volumes(mesh, solution),
             reference_volumes = deformed_volumes(mesh, reference);
  double square_sum = 0;
  for (std::size_t c = 0; c < volumes.size(); ++c)
    square_sum += std::pow(volumes[c] - reference_volumes[c], 2) / mesh.cell_volumes()[c];
  measures.cell_volume_ratio_rms_difference = std::sqrt(square_sum / mesh.volume());
}

Measures::Value reference_bar_l2_relative(const CaseSettings& settings, const Mesh& mesh,
                                          const Solution& reference,
                                          const std::vector<double>& node_error_bounds) {
  const Scene scene = mechanical_scene(settings, mesh);
  const auto length = imposed_length(settings, scene, mesh, reference);
  const auto free =
      over_free_nodes(mesh, scene, [&](std::size_t n) { return node_error_bounds[n]; });
  if (!length || *length <= 0 || !free) return std::nullopt;
  return free->root_mean_square / *length;
}

}  // namespace springcheck
