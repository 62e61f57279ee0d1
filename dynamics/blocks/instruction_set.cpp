#include "dynamics/blocks/instruction_set.hpp"

namespace springcheck::dynamics {

std::string_view name_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::portable:
      return "portable";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::avx512:
      return "avx512";
  }
  return {};
}

bool is_available(InstructionSet set) {
  if (set == InstructionSet::portable) return true;
#if defined(__x86_64__)
  if (set == InstructionSet::avx2)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
#else
  return false;
#endif
}

InstructionSet best_instruction_set() {
  InstructionSet best = InstructionSet::portable;
  for (const InstructionSet set : all_instruction_sets)
    if (is_available(set)) best = set;
  return best;
}

}  // namespace springcheck::dynamics
