#pragma once

#include <string>

namespace springcheck {

/// OpenBLAS chooses its kernels as it is loaded, and on processors that are younger than
/// itself those for any x86-64, which take half as long again. Where it did so though
/// better ones would run, sets OPENBLAS_CORETYPE to name them, for the program that takes
/// this one's place; a user's own choice stays.
void choose_fitting_blas();

/// Where the address space is limited (ulimit -v), starts the program again without the
/// threads that OpenBLAS starts as it is loaded: each asks for its buffer again and
/// again, for ever, where it gets none, and the program could not end. Returns where it
/// has none; and with a warning on stderr where starting fails.
void restart_with_one_blas_thread(char** arguments);

/// One thread for each call: what runs in parallel are simulations and loops, with the
/// same bits for any number of threads.
void use_one_blas_thread();

/// Its version and the kernels it chose: "OpenBLAS 0.3.21 Haswell".
std::string blas_name();

/// Address space of the buffer that OpenBLAS keeps for each call at a time, on x86-64
/// [bytes].
inline constexpr double blas_buffer_bytes = 134217728;

/// Takes the buffers of so many calls at a time now, as many as OpenBLAS knows places
/// for: it asks for one again and again, for ever, where it gets none.
void reserve_blas_buffers(int calls);

}  // namespace springcheck
