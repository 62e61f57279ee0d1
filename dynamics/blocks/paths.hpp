#pragma once

// Functions compiled once per instruction set, each in the namespace of its path: how
// they are declared and chosen.

/// declare(path) for every path.
#define SPRINGCHECK_FOR_EACH_PATH(declare) declare(portable) declare(avx2) declare(avx512)

/// The call, qualified by the path of the dynamics::InstructionSet `set`.
#if defined(__x86_64__)
#define SPRINGCHECK_ON_PATH(set, call)                                   \
  ((set) == springcheck::dynamics::InstructionSet::avx512 ? avx512::call \
   : (set) == springcheck::dynamics::InstructionSet::avx2 ? avx2::call   \
                                                          : portable::call)
#else
#define SPRINGCHECK_ON_PATH(set, call) portable::call
#endif
