#include "comparisons/gates/gate_keys.hpp"

#include "comparisons/gates/gate.hpp"

namespace springcheck::gates {

namespace {

constexpr ValueType text = type_of<std::string>(), number = type_of<double>(),
                    conditions{ValueType::Kind::table};

}  // namespace

const std::vector<GateKey>& gate_keys() {
  static const std::vector<GateKey> keys{
      {"name", text, "one line; every gate of a file has another"},
      {"where", conditions,
       "settings of the case, under the names of the result file's columns: numbers to a "
       "relative 1e-12, deformation also as \"5%\" or \"45deg\"; a list means any of its "
       "values. Exactly one case must match, but along a sweep"},
      {"measure", text,
       "a column of numbers: any measure, steps, solve_wall_s, ...; a component of a "
       "vector as force.z, of a matrix as mean_stress.xy; or status"},
      {"reason", text, "one line that says why the band is so wide"},
      {"expect", type_of<std::vector<Status>>(),
       "status, or a list of them, that the case must have (default \"ok\"); where it is "
       "given without a measure, it is the gate"},
      {"equals", number,
       "stored value, with absolute or relative half width; of both, the larger"},
      {"absolute", number, "half width of the band, in the unit of the measure"},
      {"relative", number, "half width of the band over the value at its middle"},
      {"at_least", number, "lower edge of the band"},
      {"at_most", number, "upper edge of the band"},
      {"against", conditions,
       "settings in which another case differs, with absolute or relative half width "
       "about its measure; measure in it names another measure. What where says of "
       "settings that the other method does not read is passed over; its status must be "
       "ok"},
      {"ratio_to", conditions,
       "likewise; the measure over the other's, with at_least or at_most. Times must be "
       "of one session (a row of /provenance), as only they share machine and load"},
      {"fixed", type_of<bool>(),
       "true: --bless leaves the value, a figure of someone else; at the top of the "
       "file, of all its gates"},
      {"along", text,
       "the setting that a monotonic sweep or an order of convergence goes along"},
      {"monotonic", type_of<Direction>(),
       "\"increasing\" or \"decreasing\" (strictly) along the setting along; every value "
       "that where lists must be there, and cases must differ in nothing else"},
      {"order_at_least", number,
       "least observed order of convergence of the three finest grids, along = "
       "\"cells\"; none is seen outside [.3, 4.5]"},
      {"order_between", type_of<std::array<double, 2>>(), "both edges of that order"}};
  return keys;
}

}  // namespace springcheck::gates
