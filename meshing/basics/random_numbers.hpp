#pragma once

#include <mutex>

namespace springcheck {

/// libc's rand() is one stream for the whole process. METIS, which orders the matrices of
/// both solvers, starts it anew and draws from it, and gmsh and Trilinos draw from it
/// too: whoever calls one of them holds this, or results would depend on what else runs
/// at the time. Neither gmsh nor Trilinos with MPI may be in two threads at once anyway.
std::mutex& random_numbers();

}  // namespace springcheck
