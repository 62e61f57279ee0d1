#pragma once

#include "fem_reference/statics/elements_body.hpp"
#include "fem_reference/statics/supports.hpp"
#include "statics/equilibrium.hpp"
#include "statics/minimum.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"

namespace springcheck::fem_reference {

/// A cube between a fixed and a moved plate.
struct Problem {
  Problem(int cells, const Settings& settings, double nu, double strain, double angle = 0)
      : mesh(cube(cells)),
        scene(between_plates(of_poisson_ratio(nu), {0, 0, strain * edge}, angle)),
        body(discretise(mesh, settings.element)),
        supports(mesh, scene, body),
        elements(body, {.constitution = constitution(scene.material, settings),
                        .dilatation = dilatation_taken(settings)}),
        loading{.is_free = supports.is_free(),
                .displacements = [this](double s) { return supports.displacements(s); },
                .forces = Eigen::VectorXd::Zero(
                    static_cast<Eigen::Index>(3 * body.nodes.size())),
                .follows_supports = [](const Eigen::VectorXd&, double) { return true; }} {
  }
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;

  /// `way` is the plate's position as a fraction of its motion, by load fraction.
  statics::Equilibrium found(const std::function<double(double)>& way = [](double s) {
    return s;
  }) {
    loading.displacements = [&](double s) { return supports.displacements(way(s)); };
    return statics::find_equilibrium(elements, loading, {});
  }
  /// The minimum at the full load.
  statics::Minimum minimum(const Eigen::VectorXd& start,
                           statics::Tangents tangents = statics::Tangents::any) {
    statics::PotentialEnergy potential(elements, loading, statics::LinearSolver::direct);
    potential.set_load(1);
    std::mt19937_64 random(1);
    return statics::minimise(potential, start, random, tangents);
  }
  [[nodiscard]] Eigen::VectorXd free_part(Eigen::VectorXd all) const {
    statics::Unknowns(loading.is_free).clear_prescribed(all);
    return all;
  }
  /// The plates moved, with the free nodes where they were.
  [[nodiscard]] Eigen::VectorXd only_plates_moved() const {
    return supports.displacements(1);
  }
  /// Every layer follows the plates by its height.
  [[nodiscard]] Eigen::VectorXd layers_moved() const {
    return nodal(body, [&](const Vector3& X) {
      return displacement(scene.plates[1].motion, {X.x(), X.y(), edge}, X.z() / edge);
    });
  }

  Mesh mesh;
  Scene scene;
  Discretisation body;
  Supports supports;
  ElementsBody elements;
  statics::Loading loading;
};

}  // namespace springcheck::fem_reference
