#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/cases/case.hpp"
#include "statics/systems/natural_modes.hpp"

namespace springcheck {

/// How a body is held while it swings.
enum class Hold { free, as_in_scene };

/// A method's modes, or why there are none: "refused", "indefinite".
struct MethodModes {
  std::string method;  // as in a heading
  std::optional<NaturalModes> modes{};
  std::string reason;
};

/// The lowest `count` modes of the case's body by finite elements, fem-hooke:q1-sri with
/// consistent and with lumped masses and q1-nodal with lumped ones, and by mss-cf,
/// mss-affine and mss-nfd.
std::vector<MethodModes> body_modes(const CaseSettings& settings, const Mesh& mesh,
                                    Hold hold, int count);

}  // namespace springcheck
