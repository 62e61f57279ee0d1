#pragma once

#include <optional>

#include "meshing/basics/stopwatch.hpp"
#include "mss/tissue/quasi_static.hpp"

namespace springcheck::mss {

struct TissueSettings {
  tissue::Solid solid;
  dynamics::QuasiStaticSettings quasi_static;
  std::optional<dynamics::Protocol> protocol;  // none: quasi-static
  int threads = 1;                             // of steps through time
};

/// Deforms the body as living tissue in springs; of the scene's material the density is
/// read. A failed simulation is a Solution with the status that says so.
Solution solve_tissue(const Mesh& mesh, const Scene& scene,
                      const TissueSettings& settings,
                      const dynamics::Observers& observers = {},
                      const Stopwatch& setup = {});

}  // namespace springcheck::mss
