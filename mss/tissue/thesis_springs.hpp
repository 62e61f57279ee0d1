#pragma once

#include "dynamics/quasi_static/quasi_static.hpp"
#include "mss/networks/network.hpp"
#include "tissue/thesis_spring.hpp"

namespace springcheck::mss {

/// Moves springs of Eq. 4.4 through equilibria: the springs and the volume correction of
/// mss-cf, of Young's modulus K in number and the scene's Poisson ratio (see
/// thesis_tissue), each spring with the tension of a ThesisSpring. Time changes nothing:
/// Eq. 4.4's dashpots have no constant. Of the scene's material the density is read.
///
/// Refused where mss-cf is. See dynamics::find_quasi_static; residuals are measured by
/// the largest norm of the springs' tensions so far. Source: Golec 2018, section 4.4.
Solution move_thesis_springs(const Mesh& mesh, const Scene& scene,
                             const tissue::ThesisSpring& spring,
                             const dynamics::QuasiStaticSettings& settings,
                             const dynamics::Observers& observers = {});

}  // namespace springcheck::mss
