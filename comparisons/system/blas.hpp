#pragma once

#include <string>

namespace springcheck {

/// Sets OPENBLAS_CORETYPE to name better kernels, for the program that takes this one's
/// place, where OpenBLAS did not choose them though they would run; a user's own choice
/// stays. OpenBLAS chooses its kernels as it is loaded, and on processors that are
/// younger than itself those for any x86-64, which take half as long again.
void choose_fitting_blas();

/// Starts the program again without the threads that OpenBLAS starts as it is loaded,
/// where the address space is limited (ulimit -v): each of them asks for its buffer again
/// and again, for ever, where it gets none, and the program could not end. Returns where
/// there is no limit or no such thread; and with a warning on stderr where starting
/// fails.
void restart_with_one_blas_thread(char** arguments);

/// Has OpenBLAS use one thread for each call: what runs in parallel are simulations and
/// loops, with the same bits for any number of threads.
void use_one_blas_thread();

/// The version of OpenBLAS and the kernels it chose: "OpenBLAS 0.3.21 Haswell".
std::string blas_name();

/// Address space of the buffer that OpenBLAS keeps for each call at a time, on x86-64
/// [bytes].
inline constexpr double blas_buffer_bytes = 134217728;

/// Takes the buffers of so many calls at a time now, as many as OpenBLAS knows places
/// for: it asks for one again and again, for ever, where it gets none.
void reserve_blas_buffers(int calls);

}  // namespace springcheck
