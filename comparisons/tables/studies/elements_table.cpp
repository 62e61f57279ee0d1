#include "comparisons/tables/studies/elements_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "comparisons/methods/methods.hpp"
#include "comparisons/studies/converged_number.hpp"
#include "comparisons/studies/split.hpp"
#include "comparisons/tables/plans/planned_requests.hpp"

namespace springcheck {
namespace {

/// A deformation test, at a deformation so small that all laws are one, and at 5 %.
struct LoadCase {
  std::string scene;
  GivenSetting small;
  GivenSetting finite;
};
const GivenSetting tiny{"deformation", 1e-5};
const std::array<LoadCase, 3> tests{{{"compression", tiny, {"deformation", "5%"}},
                                     {"shearing", tiny, {"deformation", "5%"}},
                                     {"torsion", tiny, {"deformation", "1deg"}}}};
const std::array<double, 4> ratios{0, 0.25, 0.45, 0.499};

struct MethodRow {
  std::string label;
  GivenSettings changes;
  std::string law;  // in `laws`; empty: none is known
};

const std::map<std::string, GivenSettings> laws{
    {"Hooke", {{"method", "fem-hooke"}}},
    {"springs of mss-cf", {{"method", "fem-cauchy-born"}, {"lattice", "mss-cf"}}},
    {"virtual springs", {{"method", "fem-cauchy-born"}, {"lattice", "mss-affine"}}},
    {"fem-stvk", {{"method", "fem-stvk"}}},
    {"fem-hencky", {{"method", "fem-hencky"}}}};

const MethodRow mss_cf{"mss-cf", {{"method", "mss-cf"}}, "springs of mss-cf"};
const MethodRow mss_affine{"mss-affine", {{"method", "mss-affine"}}, "virtual springs"};
const MethodRow van_gelder{"mss-vangelder", {{"method", "mss-vangelder"}}, ""};
const MethodRow lloyd{"mss-lloyd", {{"method", "mss-lloyd"}}, ""};
const GivenSettings uncorrected{{"correction", "off"}};
const MethodRow bare_van_gelder{"mss-vangelder, correction off",
                                van_gelder.changes + uncorrected, ""};
const MethodRow bare_lloyd{"mss-lloyd, correction off", lloyd.changes + uncorrected, ""};

MethodRow finite_elements(const std::string& law, const std::string& element) {
  const GivenSettings& changes = laws.at(law);
  return {fmt::format("{}:{} ({})", changes.front().value.text(), element, law),
          changes + GivenSettings{{"element", element}}, law};
}

/// Springs on such cells that follow a law of finite elements.
std::vector<MethodRow> springs_of_laws(CellType cell_type) {
  std::vector<MethodRow> all;
  for (const Method& method : methods())
    if (!method.same_law_as.empty() && std::ranges::count(method.cells, cell_type) > 0)
      all.push_back(
          {method.name, {{"method", method.name}}, std::string(method.same_law_as)});
  return all;
}

struct MeshRows {
  std::string label;
  GivenSettings changes;
  std::vector<MethodRow> methods;
};

std::vector<MeshRows> meshes_and_methods() {
  const MethodRow hooke = finite_elements("Hooke", "q1"),
                  hooke_sri = finite_elements("Hooke", "q1-sri"),
                  hooke_nodal = finite_elements("Hooke", "q1-nodal"),
                  virtual_springs = finite_elements("virtual springs", "q1"),
                  virtual_springs_sri = finite_elements("virtual springs", "q1-sri");
  const auto with_laws = [](CellType cell_type, std::vector<MethodRow> rows,
                            const std::vector<MethodRow>& elements) {
    const std::vector<MethodRow> of_laws = springs_of_laws(cell_type);
    rows.insert(rows.end(), of_laws.begin(), of_laws.end());
    rows.insert(rows.end(), elements.begin(), elements.end());
    return rows;
  };
  return {{"cubes",
           {{"cell-type", "hexahedron"}},
           with_laws(CellType::hexahedron, {mss_cf, mss_affine},
                     {hooke, hooke_sri, hooke_nodal, virtual_springs_sri})},
          {"distorted mixed",
           {{"cell-type", "mixed"}, {"distortion", 0.2}},
           with_laws(CellType::prism, {mss_cf, van_gelder, mss_affine},
                     {hooke, hooke_sri, hooke_nodal, virtual_springs})},
          {"gmsh's tetrahedra",
           {{"cell-type", "free-tetrahedron"}},
           with_laws(CellType::tetrahedron,
                     {mss_cf, van_gelder, bare_van_gelder, lloyd, bare_lloyd, mss_affine},
                     {hooke, hooke_nodal, virtual_springs})}};
}

using OfTests = std::array<std::size_t, 3>;  // places of simulations, test by test

struct PlannedElementsRow {
  std::string mesh;
  MethodRow method;
  double nu;
  OfTests small, finite;
  OfTests reference;                  // Hooke q2 on 5^3 cubes
  std::array<OfTests, 3> truth;       // Hooke q2 on 4^3, 8^3, 16^3 cubes
  std::optional<OfTests> same_law{};  // q2 on 5^3 cubes
};

const GivenSettings five_cells{{"cells", std::array{5, 5, 5}}};

OfTests add_tests(PlannedRequests& requests, const GivenSettings& changes,
                  bool is_small) {
  OfTests places{};
  for (std::size_t t = 0; t < tests.size(); ++t)
    places[t] = requests.add(
        tests[t].scene,
        changes + GivenSettings{is_small ? tests[t].small : tests[t].finite});
  return places;
}

std::vector<PlannedElementsRow> plan_rows(PlannedRequests& requests) {
  std::vector<PlannedElementsRow> rows;
  for (const double nu : ratios) {
    const GivenSettings material{{"nu", nu}};
    const GivenSettings q2 = material + GivenSettings{{"element", "q2"}};
    const GivenSettings hooke = q2 + laws.at("Hooke");
    const OfTests reference = add_tests(requests, hooke + five_cells, true);
    std::array<OfTests, 3> truth{};
    for (std::size_t grid = 0; grid < 3; ++grid) {
      const int n = 4 << grid;
      truth[grid] = add_tests(
          requests,
          material + exact_elements + GivenSettings{{"cells", std::array{n, n, n}}},
          true);
    }
    std::map<std::string, OfTests> same_law;
    for (const auto& [law, changes] : laws)
      same_law[law] = add_tests(requests, q2 + changes + five_cells, false);
    for (const MeshRows& mesh : meshes_and_methods())
      for (const MethodRow& method : mesh.methods) {
        const GivenSettings changes =
            material + five_cells + mesh.changes + method.changes;
        rows.push_back({.mesh = mesh.label,
                        .method = method,
                        .nu = nu,
                        .small = add_tests(requests, changes, true),
                        .finite = add_tests(requests, changes, false),
                        .reference = reference,
                        .truth = truth});
        if (!method.law.empty()) rows.back().same_law = same_law.at(method.law);
      }
  }
  return rows;
}

std::optional<double> load_of(const CaseResult& result) {
  return answer_to_load(result.request.settings.test)->of(result.measures);
}

/// What the load converges to on three grids.
std::optional<ConvergedNumber> converged_load(std::span<const CaseResult> results,
                                              const std::array<OfTests, 3>& grids,
                                              std::size_t test) {
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto load = load_of(results[grids[i][test]]);
    if (!load) return std::nullopt;
    values[i] = *load;
  }
  const auto settings = [&](std::size_t i) -> const CaseSettings& {
    return results[grids[i][test]].request.settings;
  };
  return converged_number({settings(0), settings(1), settings(2)}, values);
}

/// The error bound in percent of the value.
Cell error_bound_cell(const std::optional<ConvergedNumber>& converged) {
  if (!converged) return {};
  return {100 * converged->error_bound / std::abs(converged->value)};
}

Cell error_cell(const CaseResult& result, const std::optional<double>& exact) {
  const auto load = load_of(result);
  if (!load || !exact) return value_or_status(std::nullopt, result);
  return {100 * (*load / *exact - 1)};
}

Cell volume_cell(const CaseResult& result, const CaseResult& same_law) {
  const auto &change = result.measures.volume_change,
             &exact = same_law.measures.volume_change;
  if (!change || !exact) return value_or_status(std::nullopt, result);
  return {100 * (*change - *exact)};
}

double cell_count(const Mesh& mesh) {
  return static_cast<double>(mesh.cells().size());
}

std::vector<std::string> notes_on(const CaseResult& result) {
  if (result.status != Status::refused) return {};
  return {fmt::format("Refused: {}.", result.reason)};
}

Table elements_table(const std::vector<PlannedElementsRow>& rows,
                     std::span<const CaseResult> results, MeshStore& meshes) {
  Table table{
      .columns = {{"mesh", "mesh"},
                  {"cells", "cells", "{:.0f}"},
                  {"method", "method"},
                  {"nu", "nu", "{}"}},
      .notes = {
          "Forces and torques in percent, at a deformation of 1e-5: off Hooke q2 on 5 x "
          "5 x 5 cubes, and off what Hooke q2 converges to on 4, 8 and 16 cells across.",
          "Volumes in points, at 5 % (torsion: 1 degree): volume change off that of the "
          "same law with q2 on 5 x 5 x 5 cubes: of mss-cf and mss-affine that of their "
          "own continuum, of springs that follow a law of finite elements that law. Van "
          "Gelder's and Lloyd's springs have no law."}};
  for (const LoadCase& test : tests)
    table.columns.push_back(
        {"off_q2_" + test.scene, test.scene + ", off q2 [%]", "{:.2f}"});
  for (const LoadCase& test : tests)
    table.columns.push_back({"off_truth_" + test.scene,
                             test.scene + ", off the converged value [%]", "{:.2f}"});
  for (const LoadCase& test : tests)
    table.columns.push_back(
        {"truth_bar_" + test.scene, test.scene + ", converged +- [%]", "{:.2g}"});
  for (const LoadCase& test : tests)
    table.columns.push_back(
        {"volume_" + test.scene, test.scene + ", volume off its law [points]", "{:.4f}"});
  table.columns.push_back({"status", "status at 5 %"});

  for (const PlannedElementsRow& planned : rows) {
    const CaseResult& first = results[planned.small[0]];
    TableRow row{
        .cells = {planned.mesh, cell_count(meshes.mesh(first.request.settings.body)),
                  planned.method.label, planned.nu},
        .notes = notes_on(first)};
    for (std::size_t t = 0; t < tests.size(); ++t)
      row.cells.push_back(
          error_cell(results[planned.small[t]], load_of(results[planned.reference[t]])));
    std::array<std::optional<ConvergedNumber>, tests.size()> truths;
    for (std::size_t t = 0; t < tests.size(); ++t)
      truths[t] = converged_load(results, planned.truth, t);
    for (std::size_t t = 0; t < tests.size(); ++t)
      row.cells.push_back(
          error_cell(results[planned.small[t]],
                     truths[t] ? std::optional(truths[t]->value) : std::nullopt));
    for (const auto& truth : truths) row.cells.push_back(error_bound_cell(truth));
    for (std::size_t t = 0; t < tests.size(); ++t)
      row.cells.push_back(planned.same_law ? volume_cell(results[planned.finite[t]],
                                                         results[(*planned.same_law)[t]])
                                           : Cell{});
    std::vector<std::string_view> statuses;
    for (const std::size_t place : planned.finite)
      if (const auto name = name_of(results[place].status);
          std::ranges::count(statuses, name) == 0)
        statuses.push_back(name);
    row.cells.push_back(fmt::format("{}", fmt::join(statuses, ", ")));
    for (const OfTests& places : {planned.small, planned.finite, planned.reference,
                                  planned.truth[0], planned.truth[1], planned.truth[2]})
      for (const std::size_t place : places) row.cases.push_back(results[place].key);
    if (planned.same_law)
      for (const std::size_t place : *planned.same_law)
        row.cases.push_back(results[place].key);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

TablePlan plan_elements_table() {
  PlannedRequests requests;
  const std::vector<PlannedElementsRow> rows = plan_rows(requests);
  return {.requests = requests.take(),
          .make = [rows](std::span<const CaseResult> results, MeshStore& meshes) {
            return elements_table(rows, results, meshes);
          }};
}

}  // namespace springcheck
