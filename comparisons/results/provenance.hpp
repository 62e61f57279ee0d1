#pragma once

#include <string>

#include "comparisons/store/columns.hpp"

namespace springcheck {

/// What ran when and where: version, commit and revision of this program, versions of the
/// libraries, the environment, date (UTC). The revision of the numerics is this
/// program's, unless another is given.
Row provenance(const std::string& revision = "");

}  // namespace springcheck
