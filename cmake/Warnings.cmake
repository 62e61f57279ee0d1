# Every target of ours links this privately. -Wrestrict warns falsely on "text" +
# std::string in GCC 12 (GCC bug 105329).
add_library(warnings INTERFACE)
target_compile_options(warnings INTERFACE -Wall -Wextra -Wshadow -Wconversion -Wno-restrict)
option(SPRINGCHECK_WERROR "Warnings end the build, as in continuous integration")
if(SPRINGCHECK_WERROR)
  target_compile_options(warnings INTERFACE -Werror)
endif()
