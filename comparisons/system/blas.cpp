#include "comparisons/system/blas.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

#include "comparisons/system/memory.hpp"

// Some versions of cblas.h do not declare these.
extern "C" void openblas_set_num_threads(int);
extern "C" char* openblas_get_corename();
extern "C" char* openblas_get_config();
extern "C" void* blas_memory_alloc(int);
extern "C" void blas_memory_free(void*);

namespace springcheck {
namespace {

/// OpenBLAS's name of the best kernels this processor runs; nullptr: those for any.
const char* fitting_core() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
    return "SkylakeX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "Haswell";
#endif
  return nullptr;
}

}  // namespace

void choose_fitting_blas() {
  const char* core = fitting_core();
  if (core != nullptr && std::string_view(openblas_get_corename()) == "Prescott")
    setenv("OPENBLAS_CORETYPE", core, 0);
}

void restart_with_one_blas_thread(char** arguments) {
  constexpr const char* variable = "OPENBLAS_NUM_THREADS";
  const char* threads = std::getenv(variable);
  if (std::isinf(room_of_address_space()) ||
      (threads != nullptr && std::string_view(threads) == "1"))
    return;
  setenv(variable, "1", 1);
  execv("/proc/self/exe", arguments);
  fmt::print(stderr,
             "springcheck: could not start again with {}=1 ({}): in so little address "
             "space it may hang as it ends\n",
             variable, std::strerror(errno));
}

void use_one_blas_thread() {
  openblas_set_num_threads(1);
}

std::string blas_name() {
  const std::string config = openblas_get_config();  // "OpenBLAS 0.3.21 DYNAMIC_ARCH ..."
  const std::size_t version = config.find(' ', config.find(' ') + 1);
  return config.substr(0, version) + " " + openblas_get_corename();
}

void reserve_blas_buffers(int calls) {
  constexpr int places = 64;  // of twice as many that OpenBLAS is built with at the least
  calls = std::min(calls, places);
  std::vector<void*> buffers;
  for (int i = 0; i < calls; ++i) buffers.push_back(blas_memory_alloc(0));
  for (void* buffer : buffers) blas_memory_free(buffer);
}

}  // namespace springcheck
