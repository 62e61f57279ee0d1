#pragma once

#include "fem_reference/laws/settings.hpp"
#include "meshing/loads/scene.hpp"
#include "statics/systems/natural_modes.hpp"

namespace springcheck::fem_reference {

/// The mass matrix, its blocks m_ab I between nodes a and b of a cell [kg]:
///
///     consistent  m_ab = int rho N_a N_b dV: frequencies converge from above, as far as
///                 the stiffness is fully integrated
///     lumped      m_aa = int rho N_a dV, the consistent row sums, else 0: below the
///                 consistent ones
///
/// Source: Hughes, The Finite Element Method (1987), sections 7.3.2 and 9.1.
enum class MassMatrix { consistent, lumped };

/// The lowest `count` modes of small vibrations about the rest state, held as the scene's
/// plates and pins hold it: the plates do not move, loads do not act. Rows of the shapes
/// are components, 3 node + component, q2's intermediate nodes behind the mesh's; 0 where
/// prescribed. None where the law is unstable at rest. The element must be one that solve
/// does not refuse.
std::optional<NaturalModes> rest_modes(const Mesh& mesh, const Scene& scene,
                                       const Settings& settings, MassMatrix mass,
                                       int count);

}  // namespace springcheck::fem_reference
