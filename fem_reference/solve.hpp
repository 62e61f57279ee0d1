#pragma once

#include "fem_reference/laws/settings.hpp"
#include "meshing/loads/scene.hpp"
#include "statics/search.hpp"

namespace springcheck::fem_reference {

/// Static equilibrium of the body by finite elements (deal.II), found by
/// statics::find_equilibrium, or last_stable_equilibrium where the search is to the
/// path's limit. Node numbers are the mesh's. A failed simulation is a Solution with the
/// status that says so, `refused` for q2 on other cells than hexahedra; bad input throws
/// InputError.
Solution solve(const Mesh& mesh, const Scene& scene, const Settings& settings,
               const statics::Search& search = {});

}  // namespace springcheck::fem_reference
