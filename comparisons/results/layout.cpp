#include "comparisons/results/layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "comparisons/measures/history.hpp"

namespace springcheck {

const std::vector<Described>& file_layout() {
  static const std::string fields = fmt::format(
      "of nodes displacement [m], reaction [N] (unless measured without forces), "
      "deviation [m] (displacement less the reference's); of cells cell_volume_ratio, "
      "spring_strain (of springs, the strain of largest size); named partial_... when "
      "the case ended without an equilibrium; empty where it was computed with fields "
      "and has none. Through time with `history` also history, a row for each sample of "
      "{} (stress is mean_stress, in affine; answer the measure that answers the test's "
      "load), columns that the attribute history_columns names with spaces between, and "
      "the body at up to 24 of these samples (fewer of large bodies), one after the "
      "other: frame_sample (its row of history, from 0), frame_displacement [m], "
      "frame_cell_volume_ratio",
      fmt::join(history_columns, ", "));
  static const std::vector<Described> parts{
      {"/", "attribute layout: 2"},
      {"/cases",
       "a dataset of one length for each column: every setting, every measure and the "
       "columns of `list columns`. Texts are UTF-8 padded with zeros; what a case has "
       "not is NaN or an empty text; vectors are rows of 3, matrices of 9 numbers"},
      {"/provenance",
       "a row for each time the file was written: springcheck, commit, revision (of the "
       "numerics: a hash of their sources), compiler, flags, deal.II, gmsh, Eigen, HDF5, "
       "BLAS (with its kernels), cpu, machine (digits of its own), clock (who sets the "
       "frequency), instructions, cores, threads, date"},
      {"/meshes/SHA256",
       "nodes [m]; tetrahedra, pyramids, prisms, hexahedra, those there are (gmsh's "
       "order, from 0; fields of cells follow in this order); regions/NAME (outward "
       "faces, of triangles the last node twice; in names '/' and '%' are %2F and %25); "
       "with prisms or several types "
       "xdmf_topology, the same cells for ParaView"},
      {"/maps/SHA256",
       "maps of `springcheck stability`: attributes scene, first, second (settings), "
       "revision, other_revisions (of cases that were taken all the same), complete; "
       "points (columns method, first, second, key, control: the case that locking is "
       "judged by), limits (method, second, low, high, failure, key)"},
      {"/charts/SHA256",
       "charts of `springcheck chart`: attributes scene, settings, law, answer, height, "
       "imposed, machine, revision; truths (law, size_1 to size_3, key_1 to key_3, "
       "formal_order, the same of the grids that check them with check_ before, "
       "places_apart), points "
       "(model, kind, across, cells, nodes, threads, key, left_out, setup, simulated, "
       "times, repetitions, minimum, lower_quartile, median, upper_quartile, maximum), "
       "comparisons (key, law, compared)"},
      {"/fields/KEY", fields}};
  return parts;
}

const std::vector<Described>& case_columns() {
  static const std::vector<Described> columns{
      {"key", "SHA-256 of identity and revision of the numerics"},
      {"identity", "SHA-256 of settings, reference and mesh"},
      {"scene", "the shipped scene, or the name of a scene file"},
      {"family", "of the method: springs, finite elements or measured"},
      {"mesh", "SHA-256 of the mesh, its name in /meshes"},
      {"reference", "what deviations are measured against"},
      {"reference_settings", "all settings of that reference, as JSON"},
      {"status", "how the case ended"},
      {"flags",
       "all that apply of wrinkled, inverted, indefinite and extrapolated, with commas"},
      {"reason", "why, in words"},
      {"load_fraction", "part of the load that was reached"},
      {"steps", "Newton steps, or steps through time"},
      {"force_evaluations", "how often the forces of all cells were computed"},
      {"linear_iterations", "of iterative linear solvers"},
      {"factorisations", "of direct linear solvers"},
      {"dt_used", "last step through time", "s"},
      {"dt_limit", "largest stable step, as looked at last", "s"},
      {"provenance", "row of /provenance: who computed it, with what and when"},
      {"source", "\"measured\", of what another program computed"},
      {"displacements", "SHA-256 of the numbers that were measured"},
      {"forces", "SHA-256 of the forces that were measured"}};
  return columns;
}

}  // namespace springcheck
