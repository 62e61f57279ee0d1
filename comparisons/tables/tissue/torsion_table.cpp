#include "comparisons/tables/tissue/torsion_table.hpp"

#include <fmt/format.h>

#include <array>

#include "comparisons/tables/plans/planned_requests.hpp"
#include "tissue/rheometer.hpp"

namespace springcheck {
namespace {

constexpr std::array rim_strains{0.1, 0.5, 1.};
constexpr std::array<std::array<int, 2>, 3> meshes{{{8, 2}, {16, 4}, {24, 6}}};
constexpr double rim_rate = 0.133;                 // [1/s]
constexpr double radius = 0.0075, height = 0.003;  // [m]

CaseSettings turned(std::string_view organ, double rim_strain,
                    const std::array<int, 2>& mesh) {
  const auto [across, layers] = mesh;
  constexpr double angle_per_strain = height / radius;
  return case_of_scene("tissue-torsion",
                       {{"organ", organ},
                        {"size", std::array{2 * radius, 2 * radius, height}},
                        {"cells", std::array{across, across, layers}},
                        {"deformation", rim_strain * angle_per_strain},
                        {"rate", rim_rate * angle_per_strain}});
}

Table torsion_table(std::span<const CaseResult> results) {
  Table table{
      .columns = {{"organ", "organ"},
                  {"rim_strain", "strain at the rim", "{:g}"},
                  {"time", "time [s]", "{:.4g}"},
                  {"law", "law [uN m]", "{:.5g}"}},
      .notes = {fmt::format(
          "Disc of 15 mm and {:g} mm, its rim sheared at {:g} 1/s. Law: 2 pi int sigma "
          "x^2 dx of Golec 2018, Eq. 4.1, in homogeneous torsion. mss-tissue: hexahedra "
          "from gmsh, 20 steps; the rim of n cells across is a polygon of 2 n sides on "
          "the circle, whose polar moment is smaller by 5.0, 1.3 and 0.6 %.",
          1000 * height, rim_rate)}};
  for (const auto& [across, layers] : meshes) {
    const std::string name = fmt::format("springs_{}", across);
    table.columns.push_back(
        {name, fmt::format("mss-tissue, {} across, {} layers [uN m]", across, layers),
         "{:.5g}"});
    table.columns.push_back({name + "_off", "off [%]", "{:.2f}"});
  }
  std::size_t next = 0;
  for (const tissue::Organ& organ : tissue::organs())
    for (const double rim_strain : rim_strains) {
      const double law = 1e6 * disc_torque(organ.law, rim_strain, rim_rate, radius);
      TableRow row{.cells = {organ.name, rim_strain, rim_strain / rim_rate, law}};
      for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
        const CaseResult& result = results[next++];
        std::optional<double> torque, off;
        if (result.measures.plate_torque) {
          torque = 1e6 * *result.measures.plate_torque;
          off = 100 * (*torque / law - 1);
        }
        row.cells.push_back(value_or_status(torque, result));
        row.cells.push_back(off);
        row.cases.push_back(result.key);
      }
      table.rows.push_back(std::move(row));
    }
  return table;
}

}  // namespace

TablePlan plan_tissue_torsion_table() {
  PlannedRequests planned;
  for (const tissue::Organ& organ : tissue::organs())
    for (const double rim_strain : rim_strains)
      for (const auto& mesh : meshes) planned.add(turned(organ.name, rim_strain, mesh));
  return {.requests = planned.take(),
          .make = [](std::span<const CaseResult> results, MeshStore&) {
            return torsion_table(results);
          }};
}

}  // namespace springcheck
