# Makes a WASM executable run under node like a native program: the machine's files and environment are its own.
function(make_node_program target)
  target_link_options(${target} PRIVATE
    -sENVIRONMENT=node -sNODERAWFS -sEXIT_RUNTIME
    -sALLOW_MEMORY_GROWTH -sSTACK_SIZE=1MB  # as in the shipped module
    --pre-js "${PROJECT_SOURCE_DIR}/cmake/node-environment.js")
  set_target_properties(${target} PROPERTIES SUFFIX .cjs)  # the package's own type is ES modules
endfunction()
