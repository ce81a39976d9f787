# Finds what the core needs (stops with the install line when something is missing) and what the
# optional parts need (skips the part with a message).
find_package(OpenMP COMPONENTS CXX)
if(NOT OpenMP_CXX_FOUND)
  message(FATAL_ERROR "OpenMP is missing (the host back end needs it). Install: apt-get install libgomp1 (g++) or libomp-dev (clang)")
endif()
set(WEFT_OPENMP_RUNTIME ${OpenMP_CXX_LIB_NAMES})
list(REMOVE_ITEM WEFT_OPENMP_RUNTIME pthread)
find_package(Threads REQUIRED)

find_package(Eigen3 3.3 NO_MODULE QUIET)
if(NOT TARGET Eigen3::Eigen)
  message(FATAL_ERROR "Eigen is missing (cooking of fabrics needs it). Install: apt-get install libeigen3-dev")
endif()

# Thrust for the host sort: the CUDA toolkit's copy (12: include, 13: include/cccl), else the
# distribution's.
find_path(WEFT_THRUST_INCLUDE thrust/sort.h
  HINTS ENV CUDA_HOME ENV CUDA_PATH /usr/local/cuda
  PATH_SUFFIXES include/cccl include)
if(NOT WEFT_THRUST_INCLUDE)
  message(FATAL_ERROR "Thrust is missing (sorting needs it). Install: apt-get install libthrust-dev libcub-dev, or the CUDA toolkit")
endif()

if(WEFT_BUILD_TOOLS OR WEFT_BUILD_TESTS)
  find_package(nlohmann_json 3.10 QUIET)
  if(NOT nlohmann_json_FOUND)
    message(STATUS "weft: nlohmann_json is missing: scene files and the weft program are skipped (apt-get install nlohmann-json3-dev)")
  endif()
  find_package(CLI11 2.0 QUIET)
  if(NOT CLI11_FOUND)
    message(STATUS "weft: CLI11 is missing: the weft program is skipped (apt-get install libcli11-dev)")
  endif()
endif()
if(WEFT_BUILD_TESTS)
  find_package(GTest QUIET)
  if(NOT GTest_FOUND)
    message(STATUS "weft: GoogleTest is missing: the tests are skipped (apt-get install libgtest-dev)")
  endif()
endif()
