# docs/rooms.txt, which says what each folder may include; tests/house holds every include
# against it.
set(rooms_file ${PROJECT_SOURCE_DIR}/docs/rooms.txt)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY
  CMAKE_CONFIGURE_DEPENDS ${rooms_file})
file(STRINGS ${rooms_file} rooms_lines REGEX "^[^# ]")
set(rooms_all "")
foreach(line ${rooms_lines})
  string(REGEX MATCH "^([^:]+):(.*)$" _ "${line}")
  set(folder ${CMAKE_MATCH_1})
  string(STRIP "${CMAKE_MATCH_2}" sees)
  string(MAKE_C_IDENTIFIER ${folder} room)
  if(NOT folder MATCHES "^tests")
    list(APPEND rooms_all ${room})
    string(REGEX REPLACE "/.*" "" top ${folder})
    list(APPEND rooms_in_${top} ${room})  # mss: those of mss and of the folders in it
  endif()
  string(REPLACE "/" "_" sees "${sees}")
  separate_arguments(sees)
  set(rooms_seen_by_${room} "${sees}")
endforeach()

# The library of this folder, named after it (comparisons/store: comparisons_store), with
# the rooms that docs/rooms.txt lets it see and these packages. PUBLIC ones are named by
# the folder's headers. Its sources are all in the folder, unless some are named, but
# those that springcheck_compile_per_path compiles.
#
#   springcheck_room([SOURCES <file>...] [PUBLIC <target>...] [PRIVATE <target>...])
function(springcheck_room)
  cmake_parse_arguments(PARSE_ARGV 0 room "" "" "SOURCES;PUBLIC;PRIVATE")
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE folder)
  string(MAKE_C_IDENTIFIER ${folder} name)
  if(NOT DEFINED rooms_seen_by_${name})
    message(FATAL_ERROR "${rooms_file}: expected a line for ${folder}, got none")
  endif()
  foreach(package ${room_PUBLIC} ${room_PRIVATE})
    if(package IN_LIST rooms_all)
      message(FATAL_ERROR "${folder}/CMakeLists.txt: expected packages, got the room "
        "${package}, which ${rooms_file} is to list")
    endif()
  endforeach()
  if(NOT room_SOURCES)
    file(GLOB room_SOURCES CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.cpp)
    list(FILTER room_SOURCES EXCLUDE REGEX "_per_path\\.cpp$")
  endif()
  add_library(${name} ${room_SOURCES})
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:include/springcheck>)
  target_link_libraries(${name}
    PUBLIC ${rooms_seen_by_${name}} ${room_PUBLIC} Eigen3::Eigen
    PRIVATE ${room_PRIVATE} fmt::fmt $<BUILD_INTERFACE:warnings>)
endfunction()

# The libraries of all rooms that a folder of tests may see: by its own line, or the one
# ending in /** of the nearest folder above it. Of what is seen, too, "mss/**" is mss and all
# that is in it.
function(rooms_seen_by_tests folder variable)
  set(line tests/${folder})
  string(MAKE_C_IDENTIFIER ${line} key)
  while(NOT DEFINED rooms_seen_by_${key})
    if(line MATCHES "^tests/?[*]*$")
      message(FATAL_ERROR "${rooms_file}: expected a line for tests/${folder}, got none")
    endif()
    if(line MATCHES "/[*][*]$")
      string(REGEX REPLACE "/[^/]+/[*][*]$" "/**" line ${line})
    else()
      string(APPEND line "/**")
    endif()
    string(MAKE_C_IDENTIFIER ${line} key)
  endwhile()
  set(libraries "")
  foreach(seen ${rooms_seen_by_${key}})
    string(REGEX REPLACE "_[*][*]$" "(_.*)?" pattern ${seen})
    foreach(room ${rooms_all})
      if(room MATCHES "^${pattern}$" AND TARGET ${room})  # main is none
        list(APPEND libraries ${room})
      endif()
    endforeach()
  endforeach()
  set(${variable} ${libraries} PARENT_SCOPE)
endfunction()
