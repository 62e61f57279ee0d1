#include "comparisons/tables/theory/four_springs_table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mss/stability/four_springs.hpp"

namespace springcheck {
namespace {

constexpr mss::FourSprings unit{.stiffness = 1, .length = 1};

/// Eq. 3.18 over k l.
double force_on_paper(double zeta) {
  return std::abs(zeta) > 0.5 ? std::copysign(1, zeta) - zeta : zeta;
}

/// Eq. 3.15 over l.
double centre_on_paper(double zeta) {
  return std::abs(zeta) > 0.5 ? 0 : std::sqrt(0.25 - zeta * zeta);
}

void add_row(Table& table, const char* part, double zeta, double x) {
  table.rows.push_back({.cells = {part, zeta, mss::forces_at(unit, x, zeta).top,
                                  force_on_paper(zeta), x, centre_on_paper(zeta)}});
}

Table four_springs_table() {
  const double critical = mss::bifurcation(unit);
  Table table{
      .columns = {{"part", "part"},
                  {"zeta", "zeta", "{:.4f}"},
                  {"force", "F_A/(k l)", "{:.4f}"},
                  {"force_on_paper", "F_A/(k l) on paper", "{:.4f}"},
                  {"centre", "x/l", "{:.4f}"},
                  {"centre_on_paper", "x/l on paper", "{:.4f}"}},
      .notes = {
          fmt::format("Four equal springs about a node C that may go aside (Golec 2018, "
                      "section 3.2.2), forces from the program's own springs. Straight, "
                      "C is pushed back down to zeta = {:.10f}, on paper 1/2, and from "
                      "minus that on.",
                      critical),
          "Held: A and B are held at zeta, C takes its rest; the figure's curve, Eq. "
          "3.15 and 3.18.",
          "Loads: A and B are pressed together by F_A and go to the next rest; the "
          "figure's dashed loop. It jumps beyond F_A = k l/2 from zeta = 1/2 to -3/2, "
          "and beyond -k l/2 from -1/2 to 3/2, where the thesis's text has 1/2."}};
  for (int tenths = 15; tenths >= -15; --tenths) {
    const double zeta = tenths / 10.;
    add_row(table, "held", zeta, mss::centre_at_rest(unit, zeta));
  }
  constexpr int steps = 8;
  constexpr double load_step = 0.12;  // jumps fall between two loads
  const auto loop = mss::hysteresis_loop(unit, load_step, steps);
  for (std::size_t i = 0; i < loop.size(); ++i)
    add_row(table, i > steps && i <= 3 * steps ? "load goes back" : "load grows",
            loop[i].zeta, loop[i].x);
  return table;
}

}  // namespace

TablePlan plan_four_springs_table() {
  return without_cases(four_springs_table);
}

}  // namespace springcheck
