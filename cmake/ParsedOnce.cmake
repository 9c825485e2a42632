# Headers of others that nearly every file includes, and that take longer to parse than the file: once for each target.

# A cache for compilers finds more without: to it a precompiled header differs from folder to folder.
function(parse_once target)
  if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
