# deal.II as one INTERFACE target. Its own deal_ii_setup_target() uses plain
# link signatures, rejects RelWithDebInfo and exports its compiler flags.
find_package(deal.II 9.4.1 REQUIRED)
include(${DEAL_II_TARGET_CONFIG})
add_library(deal.II INTERFACE)
target_include_directories(deal.II SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
target_compile_definitions(deal.II INTERFACE ${DEAL_II_USER_DEFINITIONS}
  $<$<CONFIG:Debug>:${DEAL_II_USER_DEFINITIONS_DEBUG}>)
target_link_libraries(deal.II INTERFACE
  $<IF:$<CONFIG:Debug>,${DEAL_II_TARGET_DEBUG},${DEAL_II_TARGET_RELEASE}>)
