# Every tests/bench/NAME.cpp is a program bench_NAME, natively and as WASM under node.

file(GLOB bench_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/bench/*.cpp")
foreach(source ${bench_sources})
  cmake_path(GET source STEM name)
  add_executable(bench_${name} "${source}")
  target_link_libraries(bench_${name} PRIVATE test_helpers project_warnings)
  if(EMSCRIPTEN)
    include(NodeProgram)
    make_node_program(bench_${name})
  endif()
endforeach()

# All of them: the tests build these as well, so that no change leaves one behind.
list(TRANSFORM bench_sources REPLACE ".*/([a-z_]+)\\.cpp$" "bench_\\1" OUTPUT_VARIABLE benches)
add_custom_target(benchmarks DEPENDS ${benches})
