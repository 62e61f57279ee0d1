#pragma once

#include "comparisons/store/columns.hpp"

namespace springcheck {

/// What ran when and where: version and commit of this program, compiler, versions of the
/// libraries, processor, cores and threads, date (UTC).
Row provenance();

}  // namespace springcheck
