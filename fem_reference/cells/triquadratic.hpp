#pragma once

#include <deal.II/grid/tria.h>

#include <map>
#include <string>
#include <vector>

#include "fem_reference/cells/discretisation.hpp"

namespace springcheck::fem_reference {

/// Gives the triquadratic element's intermediate nodes to a body of hexahedra that has
/// its vertices, in the order in which the cells meet them.
void add_intermediate_nodes(Discretisation& body,
                            const dealii::Triangulation<3>& triangulation);

/// int N dA of each region, node by node, on bilinear faces by 3 x 3 Gauss points.
std::map<std::string, std::vector<AreaShare>> triquadratic_area_shares(
    const Mesh& mesh, const Discretisation& body,
    const dealii::Triangulation<3>& triangulation);

}  // namespace springcheck::fem_reference
