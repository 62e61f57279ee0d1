#include "comparisons/tables/theory/modes_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "comparisons/modes/body_modes.hpp"
#include "comparisons/modes/free_block_modes.hpp"
#include "comparisons/modes/mode_pairs.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/tables/theory/beam_cells.hpp"

namespace springcheck {
namespace {

constexpr int shown = 10;  // modes of the reference
constexpr double alike = 0.9;
constexpr int polynomial_degree = 10, polynomial_modes = 30;

constexpr std::size_t theory_column = 5, fem_column = 6;

struct SwingingBody {
  const char* name;
  const char* scene;
  Hold hold;
  int computed;  // modes, among which other methods' counterparts are looked for
  std::array<double, 3> ratios{0, 0.25, 0.4};
  GivenSettings changes{};
};

/// The bodies of the table. On the tetrahedra there is room for the weak modes of
/// elements averaged around nodes.
const std::vector<SwingingBody>& bodies() {
  static const std::vector<SwingingBody> all{
      {"free cube", "compression", Hold::free, 30},
      {"free cube of tetrahedra",
       "compression",
       Hold::free,
       100,
       {0.25, 0.4, 0.499},
       {{"cell-type", "tetrahedron"}, {"cells", std::array{6, 6, 6}}}},
      {"cantilever", "bending", Hold::as_in_scene, 30}};
  return all;
}

Table empty_table() {
  Table table{
      .columns = {{"body", "body"},
                  {"nu", "nu", "{}"},
                  {"modes", "modes"},
                  {"motion", "motion"},
                  {"euler_bernoulli", "Euler-Bernoulli [Hz]", "{:.3f}"},
                  {"theory", "theory [Hz]", "{:.3f}"},
                  {"fem", "FEM [Hz]", "{:.3f}"},
                  {"fem_off", "off theory [%]", "{:.2f}"}},
      .notes = {
          "Small undamped vibrations about the rest state; f = omega/(2 pi). Free cube: "
          "the cube of the scene compression, 5 cm, 10 x 10 x 10 cells, E = 10 kPa, "
          "held nowhere; its six rigid modes are left out. Of tetrahedra: 6 x 6 x 6 "
          "cubes of six each. Cantilever: the beam of the scene bending, 0.4 x 0.4 x "
          "2.4 m, 4 x 4 x 24 cells, E = 2 MPa, clamped at one end, without gravity. 1000 "
          "kg/m^3 all.",
          "FEM: fem-hooke:q1-sri with consistent masses, from which percentages are "
          "counted (on tetrahedra that is q1); lumped FEM: the same stiffness with "
          "row-sum masses, which on these cells are the springs' own. What springs "
          "differ "
          "by from it is stiffness. Nodal FEM: fem-hooke:q1-nodal with the same masses.",
          "Modes of equal frequency share a row, such as a square beam's two bendings "
          "or a cube's threes. Another method's modes are those whose shapes are most "
          "alike by the modal assurance criterion (MAC, of the mixtures most alike), "
          "wherever they stand in its own order; of several the mean. MAC: the least of "
          "the row. Where a method's is below 0.9 a note says so.",
          "Theory of the free cube: Rayleigh and Ritz, polynomials up to degree 10. "
          "Modes 9-10 at nu = 0.25 and 0.4 are two of Lame's three, f = "
          "sqrt(mu/rho)/(sqrt(2) L) exactly; on cells the third has another frequency.",
          "Theory of the cantilever: Timoshenko's beam (shear factor 5/6), "
          "Saint-Venant's torsion (J = "
          "0.1406 a^4) and the bar, for a slender beam that may contract and warp at the "
          "clamp, where finite elements and springs may not. Lumped masses "
          "on 4 x 4 cells have 9/8 of the section's polar moment, which lowers torsion "
          "by 5.7 %."}};
  for (const auto& [key, heading] : {std::pair{"lumped", "lumped FEM"},
                                     {"nodal", "nodal FEM"},
                                     {"cf", "mss-cf"},
                                     {"affine", "mss-affine"},
                                     {"nfd", "mss-nfd"}}) {
    table.columns.push_back({key, fmt::format("{} [Hz]", heading), "{:.3f}"});
    table.columns.push_back(
        {fmt::format("{}_off", key), fmt::format("{} off [%]", heading), "{:.2f}"});
  }
  table.columns.push_back({"mac", "MAC", "{:.3f}"});
  table.columns.push_back({"status", "status"});
  return table;
}

std::string numbers(const Multiplet& multiplet) {
  const auto first = multiplet.first + 1, last = multiplet.first + multiplet.count;
  return first == last ? fmt::format("{}", first) : fmt::format("{}-{}", first, last);
}

/// What is to be said of a method's modes in every row of a body, up to the last row's
/// frequency.
std::vector<std::string> body_notes(const MethodModes& method,
                                    const NaturalModes& reference, double last,
                                    const SwingingBody& body) {
  std::vector<std::string> notes;
  const int rigid = body.hold == Hold::free ? 6 : 0;
  if (const int more = method.modes->zero_modes - rigid; more != 0)
    notes.push_back(
        fmt::format("{} has {} modes of zero frequency beside the {} rigid "
                    "ones.",
                    method.method, more, rigid));
  const auto own = strangers(reference, *method.modes, last);
  if (!own.empty())
    notes.push_back(fmt::format(
        "{} has {} modes of its own up to {:.3f} Hz, from {:.3f} Hz on, in no row: less "
        "than half of each belongs to the first {} of FEM.",
        method.method, own.size(), last, own.front(), body.computed));
  return notes;
}

std::vector<TableRow> rows_of(const SwingingBody& body, double nu, MeshStore& meshes) {
  const CaseSettings settings = case_of_scene(
      body.scene, body.changes + GivenSettings{{"nu", nu}, {"method", "fem-hooke"}});
  const Mesh& mesh = meshes.mesh(settings.body);
  const auto all = body_modes(settings, mesh, body.hold, body.computed);
  const NaturalModes& reference = all.front().modes.value();  // Hooke's law is stable
  std::vector<Multiplet> groups = multiplets(reference);
  std::erase_if(groups, [](const Multiplet& group) { return group.first >= shown; });
  std::vector<Counterpart> exact;
  if (body.hold == Hold::free)
    exact =
        counterparts(reference, groups,
                     free_block_modes(settings.body.block.size, settings.material,
                                      polynomial_degree, polynomial_modes, mesh.nodes()));
  BeamCells beam(settings, mesh);

  std::vector<TableRow> rows;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    TableRow row{
        .cells = {body.name, settings.material.poisson_ratio, numbers(groups[i])}};
    const std::vector<Cell> theory =
        body.hold == Hold::free ? std::vector<Cell>{{}, {}, exact[i].frequency}
                                : beam.next(reference.shapes.col(groups[i].first));
    row.cells.insert(row.cells.end(), theory.begin(), theory.end());
    const double f = reference.frequencies[groups[i].first];
    row.cells.push_back(f);
    const std::optional<double> theory_f = row.cells[theory_column].number;
    row.cells.push_back(theory_f ? Cell{100 * (f / *theory_f - 1)} : Cell{});
    rows.push_back(std::move(row));
  }

  std::vector<double> least_mac(groups.size(), 1);
  std::vector<std::string> refusals;
  for (const MethodModes& method : std::span(all).subspan(1)) {
    if (!method.modes) {
      for (TableRow& row : rows) row.cells.insert(row.cells.end(), {method.reason, {}});
      refusals.push_back(method.method + " " + method.reason);
      continue;
    }
    const auto pairs = counterparts(reference, groups, *method.modes);
    const auto notes =
        body_notes(method, reference, *rows.back().cells[fem_column].number, body);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double f = *rows[i].cells[fem_column].number;
      rows[i].cells.push_back(pairs[i].frequency);
      rows[i].cells.push_back(100 * (pairs[i].frequency / f - 1));
      least_mac[i] = std::min(least_mac[i], pairs[i].mac);
      std::ranges::copy(notes, std::back_inserter(rows[i].notes));
      if (pairs[i].mac < alike)
        rows[i].notes.push_back(fmt::format(
            "No mode of {} is quite like it (MAC {:.2f}).", method.method, pairs[i].mac));
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].cells.push_back(least_mac[i]);
    rows[i].cells.push_back(
        refusals.empty() ? "ok" : fmt::format("{}", fmt::join(refusals, ", ")));
  }
  return rows;
}

}  // namespace

TablePlan plan_modes_table() {
  return {.make = [](std::span<const CaseResult>, MeshStore& meshes) {
    Table table = empty_table();
    std::vector<std::pair<const SwingingBody*, double>> all;
    for (const SwingingBody& body : bodies())
      for (const double nu : body.ratios) all.emplace_back(&body, nu);
    std::vector<std::vector<TableRow>> rows(all.size());
    tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
      rows[i] = rows_of(*all[i].first, all[i].second, meshes);
    });
    for (std::vector<TableRow>& some : rows)
      std::ranges::move(some, std::back_inserter(table.rows));
    return table;
  }};
}

}  // namespace springcheck
