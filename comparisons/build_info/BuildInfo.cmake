# Writes build_info.cpp with the present commit and revision of the numerics; leaves the
# file alone when nothing changed.
execute_process(
  COMMAND git -C ${SOURCE_DIR} describe --always --dirty --abbrev=12 --exclude=*
  OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE
  ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(COMMIT "unknown")
endif()
include(${CMAKE_CURRENT_LIST_DIR}/Revision.cmake)
numerics_revision(REVISION ${SOURCE_DIR})
configure_file(${INPUT} ${OUTPUT} @ONLY)
