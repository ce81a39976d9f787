# weft_add_backends(TARGET): links the back ends that BACKEND names into TARGET.
#
# The kernels are compiled once per x86-64 level (namespaces omp_v2, omp_v3, omp_v4) and once by the
# GPU compiler (cuda or hip). Contraction is off everywhere: every copy gives the same bits.
set(WEFT_KERNEL_FLAGS -fno-exceptions -ffp-contract=off -fno-math-errno -fno-trapping-math)

set(levels v2)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(levels v2 v3 v4)
endif()
set(WEFT_ISA_LEVELS "${levels}" CACHE STRING "x86-64 levels of the host kernels; v2 runs everywhere")

set(WEFT_KERNELS_FROM "" CACHE PATH
  "Build folder of the same compiler and flags whose host kernels are linked instead of compiled ones")

# One copy of the host kernels in namespace NS; MARCH may be empty.
function(weft_add_host_kernels target ns march)
  add_library(${target} OBJECT ${PROJECT_SOURCE_DIR}/src/omp/backend.cpp)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include)
  target_compile_definitions(${target} PRIVATE WEFT_BACKEND_NS=${ns}
    WEFT_BACKEND_NAME="${ns}" WEFT_BACKEND_FACTORY=backend_${ns} ${ARGN})
  target_compile_options(${target} PRIVATE ${WEFT_KERNEL_FLAGS})
  if(NOT WEFT_SANITIZE)
    # -O3 and not -O2: g++ 12 vectorises the block loops only there.
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release,RelWithDebInfo>:-O3>)
  endif()
  if(march)
    target_compile_options(${target} PRIVATE -march=${march})
  endif()
  set_target_properties(${target} PROPERTIES
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON UNITY_BUILD OFF)
  target_link_libraries(${target} PRIVATE OpenMP::OpenMP_CXX)
  weft_warnings(${target})
  weft_sanitize(${target} KERNELS)
endfunction()

function(weft_add_backends target)
  foreach(level IN LISTS WEFT_ISA_LEVELS)
    set(march "")
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
      set(march x86-64-${level})
    endif()
    if(WEFT_KERNELS_FROM)
      add_library(weft_omp_${level} OBJECT IMPORTED GLOBAL)
      get_filename_component(folder ${WEFT_KERNELS_FROM} ABSOLUTE BASE_DIR ${CMAKE_SOURCE_DIR})
      set_target_properties(weft_omp_${level} PROPERTIES IMPORTED_OBJECTS
        ${folder}/src/CMakeFiles/weft_omp_${level}.dir/omp/backend.cpp${CMAKE_CXX_OUTPUT_EXTENSION})
    else()
      weft_add_host_kernels(weft_omp_${level} omp_${level} "${march}")
    endif()
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:weft_omp_${level}>)
    target_compile_definitions(${target} PRIVATE WEFT_HAVE_OMP_${level})
  endforeach()

  add_library(weft_omp_sort OBJECT ${PROJECT_SOURCE_DIR}/src/omp/sort.cpp)
  target_include_directories(weft_omp_sort PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_include_directories(weft_omp_sort SYSTEM PRIVATE ${WEFT_THRUST_INCLUDE})
  target_compile_definitions(weft_omp_sort PRIVATE THRUST_DEVICE_SYSTEM=THRUST_DEVICE_SYSTEM_OMP)
  set_target_properties(weft_omp_sort PROPERTIES
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON UNITY_BUILD OFF)
  target_link_libraries(weft_omp_sort PRIVATE OpenMP::OpenMP_CXX)
  weft_warnings(weft_omp_sort)
  weft_sanitize(weft_omp_sort)
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:weft_omp_sort>)
  # An installed static library asks for the runtime it was compiled for, by name: another compiler's
  # OpenMP may be another runtime.
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:OpenMP::OpenMP_CXX>
    $<INSTALL_INTERFACE:${WEFT_OPENMP_RUNTIME}> Threads::Threads)

  if(BACKEND STREQUAL "cuda")
    weft_add_cuda(${target})
  elseif(BACKEND STREQUAL "hip")
    weft_add_hip(${target})
  elseif(NOT BACKEND STREQUAL "omp")
    message(FATAL_ERROR "BACKEND=${BACKEND} is not a back end (omp, cuda or hip). Set one of the three")
  endif()
endfunction()
