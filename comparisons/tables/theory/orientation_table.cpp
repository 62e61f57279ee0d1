#include "comparisons/tables/theory/orientation_table.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "comparisons/methods/families.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "fem_reference/laws/uniaxial_stress.hpp"

namespace springcheck {
namespace {

using fem_reference::LatticeDirection;

/// The columns' springs: of mss-cf from the continuum and from themselves.
constexpr std::size_t columns = 4, lattice_continuum = 0, lattice_springs = 1;

constexpr std::string_view uniaxial = "uniaxial stress", shear = "simple shear";

/// mss-affine with so many directions.
GivenSettings virtual_springs(const char* method, const char* directions) {
  return {{method, "mss-affine"}, {"directions", directions}};
}

/// A cube of a lattice's material under uniaxial stress, the lattice turned.
CaseSettings continuum_case(double nu, double strain, const std::string& direction,
                            GivenSettings lattice) {
  GivenSettings changes{{"method", "fem-cauchy-born"},
                        {"cells", std::array{1, 1, 1}},
                        {"nu", nu},
                        {"deformation", strain},
                        {"lattice-direction", direction}};
  changes.insert(changes.end(), lattice.begin(), lattice.end());
  return case_of_scene("uniaxial", changes);
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

/// Turns of a body that is sheared.
struct Turn {
  std::string_view name;
  Eigen::Matrix3d matrix;
};

std::vector<Turn> turns() {
  const auto about = [](const Vector3& axis, double degrees) -> Eigen::Matrix3d {
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized())
        .toRotationMatrix();
  };
  return {{"xz", Eigen::Matrix3d::Identity()},
          {"yz", about(Vector3::UnitZ(), 90)},
          {"45 degrees about z", about(Vector3::UnitZ(), 45)},
          {"50 degrees about 1,2,3", about({1, 2, 3}, 50)}};
}

CaseSettings sheared_case(double nu, double strain, const Turn& turn,
                          GivenSettings method) {
  method.push_back({"nu", nu});
  CaseSettings settings = case_of_scene("affine", method);
  const Eigen::Matrix3d H = strain * Vector3::UnitX() * Vector3::UnitZ().transpose();
  settings.gradient = turn.matrix * H * turn.matrix.transpose();
  return settings;
}

/// A row's stresses, one for each column of springs.
using Stresses = std::array<std::optional<double>, columns>;

void add_row(Table& table, std::string_view load, double nu, double strain,
             std::string_view direction, std::span<const CaseResult> results,
             const Stresses& stress, const Stresses& off) {
  TableRow row{.cells = {std::string(load), nu, strain, std::string(direction)}};
  for (std::size_t i = 0; i < columns; ++i)
    row.cells.push_back(value_or_status(stress[i], results[i]));
  for (std::size_t i = lattice_springs; i < columns; ++i) row.cells.emplace_back(off[i]);
  for (std::size_t i = 0; i < columns; ++i) row.cases.push_back(results[i].key);
  table.rows.push_back(std::move(row));
}

/// Each over the first direction's less 1, in percent.
Stresses off_first(const Stresses& stress, const Stresses& first) {
  Stresses off;
  for (std::size_t i = 0; i < columns; ++i)
    if (stress[i] && first[i]) off[i] = 100 * (*stress[i] / *first[i] - 1);
  return off;
}

Stresses uniaxial_stresses(std::span<const CaseResult> results) {
  const CaseSettings& settings = results[lattice_continuum].request.settings;
  const Vector3 d =
      fem_reference::lattice_to_body(settings.elements.lattice_direction).row(2);
  Stresses stress;
  for (std::size_t i = 0; i < columns; ++i) stress[i] = stiffness_of(results[i]);
  stress[lattice_springs] =
      stiffness_of(results[lattice_springs], d, *settings.deformation);
  return stress;
}

/// |P|/(sqrt 2 mu gamma), and of the part that a turn adds, |R^T P R - P_0|/|P_0|,
/// percent.
std::array<Stresses, 2> shear_stresses(std::span<const CaseResult> results,
                                       std::span<const CaseResult> first,
                                       const Turn& turn, double strain) {
  Stresses stress, off;
  for (std::size_t i = 0; i < columns; ++i) {
    const auto &turned = results[i].measures.mean_stress,
               &straight = first[i].measures.mean_stress;
    if (!turned || !straight) continue;
    const Material& material = results[i].request.settings.material;
    stress[i] =
        turned->norm() / (std::numbers::sqrt2 * lame_constants(material).mu * strain);
    const Eigen::Matrix3d back = turn.matrix.transpose() * *turned * turn.matrix;
    off[i] = 100 * (back - *straight).norm() / straight->norm();
  }
  return {stress, off};
}

Table orientation_table(std::span<const CaseResult> results) {
  Table table{
      .columns = {{"load", "load"},
                  {"nu", "nu", "{}"},
                  {"strain", "strain", "{}"},
                  {"direction", "direction"},
                  {"cauchy_born", "stress, mss-cf by Cauchy-Born", "{:.4f}"},
                  {"springs", "mss-cf", "{:.4f}"},
                  {"affine", "mss-affine", "{:.4f}"},
                  {"affine_6", "mss-affine, 6 directions", "{:.4f}"},
                  {"springs_off", "mss-cf off the first [%]", "{:.3f}"},
                  {"affine_off", "mss-affine", "{:.3f}"},
                  {"affine_6_off", "mss-affine, 6 directions", "{:.3f}"}},
      .notes = {
          "An isotropic material has the same stress in all directions; springs have at "
          "small strain only. Off the first: against the first direction of the same "
          "load, nu and strain.",
          "Uniaxial stress: nominal stress, free sides, over E strain. By Cauchy-Born, "
          "for mss-affine, too: one cell between sliding plates, the lattice turned so "
          "that the direction lies along the load. mss-cf: a block of springs whose "
          "boundary follows Cauchy-Born's homogeneous state, turned back into the "
          "lattice's frame; the mean stress along the direction. It is a patch test: "
          "springs that follow the state inside carry Cauchy-Born's stress.",
          "Simple shear: the boundary of a block of 4x4x4 cells follows the shear, "
          "turned "
          "as the direction says. Norm of the mean stress over that of the linear "
          "material; off the first: norm of the difference, turned back, over the "
          "first's."}};
  Stresses along_100;
  auto row = results;
  for (; row.size() >= columns; row = row.subspan(columns)) {
    const CaseSettings& settings = row[lattice_continuum].request.settings;
    if (settings.test != Test::uniaxial) break;
    const LatticeDirection direction = settings.elements.lattice_direction;
    const Stresses stress = uniaxial_stresses(row);
    if (direction == LatticeDirection::d100) along_100 = stress;
    add_row(table, uniaxial, settings.material.poisson_ratio, *settings.deformation,
            name_of(direction), row, stress, off_first(stress, along_100));
  }
  const std::vector<Turn> all = turns();
  for (; row.size() >= columns * all.size(); row = row.subspan(columns * all.size())) {
    const CaseSettings& first = row.front().request.settings;
    const double strain = first.gradient.norm();
    for (std::size_t t = 0; t < all.size(); ++t) {
      const auto here = row.subspan(columns * t, columns);
      const auto [stress, off] = shear_stresses(here, row, all[t], strain);
      add_row(table, shear, first.material.poisson_ratio, strain, all[t].name, here,
              stress, off);
    }
  }
  return table;
}

}  // namespace

TablePlan plan_orientation_table() {
  TablePlan plan{.make = [](std::span<const CaseResult> results, MeshStore&) {
    return orientation_table(results);
  }};
  const auto add = [&](CaseSettings settings) {
    plan.requests.push_back({.settings = std::move(settings)});
  };
  for (const double nu : {0.25, 0.499})
    for (const double strain : {-0.05, -0.2})
      for (const char* direction : {"100", "110", "111"}) {
        const CaseSettings continuum =
            continuum_case(nu, strain, direction, {{"lattice", "mss-cf"}});
        add(continuum);
        add(springs_case(continuum, nu));
        for (const char* directions : {"16", "6"})
          add(continuum_case(nu, strain, direction,
                             virtual_springs("lattice", directions)));
      }
  for (const double nu : {0.25, 0.499})
    for (const double strain : {0.05, 0.2})
      for (const Turn& turn : turns()) {
        add(sheared_case(nu, strain, turn,
                         {{"method", "fem-cauchy-born"}, {"lattice", "mss-cf"}}));
        add(sheared_case(nu, strain, turn, {{"method", "mss-cf"}}));
        for (const char* directions : {"16", "6"})
          add(sheared_case(nu, strain, turn, virtual_springs("method", directions)));
      }
  return plan;
}

}  // namespace springcheck
