# What nearly every file includes, parsed once: a third of a file's time was this. Without
# json.hpp, whose weight all would carry: our headers have json_fwd.hpp.
option(SPRINGCHECK_PRECOMPILE "Precompile headers" ON)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # ccache then knows a file that uses them.
  add_compile_options(-fpch-preprocess)
  # No collecting of garbage below half a gigabyte, most of it the precompiled headers': a
  # tenth of the time.
  add_compile_options(--param ggc-min-heapsize=524288)
endif()
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cpp CONTENT "")

# An object library whose headers others can take over: those of below and further ones.
#
#   add_precompiled(<name> LIBRARIES <target>... DEFINITIONS <name>... HEADERS <header>...)
function(add_precompiled name)
  if(NOT SPRINGCHECK_PRECOMPILE)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 precompiled "" "" "LIBRARIES;DEFINITIONS;HEADERS")
  add_library(${name} OBJECT ${CMAKE_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(${name} PRIVATE Eigen3::Eigen fmt::fmt ${precompiled_LIBRARIES} warnings)
  target_compile_definitions(${name} PRIVATE ${precompiled_DEFINITIONS})
  target_precompile_headers(${name} PRIVATE
    <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <numeric> <optional>
    <ranges> <set> <span> <sstream> <stdexcept> <string> <vector>
    <Eigen/Geometry> <fmt/format.h> <fmt/ranges.h> ${precompiled_HEADERS})
endfunction()

# GCC 12 forgets of a precompiled header which false warnings its functions have been
# cleared of: those are off here, and on in the preset dev, which precompiles nothing.
function(use_precompiled target precompiled)
  if(SPRINGCHECK_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${precompiled})
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow)
  endif()
endfunction()

add_precompiled(precompiled)
