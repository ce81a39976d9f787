# weft_warnings(TARGET): the warnings every target of this project is free of.
# weft_sanitize(TARGET [KERNELS]): the sanitizers that WEFT_SANITIZE names, at compile and link time.
function(weft_warnings target)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wconversion>
    $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${WEFT_WARNINGS_AS_ERRORS}>>:-Werror>)
  if(CMAKE_UNITY_BUILD)  # g++ takes a file of many for a header, whose names should not be local
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

function(weft_sanitize target)
  if(WEFT_SANITIZE)
    target_compile_options(${target} PRIVATE
      $<$<COMPILE_LANGUAGE:CXX>:-fsanitize=${WEFT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all>)
    if(ARGN STREQUAL "KERNELS" AND WEFT_SANITIZE MATCHES "undefined")
      # Half of the compiler's time; the address sanitizer sees where a wild pointer is used.
      target_compile_options(${target} PRIVATE -fno-sanitize=pointer-overflow)
    endif()
    target_link_options(${target} PUBLIC -fsanitize=${WEFT_SANITIZE})
  endif()
endfunction()
