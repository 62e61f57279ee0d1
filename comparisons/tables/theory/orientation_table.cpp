#include "comparisons/tables/theory/theory_tables.hpp"

#include <fmt/format.h>

#include <cmath>

#include "comparisons/methods/families.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "fem_reference/laws/uniaxial_stress.hpp"

namespace springcheck {
namespace {

using fem_reference::LatticeDirection;

/// A cube of the lattice's material under uniaxial stress, the lattice turned.
CaseSettings continuum_case(double nu, double strain, const std::string& direction) {
  return case_of_scene("uniaxial", {{"method", "fem-cauchy-born"},
                                    {"lattice", "mss-cf"},
                                    {"cells", std::array{1, 1, 1}},
                                    {"nu", nu},
                                    {"deformation", strain},
                                    {"lattice-direction", direction}});
}

/// The springs whose boundary follows the same state, seen from the lattice's frame: with
/// R from lattice to body, H of the lattice is R^T H R.
CaseSettings springs_case(const CaseSettings& continuum, double nu) {
  const auto lattice =
      fem_reference::cauchy_born(continuum.material, lattice_of(continuum));
  const Eigen::Matrix3d turn =
      fem_reference::lattice_to_body(continuum.elements.lattice_direction);
  CaseSettings springs = case_of_scene("affine", {{"method", "mss-cf"}, {"nu", nu}});
  springs.gradient =
      turn.transpose() *
      fem_reference::uniaxial_stress_state(lattice, *continuum.deformation) * turn;
  return springs;
}

/// Nominal stress over E strain from the plate's force.
std::optional<double> stiffness_of(const CaseResult& continuum) {
  const CaseSettings& settings = continuum.request.settings;
  const auto& force = continuum.measures.plate_force;
  if (!force) return std::nullopt;
  const auto [width, depth, height] = settings.body.block.size;
  return *force / (width * depth) /
         (settings.material.young_modulus * std::abs(*settings.deformation));
}

/// The same from the springs' mean stress along the direction d of the lattice that was
/// stretched: d . P d.
std::optional<double> stiffness_of(const CaseResult& springs, const Vector3& direction,
                                   double strain) {
  const auto& stress = springs.measures.mean_stress;
  if (!stress) return std::nullopt;
  return direction.dot(*stress * direction) /
         (springs.request.settings.material.young_modulus * strain);
}

Sheet orientation_sheet(std::span<const CaseResult> results) {
  Sheet sheet{
      .name = "orientation",
      .title = "Uniaxial stress along directions of the mss-cf lattice",
      .columns = {{"nu", "nu", "{}"},
                  {"strain", "strain", "{}"},
                  {"direction", "direction"},
                  {"cauchy_born", "stress/(E strain), Cauchy-Born", "{:.4f}"},
                  {"springs", "stress/(E strain), mss-cf", "{:.4f}"},
                  {"over_100", "Cauchy-Born over 100's", "{:.4f}"},
                  {"status", "status of mss-cf"}},
      .notes = {
          "Nominal stress, free sides, over that of the linear material. An isotropic "
          "material has the same in all directions; the lattice has at small strain "
          "only.",
          "Cauchy-Born: one cell between sliding plates, the lattice turned so that the "
          "direction lies along the load. mss-cf: a block of springs whose boundary "
          "follows Cauchy-Born's homogeneous state, turned back into the lattice's "
          "frame; the mean stress along the direction. It is a patch test: springs that "
          "follow the state inside carry Cauchy-Born's stress."}};
  std::optional<double> along_100;
  for (; results.size() >= 2; results = results.subspan(2)) {
    const CaseResult &continuum = results[0], &springs = results[1];
    const CaseSettings& settings = continuum.request.settings;
    const LatticeDirection direction = settings.elements.lattice_direction;
    const auto stiffness = stiffness_of(continuum);
    if (direction == LatticeDirection::d100) along_100 = stiffness;
    const Vector3 d = fem_reference::lattice_to_body(direction).row(2);
    sheet.rows.push_back(
        {.cells = {settings.material.poisson_ratio, settings.deformation,
                   name_of(direction), value_or_status(stiffness, continuum),
                   value_or_status(stiffness_of(springs, d, *settings.deformation),
                                   springs),
                   stiffness && along_100 ? std::optional(*stiffness / *along_100)
                                          : std::nullopt,
                   name_of(springs.status)},
         .cases = {continuum.key, springs.key}});
  }
  return sheet;
}

}  // namespace

SheetPlan plan_orientation_table() {
  SheetPlan plan{.make = [](std::span<const CaseResult> results, MeshStore&) {
    return orientation_sheet(results);
  }};
  for (const double nu : {0.25, 0.499})
    for (const double strain : {-0.05, -0.2})
      for (const char* direction : {"100", "110", "111"}) {
        const CaseSettings continuum = continuum_case(nu, strain, direction);
        plan.requests.push_back({.settings = continuum});
        plan.requests.push_back({.settings = springs_case(continuum, nu)});
      }
  return plan;
}

}  // namespace springcheck
