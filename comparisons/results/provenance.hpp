#pragma once

#include <string>

#include "comparisons/store/columns.hpp"

namespace springcheck {

/// What ran when and where: version, commit and revision of this program, compiler,
/// versions of the libraries, processor and its instructions, cores and threads, date
/// (UTC).
Row provenance();

}  // namespace springcheck
