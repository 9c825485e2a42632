# The WASM module for browsers and node, with its generated TypeScript declarations.

file(GLOB binding_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/bindings/*.cpp")
if(NOT EMSCRIPTEN OR NOT binding_sources)
  return()
endif()

set(generated "${PROJECT_SOURCE_DIR}/web/core/generated")
file(MAKE_DIRECTORY "${generated}")

add_executable(foldwright_wasm ${binding_sources})
set_target_properties(foldwright_wasm PROPERTIES
  OUTPUT_NAME foldwright SUFFIX .mjs RUNTIME_OUTPUT_DIRECTORY "${generated}")
target_link_libraries(foldwright_wasm PRIVATE foldwright project_warnings)
target_compile_options(foldwright_wasm PRIVATE -Oz)  # values in and out, once per event
target_link_options(foldwright_wasm PRIVATE
  -Os                               # what is linked is inlined no further: see SmallSources.cmake
  -lembind
  --emit-tsd foldwright.d.mts       # written beside the module; needs TypeScript 5 on the PATH
  -sMODULARIZE -sEXPORT_ES6
  -sENVIRONMENT=web,worker,node     # no shell: the same file serves the studio and the command line
  -sALLOW_MEMORY_GROWTH             # models differ by three orders of magnitude
  -sSTACK_SIZE=1MB                  # the default of 64 KB is too small for Eigen's temporaries
  -sFILESYSTEM=0                    # models come in as bytes
  -sDYNAMIC_EXECUTION=0)            # no eval: the studio runs under a strict content security policy
