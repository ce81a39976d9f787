# weft_add_hip(TARGET): the HIP copy of the kernels, by the distribution's hipcc.
#
# hipcc compiles the device files only; everything else stays with the C++ compiler. (CMake's own HIP
# language does not find Debian's packages.) The binary starts without an AMD GPU and falls back to
# omp there; it needs libamdhip64 to be loaded.
set(WEFT_HIP_ARCHITECTURES gfx90a gfx1030 CACHE STRING "AMD GPUs to compile for")

# weft_enable_hip(): finds hipcc, the runtime and rocPRIM.
macro(weft_enable_hip)
  find_program(WEFT_HIPCC hipcc HINTS ENV ROCM_PATH /opt/rocm PATH_SUFFIXES bin)
  find_library(WEFT_AMDHIP amdhip64 HINTS ENV ROCM_PATH /opt/rocm PATH_SUFFIXES lib)
  find_path(WEFT_ROCPRIM_INCLUDE rocprim/rocprim.hpp HINTS ENV ROCM_PATH /opt/rocm PATH_SUFFIXES include)
  if(NOT WEFT_HIPCC OR NOT WEFT_AMDHIP OR NOT WEFT_ROCPRIM_INCLUDE)
    message(FATAL_ERROR "hipcc, libamdhip64 or rocPRIM is missing (BACKEND=hip needs them). Install: apt-get install hipcc libamdhip64-dev rocm-device-libs librocprim-dev, or use BACKEND=omp")
  endif()
endmacro()

function(weft_add_hip target)
  set(flags -x hip -std=c++17 -O3 -fPIC -fvisibility=hidden -ffp-contract=off -Wall -Wextra
    -DWEFT_HIP -DWEFT_BACKEND_NS=hip -DWEFT_BACKEND_NAME=\"hip\" -DWEFT_BACKEND_FACTORY=backend_hip
    -I${PROJECT_SOURCE_DIR}/src -I${PROJECT_SOURCE_DIR}/include)
  if(WEFT_WARNINGS_AS_ERRORS)
    list(APPEND flags -Werror)
  endif()
  # A folder that the compiler searches anyway must stay where it is in its order.
  if(NOT WEFT_ROCPRIM_INCLUDE STREQUAL "/usr/include")
    list(APPEND flags -isystem ${WEFT_ROCPRIM_INCLUDE})
  endif()
  foreach(architecture IN LISTS WEFT_HIP_ARCHITECTURES)
    list(APPEND flags --offload-arch=${architecture})
  endforeach()
  foreach(name backend sort_hip)
    set(source ${PROJECT_SOURCE_DIR}/src/cuda/${name}.cu)
    set(object ${CMAKE_CURRENT_BINARY_DIR}/${name}.hip.o)
    add_custom_command(OUTPUT ${object}
      COMMAND ${WEFT_CCACHE} ${WEFT_HIPCC} ${flags} -MD -MF ${object}.d -MT ${object} -c ${source} -o ${object}
      DEPENDS ${source} DEPFILE ${object}.d VERBATIM
      COMMENT "Building HIP object ${name}.hip.o")
    list(APPEND objects ${object})
  endforeach()
  set_source_files_properties(${objects} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
  target_sources(${target} PRIVATE ${objects})
  target_compile_definitions(${target} PRIVATE WEFT_HAVE_HIP)
  target_link_libraries(${target} PRIVATE ${WEFT_AMDHIP})
endfunction()
