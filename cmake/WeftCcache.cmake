# An object that was compiled before is not compiled again, where ccache is installed and the user
# chose no launcher. WEFT_CCACHE is the command to put before a compiler that CMake does not call.
option(WEFT_USE_CCACHE "Compile through ccache where it is installed" ${PROJECT_IS_TOP_LEVEL})
set(WEFT_CCACHE "")
if(WEFT_USE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(WEFT_CCACHE_PROGRAM ccache)
  if(WEFT_CCACHE_PROGRAM)
    # A precompiled header is found again only where its defines and its time are not looked at.
    set(WEFT_CCACHE env
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} ${WEFT_CCACHE_PROGRAM})
    set(CMAKE_C_COMPILER_LAUNCHER ${WEFT_CCACHE})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${WEFT_CCACHE})
  endif()
endif()
