# Install rules in three components, for CMake, pkg-config and (a shared library) Debian packages:
#   runtime      the shared library
#   development  headers, the library to link with, weftConfig.cmake, weft.pc
#   tools        the weft program and the sample scenes
# Everything finds everything else by relative paths, so that an installed tree can be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_target_property(kind weft TYPE)
set(shared FALSE)
if(kind STREQUAL "SHARED_LIBRARY")
  set(shared TRUE)
endif()

install(TARGETS weft EXPORT weftTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/weft
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
  FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/weft)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/weftConfig.cmake.in
  ${PROJECT_BINARY_DIR}/weftConfig.cmake
  INSTALL_DESTINATION ${config_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/weftConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(EXPORT weftTargets NAMESPACE weft:: DESTINATION ${config_dir} COMPONENT development)
install(FILES ${PROJECT_BINARY_DIR}/weftConfig.cmake ${PROJECT_BINARY_DIR}/weftConfigVersion.cmake
  DESTINATION ${config_dir} COMPONENT development)

# How deep weft.pc lies depends on the library folder: Debian's has one level more.
file(RELATIVE_PATH pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" pc_prefix ${pc_prefix})
file(RELATIVE_PATH pc_libdir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
file(RELATIVE_PATH pc_includedir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
set(pc_cflags "")
set(pc_libs "")
set(pc_libs_private "")
if(NOT shared)
  set(pc_cflags " -DWEFT_STATIC")
  if(UNIX AND NOT APPLE)
    set(pc_libs " -Wl,--exclude-libs,$<TARGET_FILE_NAME:weft>")
  endif()
  set(libraries ${WEFT_OPENMP_RUNTIME})
  if(BACKEND STREQUAL "cuda")
    find_package(CUDAToolkit REQUIRED)
    list(APPEND libraries -L${CUDAToolkit_LIBRARY_DIR} cudart_static rt dl)
  elseif(BACKEND STREQUAL "hip")
    list(APPEND libraries amdhip64)
  endif()
  foreach(library IN LISTS CMAKE_CXX_IMPLICIT_LINK_LIBRARIES)
    if(library MATCHES "^(stdc\\+\\+|c\\+\\+|m)$")
      list(APPEND libraries ${library})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES libraries)
  list(TRANSFORM libraries PREPEND "-l" REGEX "^[^-]")
  list(APPEND libraries ${CMAKE_THREAD_LIBS_INIT})
  list(JOIN libraries " " libraries)
  set(pc_libs_private " ${libraries}")
endif()
configure_file(${PROJECT_SOURCE_DIR}/cmake/weft.pc.in ${PROJECT_BINARY_DIR}/weft.pc.gen @ONLY)
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/weft.pc INPUT ${PROJECT_BINARY_DIR}/weft.pc.gen)
install(FILES ${PROJECT_BINARY_DIR}/weft.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

if(TARGET weft_cli)
  # In /usr the loader finds the library by itself.
  if(shared AND NOT CMAKE_INSTALL_PREFIX MATCHES "^/usr/?$")
    file(RELATIVE_PATH to_library ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
    set_target_properties(weft_cli PROPERTIES INSTALL_RPATH "$ORIGIN/${to_library}")
  endif()
  install(TARGETS weft_cli DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/samples/scenes
    DESTINATION ${CMAKE_INSTALL_DATADIR}/weft COMPONENT tools FILES_MATCHING PATTERN "*.json")
endif()

if(PROJECT_IS_TOP_LEVEL AND shared)
  include(WeftDebian)
endif()
