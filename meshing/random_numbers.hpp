#pragma once

#include <mutex>

namespace springcheck {

/// libc's rand() is one stream for the whole process. METIS, which orders the matrices of
/// both solvers, starts it anew and draws from it, and gmsh draws from it too: whoever
/// calls one of them holds this, or results would depend on what else runs at the time.
std::mutex& random_numbers();

}  // namespace springcheck
