# weft_library_kind(TARGET): what differs between a static and a shared libweft (BUILD_SHARED_LIBS).
#
# Shared: only the public interface is visible, and the SONAME is the ABI number of the headers.
# Static: WEFT_STATIC empties WEFT_API, so that a plug-in which embeds weft does not export it.
file(STRINGS ${PROJECT_SOURCE_DIR}/include/weft/core.hpp lines
  REGEX "^#define WEFT_(ABI|VERSION_(MAJOR|MINOR|PATCH)) [0-9]+$")
foreach(line IN LISTS lines)
  string(REGEX MATCH "(WEFT_[A-Z_]+) ([0-9]+)" line "${line}")
  set(${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
endforeach()
set(header_version ${WEFT_VERSION_MAJOR}.${WEFT_VERSION_MINOR}.${WEFT_VERSION_PATCH})
if(NOT header_version STREQUAL PROJECT_VERSION OR NOT DEFINED WEFT_ABI)
  message(FATAL_ERROR "include/weft/core.hpp says version ${header_version}, project() says ${PROJECT_VERSION} (packages need one version). Make them equal")
endif()

function(weft_library_kind target)
  set(is_elf FALSE)
  if(UNIX AND NOT APPLE)
    set(is_elf TRUE)
  endif()
  get_target_property(kind ${target} TYPE)
  if(kind STREQUAL "STATIC_LIBRARY")
    target_compile_definitions(${target} PUBLIC WEFT_STATIC)
    # Instances of std:: templates stay visible whatever the visibility of their arguments' owner.
    if(is_elf)
      set(file ${CMAKE_STATIC_LIBRARY_PREFIX}${target}${CMAKE_STATIC_LIBRARY_SUFFIX})
      target_link_options(${target} INTERFACE LINKER:--exclude-libs,${file})
    endif()
    return()
  endif()
  set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${WEFT_ABI})
  if(is_elf)
    set(map ${CMAKE_CURRENT_BINARY_DIR}/weft.map)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/weft.map.in ${map} @ONLY)
    target_link_options(${target} PRIVATE LINKER:--version-script=${map})
    set_target_properties(${target} PROPERTIES LINK_DEPENDS ${map})
  endif()
endfunction()
