#include "comparisons/tables/studies/convergence_table.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "comparisons/cases/grids.hpp"
#include "comparisons/studies/converged_number.hpp"
#include "comparisons/tables/plans/planned_requests.hpp"

namespace springcheck {
namespace {

constexpr std::array divisions{2, 4, 8, 16};
const std::array<double, 2> ratios{0.25, 0.45};

/// A method on one type of cells.
struct Series {
  GivenSettings method;
  std::string cell_type;
};

std::vector<Series> all_series() {
  const GivenSettings affine{{"method", "mss-affine"}},
      hooke{{"method", "fem-hooke"}, {"element", "q1"}};
  std::vector<Series> all{
      {{{"method", "mss-cf"}}, "hexahedron"},
      {{{"method", "fem-hooke"}, {"element", "q1-sri"}}, "hexahedron"},
      {{{"method", "mss-vangelder"}}, "free-tetrahedron"},
      {{{"method", "mss-lloyd"}}, "free-tetrahedron"}};
  for (const char* type :
       {"hexahedron", "tetrahedron", "prism", "pyramid", "mixed", "free-tetrahedron"})
    for (const GivenSettings& method : {affine, hooke}) all.push_back({method, type});
  return all;
}

CaseSettings settings_of(double nu, int cells, const GivenSettings& changes) {
  return case_of_scene(
      "shearing",
      GivenSettings{
          {"deformation", 1e-5}, {"nu", nu}, {"cells", std::array{cells, cells, cells}}} +
          changes);
}

struct PlannedSeries {
  double nu;
  std::size_t exact;  // place of the first of three grids of q2
  std::size_t first;  // place of the first of the divisions
};

std::optional<double> off(const CaseResult& result, double exact) {
  const auto& force = result.measures.plate_force;
  return force ? std::optional(std::abs(*force / exact - 1)) : std::nullopt;
}

/// The order of errors that are all known.
std::optional<double> order_of(const std::vector<double>& sizes,
                               const std::vector<std::optional<double>>& errors) {
  std::vector<double> known;
  for (const auto& error : errors) {
    if (!error) return std::nullopt;
    known.push_back(*error);
  }
  return fitted_order(sizes, known);
}

std::optional<double> in_percent(const std::optional<double>& fraction) {
  return fraction ? std::optional(100 * *fraction) : std::nullopt;
}

double exact_force(std::span<const CaseResult> grids) {
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) values[i] = grids[i].measures.plate_force.value();
  return converged_number({grids[0].request.settings, grids[1].request.settings,
                           grids[2].request.settings},
                          values)
      .value;
}

void add_rows(Table& table, const PlannedSeries& planned,
              std::span<const CaseResult> results, MeshStore& meshes) {
  const double exact = exact_force(results.subspan(planned.exact, 3));
  const auto runs = results.subspan(planned.first, divisions.size());
  std::vector<double> sizes;
  std::vector<std::optional<double>> forces, deviations;
  for (const CaseResult& run : runs) {
    sizes.push_back(cell_size(run.request.settings.body.block));
    forces.push_back(off(run, exact));
    deviations.push_back(run.measures.deviation_l2_relative);
  }
  const auto force_order = order_of(sizes, forces),
             deviation_order = order_of(sizes, deviations);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const CaseSettings& settings = runs[i].request.settings;
    const Mesh& mesh = meshes.mesh(settings.body);
    table.rows.push_back(
        {.cells = {label(settings), name_of(settings.body.block.pattern), planned.nu,
                   divisions[i], sizes[i], mesh.cells().size(), mesh.nodes().size(),
                   value_or_status(in_percent(forces[i]), runs[i]), force_order,
                   value_or_status(in_percent(deviations[i]), runs[i]), deviation_order,
                   name_of(runs[i].status)},
         .cases = {runs[i].key, results[planned.exact].key,
                   results[planned.exact + 1].key, results[planned.exact + 2].key}});
  }
}

}  // namespace

TablePlan plan_convergence_table() {
  std::vector<Request> requests;
  std::vector<PlannedSeries> all;
  for (const double nu : ratios) {
    const std::size_t exact = requests.size();
    for (const int cells : {4, 8, 16})
      requests.push_back({.settings = settings_of(nu, cells, exact_elements)});
    const CaseSettings finest = requests.back().settings;
    for (const Series& series : all_series()) {
      all.push_back({.nu = nu, .exact = exact, .first = requests.size()});
      for (const int cells : divisions)
        requests.push_back(
            {.settings = settings_of(
                 nu, cells,
                 series.method + GivenSettings{{"cell-type", series.cell_type}}),
             .reference = finest});
    }
  }
  return {.requests = requests,
          .make = [all](std::span<const CaseResult> results, MeshStore& meshes) {
            Table table{
                .columns = {{"method", "method"},
                            {"cell_type", "cell type"},
                            {"nu", "nu", "{}"},
                            {"n", "n", "{:.0f}"},
                            {"h", "h [m]", "{:.4g}"},
                            {"cells", "cells", "{:.0f}"},
                            {"nodes", "nodes", "{:.0f}"},
                            {"force_error", "force off [%]", "{:.3f}"},
                            {"force_order", "order", "{:.2f}"},
                            {"deviation", "deviation L2 [%]", "{:.4f}"},
                            {"deviation_order", "order", "{:.2f}"},
                            {"status", "status"}},
                .notes = {
                    "n: cells of the grid across the cube, h their edge. Force: absolute "
                    "error against what Hooke q2 converges to on 4, 8 and 16 cubes "
                    "across. Deviation: volume-weighted root mean square over the free "
                    "nodes from Hooke q2 on 16 cubes across, over the largest imposed "
                    "displacement. Orders: least squares over the four meshes. The edges "
                    "of glued plates are singular: no method of low order reaches 2."}};
            for (const PlannedSeries& series : all)
              add_rows(table, series, results, meshes);
            return table;
          }};
}

}  // namespace springcheck
