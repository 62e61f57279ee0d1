#pragma once

#include <string>

#include "comparisons/store/columns.hpp"

namespace springcheck {

/// As the machine calls it; "unknown" where it does not say.
std::string processor_name();

/// What ran when and where: version and commit of this program, compiler, versions of the
/// libraries, processor, cores and threads, date (UTC).
Row provenance();

}  // namespace springcheck
