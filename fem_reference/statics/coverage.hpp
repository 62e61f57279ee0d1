#pragma once

#include <optional>
#include <string>

#include "fem_reference/laws/settings.hpp"
#include "meshing/loads/scene.hpp"

namespace springcheck::fem_reference {

/// Why law or element do not cover a scene, in words; nothing where they do. q2 has no
/// pyramids or prisms. Hooke's law knows where plates end and not how far they turned.
/// The continuum of mss-baudet inherits the range in which its springs push back.
std::optional<std::string> reason_to_refuse(const Mesh& mesh, const Scene& scene,
                                            const Settings& settings);

}  // namespace springcheck::fem_reference
