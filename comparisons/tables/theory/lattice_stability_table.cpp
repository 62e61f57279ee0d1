#include "comparisons/tables/theory/lattice_stability_table.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>

#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "mss/stability/uniaxial_lattice.hpp"

namespace springcheck {
namespace {

using mss::LatticeLimit;
using mss::LatticeLoss;
using mss::UniaxialLoad;

const std::vector<double> ratios{0.01, 0.03, 0.1, 0.3, 1, 3, 10, 100};
constexpr double poisson_ratios[] = {0, 0.1, 0.25, 0.4, 0.499};
constexpr double most_compression = 0.9, most_tension = 1;
// Waves below it are wrinkles of cells, not of the body.
constexpr double longest_wrinkle = 4;  // [cells]

struct Row {
  std::string method;
  double diagonal_ratio;
  double poisson_ratio;
  mss::Network cell;  // of the infinite lattice
};

/// One cell of 1 m and 1 Pa: strains depend on neither.
mss::Network cell_of(const Method& method, double diagonal_ratio, double poisson_ratio,
                     MeshStore& meshes) {
  GivenSettings changes{{"method", method.name},
                        {"nu", poisson_ratio},
                        {"young", 1.},
                        {"size", std::array{1., 1., 1.}},
                        {"cells", std::array{1, 1, 1}}};
  if (reads(method, "diagonal-ratio"))
    changes.push_back({"diagonal-ratio", diagonal_ratio});
  const CaseSettings settings = case_of_scene("compression", changes);
  return method.network(settings, meshes.mesh(settings.body)).value();
}

/// Lattices of cubes that are right for any Poisson's ratio, over A where they have it.
std::vector<Row> all_rows(MeshStore& meshes) {
  std::vector<Row> rows;
  for (const Method& method : methods()) {
    if (!method.lattice || !method.lattice->of_cubes || !method.corrects_volume) continue;
    const std::vector<double> own{method.fixed.diagonal_ratio.value_or(0)};
    for (const double ratio : reads(method, "diagonal-ratio") ? ratios : own)
      for (const double nu : poisson_ratios)
        rows.push_back({.method = method.name,
                        .diagonal_ratio = ratio,
                        .poisson_ratio = nu,
                        .cell = cell_of(method, ratio, nu, meshes)});
  }
  return rows;
}

std::string loss_in(const LatticeLimit& limit) {
  switch (limit.loss) {
    case LatticeLoss::none:
      return "nothing";
    case LatticeLoss::lateral_minimum:
      return "free sides";
    case LatticeLoss::wave:
      break;
  }
  const double length = wavelength(limit.wave.value());
  if (std::isinf(length)) return "long waves";
  return length < longest_wrinkle ? "wrinkle" : "wave";
}

/// Phases over pi; of a long wave those in proportion, the largest 1.
std::string components(const mss::LatticeWave& wave) {
  const double unit =
      std::isinf(wavelength(wave)) ? wave.phases.maxCoeff() : std::numbers::pi;
  const Vector3 t = wave.phases / unit;
  const auto rounded = [](double value) {
    return fmt::format("{:g}", std::round(100 * value) / 100);
  };
  return fmt::format("{} {} {}", rounded(t.x()), rounded(t.y()), rounded(t.z()));
}

void add_cells(std::vector<Cell>& cells, const LatticeLimit& limit) {
  const bool is_lost = limit.loss != LatticeLoss::none;
  cells.push_back({is_lost ? std::optional(100 * limit.strain) : std::nullopt,
                   fmt::format("> {:.0f}", 100 * limit.strain)});
  cells.push_back(loss_in(limit));
  if (!limit.wave) {
    cells.insert(cells.end(), {{}, {}});
    return;
  }
  cells.push_back(components(*limit.wave));
  const double length = wavelength(*limit.wave);
  cells.push_back(
      {std::isinf(length) ? std::nullopt : std::optional(length), "infinite"});
}

Table lattice_stability_table(MeshStore& meshes) {
  Table table{
      .columns = {{"method", "method"},
                  {"diagonal_ratio", "A", "{:.4g}"},
                  {"nu", "nu", "{}"}},
      .notes = {
          "Bloch waves: the lattice stretched by l, l, z along its axes, l such that the "
          "mean lateral stress is zero, followed from rest; the first strain at which "
          "some plane wave exp(i q X) lowers the energy. It needs no block: what holds "
          "or frees a body's surface moves its limit. Free surfaces let wrinkles in "
          "earlier, plates hold them off.",
          "Wave: the components of the critical h q over pi, 1 for ends of a cell in "
          "opposite phase; z is the loaded axis, and the wave's mirror images are lost "
          "with it. Wavelength: 2 pi/|q| in undeformed cells. Wrinkle: below four cells. "
          "Long waves: the acoustic tensor is lost first, a property of the lattice's "
          "continuum; only the direction is given. Where waves of all lengths in one "
          "direction are lost at once they are called long.",
          "Free sides: the energy has no minimum over l beyond that strain, a limit "
          "point. Compression is looked at up to 90 %, tension up to 100 %.",
          "Mss-nfd, A = 0, has waves without energy at rest, which turn negative with "
          "the first strain; a block's plates hold them up to some per cent. So has "
          "mss-baudet, for every nu. Mss-fd is, for every nu, mss-cf at nu = 0.25.",
          "The continuum of St-Venant and Kirchhoff has a limit of its own: the force on "
          "a compressed bar is largest at a stretch of 1/sqrt(3), a strain of 42.3 %. "
          "Its long waves are lost before, from 40.7 %: those of mss-stvk, whose "
          "homogeneous states are that law's whatever A. With few face diagonals, or "
          "hardly anything else, it wrinkles earlier."}};
  for (const char* load : {"compression", "tension"})
    for (const auto& [key, heading, format] :
         {std::tuple{"strain", "strain [%]", "{:.2f}"},
          {"loss", "lost", ""},
          {"wave", "wave", ""},
          {"wavelength", "wavelength [cells]", "{:.2f}"}})
      table.columns.push_back({.key = fmt::format("{}_{}", load, key),
                               .heading = fmt::format("{}: {}", load, heading),
                               .format = format});
  const std::vector<Row> rows = all_rows(meshes);
  std::vector<std::array<LatticeLimit, 2>> limits(rows.size());
  tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t i) {
    const mss::Network& cell = rows[i].cell;
    limits[i] = {mss::uniaxial_limit(cell, UniaxialLoad::compression, most_compression),
                 mss::uniaxial_limit(cell, UniaxialLoad::tension, most_tension)};
  });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    TableRow row{
        .cells = {rows[i].method, rows[i].diagonal_ratio, rows[i].poisson_ratio}};
    for (const LatticeLimit& limit : limits[i]) add_cells(row.cells, limit);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

TablePlan plan_lattice_stability_table() {
  return {.make = [](std::span<const CaseResult>, MeshStore& meshes) {
    return lattice_stability_table(meshes);
  }};
}

}  // namespace springcheck
