# Every target of ours links this privately. GCC 12 warns falsely of -Wrestrict on "text" +
# std::string (GCC bug 105329), and of -Wstringop-overflow in fmt::join.
add_library(warnings INTERFACE)
target_compile_options(warnings INTERFACE -Wall -Wextra -Wconversion -Wno-restrict
  -Wno-stringop-overflow)

# Where several files are compiled as one (preset release), a name may shadow one of another
# file, and GCC takes what a file keeps for itself for a header's.
set(in_one $<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>)
target_compile_options(warnings INTERFACE
  $<IF:${in_one},-Wshadow=local,-Wshadow> $<${in_one}:-Wno-subobject-linkage>)

option(SPRINGCHECK_WERROR "Warnings end the build, as in continuous integration")
if(SPRINGCHECK_WERROR)
  target_compile_options(warnings INTERFACE -Werror)
endif()
