#include "comparisons/methods/spring_method.hpp"

#include <algorithm>
#include <memory>

#include "comparisons/cases/case.hpp"
#include "comparisons/methods/families.hpp"
#include "comparisons/methods/protocol.hpp"
#include "mss/networks/spring_model_table.hpp"
#include "mss/solve.hpp"

namespace springcheck {
namespace {

mss::NetworkSettings network_settings(const CaseSettings& settings,
                                      mss::SpringModel model) {
  mss::NetworkSettings springs = springs_of(settings, settings.method.fixed);
  springs.model = model;
  return springs;
}

std::optional<mss::DynamicsSettings> motion_settings(const CaseSettings& settings,
                                                     int threads) {
  if (!goes_through_time(settings)) return std::nullopt;
  return mss::DynamicsSettings{.protocol = protocol_of(settings),
                               .damping_ratio = settings.dynamics.damping_ratio,
                               .precision = settings.dynamics.precision,
                               .threads = threads};
}

std::string words_of(mss::CellShapes shapes) {
  switch (shapes) {
    case mss::CellShapes::any:
      return "cells of any shape";
    case mss::CellShapes::tetrahedra:
      return "tetrahedra of any shape";
    case mss::CellShapes::cubes:
      return "cubes";
    case mss::CellShapes::boxes:
      break;
  }
  return "cubes, and boxes that springs of no negative stiffness make isotropic, on "
         "which A has no effect";
}

/// Entries of the matrix for each node: 3 x 3 blocks with 26 neighbours and the node
/// itself.
constexpr double entries_of_neighbours = 9 * 27;

/// Memory for each cell [bytes]. Peaks of `run compression` by multigrid: 779 MB at 30^3
/// cells of mss-cf, 5047 MB at 60^3; of mss-affine at nu = .4 1740 MB at 30^3, 3931 MB at
/// 40^3.
constexpr double multigrid_bytes = 20e3;

}  // namespace

Method of_springs(mss::SpringModel springs, Method own, double coupling) {
  own.family = Family::springs;
  if (own.lattice) {
    own.lattice->name = own.name;
    own.lattice->reads = own.reads;
    own.lattice->fixed = own.fixed;
  }
  own.covers = words_of(mss::entry_of(springs).cells) + own.covers;
  if (own.fixed.strain != mss::StrainMeasure::hencky &&
      std::ranges::count(own.cells, CellType::hexahedron) > 0)
    own.covers += std::string("; single precision on hexahedra, by explicit steps") +
                  (std::ranges::count(own.reads, "spring-strain") > 0
                       ? ", of engineering and green strain"
                       : "");
  own.reads.insert(own.reads.end(),
                   {"damping", "precision", "linear-solver", "noise", "seed"});
  own.solvers = {Solver::static_equilibrium,  Solver::path_limit, Solver::explicit_euler,
                 Solver::semi_implicit_euler, Solver::verlet,     Solver::implicit_euler};
  own.seconds.at_rest = 0.5;  // .25 to 1.6, most where they wrinkle
  own.solve = [springs](const CaseSettings& settings, const Mesh& mesh,
                        const Scene& scene, int threads,
                        const dynamics::Observers& observers) {
    return mss::solve(mesh, scene,
                      {.network = network_settings(settings, springs),
                       .dynamics = motion_settings(settings, threads),
                       .search = search_of(settings)},
                      observers);
  };
  own.network = [springs](const CaseSettings& settings,
                          const Mesh& mesh) -> std::optional<mss::Network> {
    if (mss::reason_to_refuse(mesh, settings.material, springs)) return std::nullopt;
    return mss::build_network(mesh, settings.material,
                              network_settings(settings, springs));
  };
  own.stepping = [springs](const CaseSettings& settings, const Mesh& mesh,
                           const Scene& scene) -> MakeMotion {
    const auto network = std::make_shared<mss::Network>(
        mss::build_network(mesh, settings.material, network_settings(settings, springs)));
    return [=, &mesh, &scene, protocol = protocol_of(settings),
            dynamics = settings.dynamics](const SteppingOptions& options) {
      return mss::motion_of(
          mesh, scene, *network,
          {.protocol = protocol,
           .damping_ratio = dynamics.damping_ratio,
           .precision = dynamics.precision,
           .threads = options.threads,
           .kernel = options.by_plain_loops ? mss::Kernel::plain : mss::Kernel::fast},
          options.instruction_set);
    };
  };
  own.linear_systems = [coupling](const CaseSettings& settings) -> LinearSystems {
    if (!needs_tangents(settings)) return {};
    const double further = settings.material.poisson_ratio > 0.25 ? coupling : 1;
    return {.kind = linear_systems_of(settings),
            .coupling = further,
            .multigrid_bytes = multigrid_bytes * further,
            .entries_per_node = entries_of_neighbours * further};
  };
  return own;
}

}  // namespace springcheck
