#pragma once

#include <tbb/global_control.h>

#include <string>

namespace springcheck {

/// What a process computes with. Between two that differ in instructions or BLAS figures
/// differ by rounding; times can be compared where all of it is the same, as far as the
/// machine's other work allows.
struct Environment {
  std::string processor;     // as the machine calls it
  std::string machine;       // eight digits of its own, empty where it has none
  std::string clock;         // who sets the frequency, see clock_policy
  std::string instructions;  // of the kernels, and whose processor: "avx2 AuthenticAMD"
  std::string blas;          // version and kernels: "OpenBLAS 0.3.21 Haswell"
  std::string compiler;
  std::string flags;  // but those of warnings and of the kernels' instructions
  int cores;
  int threads;  // of loops, at most
};

/// The environment of this process, now.
Environment environment();

/// The environment as text: "AMD EPYC (machine 0123abcd), clock unknown, avx512
/// AuthenticAMD, OpenBLAS ..., GCC ..., -O3". It has all but cores and threads, which
/// belong to each measurement.
std::string text_of(const Environment& environment);

/// Sets what a process computes with, for as long as this lives: one thread for each call
/// of OpenBLAS, so that results have the same bits for any number of threads, and at most
/// so many for loops, which run cases, cells and nodes side by side. CHOLMOD is kept to
/// one where it is called (meshing/sparse_cholesky).
class ThreadsInUse {
 public:
  explicit ThreadsInUse(int threads);

 private:
  tbb::global_control limit_;
};

}  // namespace springcheck
