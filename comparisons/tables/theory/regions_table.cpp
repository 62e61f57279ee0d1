#include "comparisons/tables/theory/regions_table.hpp"

#include <cmath>
#include <numbers>

#include "comparisons/tables/theory/integrator_regions.hpp"

namespace springcheck {
namespace {

using dynamics::Integrator;

void add_point(Table& table, const char* figure, const char* name, Integrator integrator,
               double zeta) {
  const double r = region_border(integrator, zeta);
  const bool has_gamma = std::abs(zeta) <= 1;  // else two, and real
  const auto if_gamma = [&](double value) {
    return Cell{has_gamma ? std::optional(value) : std::nullopt};
  };
  table.rows.push_back(
      {.cells = {figure, name, zeta, r, border_on_paper(integrator, zeta),
                 if_gamma(-r * zeta),
                 if_gamma(r * std::sqrt(std::max(0., 1 - zeta * zeta))),
                 integrator == Integrator::implicit_euler ? "outside" : "inside"}});
}

Table regions_table() {
  Table table{
      .columns = {{"figure", "figure"},
                  {"integrator", "integrator"},
                  {"zeta", "zeta", "{:.4f}"},
                  {"border", "border, omega dt", "{:.6f}"},
                  {"on_paper", "on paper", "{:.6f}"},
                  {"real", "Re Gamma dt", "{:.4f}"},
                  {"imaginary", "Im Gamma dt", "{:.4f}"},
                  {"stable", "stable"}},
      .notes = {
          "Where the spectral radius of a step's matrix, made by stepping unit states of "
          "the oscillator x'' = -2 zeta omega x' - omega^2 x with the program's own "
          "integrators, goes through 1. Its Gamma dt is omega dt (-zeta +- i sqrt(1 - "
          "zeta^2)): upper halves of the figures' borders.",
          "On paper: |1 + Gamma dt| = 1 (2.2, right), |1 - Gamma dt| = 1 (2.2, left), "
          "|Gamma dt - 2| = 2 sqrt(2) (2.3). Of the last circle only the part left of "
          "the imaginary axis is stable; the thesis's text names the whole one.",
          "In the plane of omega dt and zeta semi-implicit Euler and Verlet with the "
          "dashpots of the step before have the same border 2 (sqrt(1 + zeta^2) - "
          "zeta)."}};
  constexpr int rays = 12;
  const auto zeta_of = [](int ray) {  // angles from the imaginary axis to the real one
    return std::sin(std::numbers::pi / 2 * ray / rays);
  };
  for (int ray = 1; ray <= rays; ++ray)  // the first would touch the origin only
    add_point(table, "2.2 left", "implicit Euler", Integrator::implicit_euler,
              -zeta_of(ray));
  for (int ray = 1; ray <= rays; ++ray)
    add_point(table, "2.2 right", "explicit Euler", Integrator::explicit_euler,
              zeta_of(ray));
  for (int ray = 0; ray <= rays; ++ray)
    add_point(table, "2.3", "semi-implicit Euler", Integrator::semi_implicit_euler,
              zeta_of(ray));
  for (const auto& [name, integrator] :
       {std::pair{"semi-implicit Euler", Integrator::semi_implicit_euler},
        {"Verlet", Integrator::verlet}})
    for (int tenths = 0; tenths <= 20; ++tenths)
      add_point(table, "omega dt, zeta", name, integrator, tenths / 10.);
  return table;
}

}  // namespace

TablePlan plan_regions_table() {
  return without_cases(regions_table);
}

}  // namespace springcheck
