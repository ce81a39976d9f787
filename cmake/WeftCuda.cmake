# weft_add_cuda(TARGET): the CUDA copy of the kernels. The runtime is linked statically, so the binary
# starts on a machine without a driver and falls back to omp there.

# weft_enable_cuda(): finds nvcc; to be called at the top level, where languages are enabled.
macro(weft_enable_cuda)
  if(NOT CMAKE_CUDA_COMPILER AND NOT DEFINED ENV{CUDACXX})
    find_program(WEFT_NVCC nvcc HINTS ENV CUDA_HOME /usr/local/cuda PATH_SUFFIXES bin)
    if(NOT WEFT_NVCC)
      message(FATAL_ERROR "nvcc is missing (BACKEND=cuda needs the CUDA toolkit). Install the toolkit, or use BACKEND=omp")
    endif()
    set(CMAKE_CUDA_COMPILER ${WEFT_NVCC})
  endif()
  if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
    set(CMAKE_CUDA_ARCHITECTURES 75 80 90)
  endif()
  enable_language(CUDA)
endmacro()

function(weft_add_cuda target)
  add_library(weft_cuda OBJECT ${PROJECT_SOURCE_DIR}/src/cuda/backend.cu ${PROJECT_SOURCE_DIR}/src/cuda/sort.cu)
  target_include_directories(weft_cuda PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include)
  target_compile_definitions(weft_cuda PRIVATE WEFT_BACKEND_NS=cuda
    WEFT_BACKEND_NAME="cuda" WEFT_BACKEND_FACTORY=backend_cuda)
  target_compile_options(weft_cuda PRIVATE -fmad=false -Xcompiler=-ffp-contract=off,-Wall)
  # How many registers a kernel takes is kept next to its object; a test reads it.
  find_package(Python3 3.9 COMPONENTS Interpreter QUIET)
  if(Python3_Interpreter_FOUND AND NOT CMAKE_CUDA_COMPILER_LAUNCHER)
    target_compile_options(weft_cuda PRIVATE -Xptxas=-v)
    set(launcher ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/cmake/keep_ptxas.py ${WEFT_CCACHE})
    set_target_properties(weft_cuda PROPERTIES CUDA_COMPILER_LAUNCHER "${launcher}")
  endif()
  set_target_properties(weft_cuda PROPERTIES
    CUDA_STANDARD 17 CUDA_STANDARD_REQUIRED ON CUDA_RUNTIME_LIBRARY Static
    CUDA_VISIBILITY_PRESET hidden POSITION_INDEPENDENT_CODE ON UNITY_BUILD OFF)
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:weft_cuda>)
  target_compile_definitions(${target} PRIVATE WEFT_HAVE_CUDA)
  set_target_properties(${target} PROPERTIES CUDA_RUNTIME_LIBRARY Static)
  find_package(CUDAToolkit REQUIRED)
  target_link_libraries(${target} PRIVATE CUDA::cudart_static)
endfunction()
