#pragma once

#include "statics/equilibrium.hpp"

namespace springcheck::statics {

/// The last state of the path from rest that is stable and turns no cell of the mesh
/// inside out, with the load fraction found to .2 % (follow_to_limit). Status ok at the
/// full load; before it indefinite where the path goes on without stability,
/// no_equilibrium at a limit point, inverted, or not_converged where the solver fails;
/// but for that with definite_up_to, and critical_wavelength.
Equilibrium last_stable_equilibrium(ElasticBody& body, const Loading& loading,
                                    const Mesh& mesh);

}  // namespace springcheck::statics
