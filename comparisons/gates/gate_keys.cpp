#include "comparisons/gates/gate_keys.hpp"

namespace springcheck::gates {

const std::vector<Described>& gate_keys() {
  static const std::vector<Described> keys{
      {"name", "one line; every gate of a file has another"},
      {"where",
       "settings of the case, under the names of the result file's columns: numbers to a "
       "relative 1e-12, deformation also as \"5%\" or \"45deg\"; a list means any of its "
       "values. Exactly one case must match, but along a sweep"},
      {"measure",
       "a column of numbers: any measure, steps, solve_wall_s, ...; a component of a "
       "vector as force.z, of a matrix as mean_stress.xy; or status"},
      {"reason", "one line that says why the band is so wide"},
      {"expect",
       "status, or a list of them, that the case must have (default \"ok\"); where it is "
       "given without a measure, it is the gate"},
      {"equals",
       "stored value, with absolute or relative half width; of both, the larger"},
      {"absolute", "half width of the band, in the unit of the measure"},
      {"relative", "half width of the band over the value at its middle"},
      {"at_least", "lower edge of the band"},
      {"at_most", "upper edge of the band"},
      {"against",
       "settings in which another case differs, with absolute or relative half width "
       "about its measure; measure in it names another measure. What where says of "
       "settings that the other method does not read is passed over; its status must be "
       "ok"},
      {"ratio_to",
       "likewise; the measure over the other's, with at_least or at_most. Times must be "
       "of one session (a row of /provenance), as only they share machine and load"},
      {"fixed",
       "true: --bless leaves the value, a figure of someone else; at the top of the "
       "file, "
       "of all its gates"},
      {"along",
       "the setting that a monotonic sweep or an order of convergence goes along"},
      {"monotonic",
       "\"increasing\" or \"decreasing\" (strictly) along the setting along; every value "
       "that "
       "where lists must be there, and cases must differ in nothing else"},
      {"order_at_least",
       "least observed order of convergence of the three finest grids, along = "
       "\"cells\"; "
       "none is seen outside [.3, 4.5]"},
      {"order_between", "both edges of that order"}};
  return keys;
}

}  // namespace springcheck::gates
