#pragma once

#include <functional>
#include <string>

#include "fem_reference/cells/discretisation.hpp"
#include "meshing/loads/scene.hpp"

namespace springcheck::fem_reference {

/// Consistent nodal forces of a body force density [N/m^3]: int N_a f dV [N].
Eigen::VectorXd body_load(const Discretisation& body,
                          const std::function<Vector3(const Vector3&)>& density);

/// Consistent nodal forces of a uniform dead stress [Pa] on a region [N].
Eigen::VectorXd traction_load(const Discretisation& body, const Traction& traction);

/// int u dA/A over a region [m].
Vector3 mean_displacement(const Discretisation& body, const std::string& region,
                          const Eigen::VectorXd& displacements);

}  // namespace springcheck::fem_reference
