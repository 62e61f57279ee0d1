# Compiles sources once per instruction set, in a namespace of its name (pack.hpp), and
# adds the objects to the target, which chooses at run time (instruction_set.hpp).
#
#   springcheck_compile_per_path(<target> <source>...)
function(springcheck_compile_per_path target)
  set(flags_portable "")
  set(flags_avx2 -mavx2 -mfma)
  set(flags_avx512 -mavx512f -mavx512dq -mavx512vl -mavx512bw -mavx2 -mfma
    -mprefer-vector-width=512)
  set(paths portable)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND paths avx2 avx512)
  endif()
  foreach(path ${paths})
    set(objects ${target}_${path})
    add_library(${objects} OBJECT ${ARGN})
    target_include_directories(${objects} PRIVATE ${PROJECT_SOURCE_DIR})
    target_compile_definitions(${objects} PRIVATE SPRINGCHECK_PATH=${path})
    # Optimised in every configuration: without it the registers are worth nothing. The
    # vectors never cross a call, so a change of their ABI is of no interest. GCC 12 warns
    # falsely of uninitialised values in its own intrinsics (GCC bug 105593).
    target_compile_options(${objects} PRIVATE ${flags_${path}} -O3 -fno-math-errno
      -Wno-psabi -Wno-uninitialized -Wno-maybe-uninitialized)
    target_link_libraries(${objects} PRIVATE Eigen3::Eigen warnings)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${objects}>)
  endforeach()
endfunction()
