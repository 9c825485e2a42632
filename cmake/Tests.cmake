# One GoogleTest executable from tests/cpp, the same sources natively and as WASM under node.

file(GLOB test_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/cpp/*.cpp")
if(NOT test_sources)
  return()
endif()
enable_testing()

# Models too large or too foreign to commit lie beside the repository; tests that need them skip visibly without.
if(DEFINED ENV{FOLDWRIGHT_SHARED})
  set(shared_default "$ENV{FOLDWRIGHT_SHARED}")
else()
  cmake_path(SET shared_default NORMALIZE "${PROJECT_SOURCE_DIR}/../shared")
endif()
set(FOLDWRIGHT_SHARED "${shared_default}" CACHE PATH "Folder of shared test models")

if(EMSCRIPTEN)
  # There is no WASM build of GoogleTest to find: compile the distribution's copy of its source.
  set(FOLDWRIGHT_GOOGLETEST_SOURCE /usr/src/googletest CACHE PATH "Source tree of GoogleTest")
  set(INSTALL_GTEST OFF)
  set(BUILD_GMOCK OFF)
  set(gtest_disable_pthreads ON)
  add_subdirectory("${FOLDWRIGHT_GOOGLETEST_SOURCE}" googletest EXCLUDE_FROM_ALL SYSTEM)
  target_compile_options(gtest PRIVATE -w)
  target_compile_options(gtest_main PRIVATE -w)
  set(gtest_libraries gtest gtest_main)
else()
  find_package(GTest REQUIRED)
  set(gtest_libraries GTest::gtest GTest::gtest_main)
endif()

# Meshes and models that tests and benchmarks share: all that is not a test itself.
set(helper_sources ${test_sources})
list(FILTER helper_sources EXCLUDE REGEX "_test\\.cpp$")
list(FILTER test_sources INCLUDE REGEX "_test\\.cpp$")
add_library(test_helpers STATIC EXCLUDE_FROM_ALL ${helper_sources})
target_include_directories(test_helpers PUBLIC "${PROJECT_SOURCE_DIR}/tests/cpp")
target_link_libraries(test_helpers PUBLIC foldwright PRIVATE project_warnings)
parse_once(test_helpers <Eigen/Core> <Eigen/Geometry>)
target_compile_definitions(test_helpers PRIVATE
  FOLDWRIGHT_SHARED="${FOLDWRIGHT_SHARED}" FOLDWRIGHT_TESTS="${PROJECT_SOURCE_DIR}/tests")

function(add_tests target)
  add_executable(${target} ${ARGN})
  target_link_libraries(${target} PRIVATE test_helpers project_warnings ${gtest_libraries})
  parse_once(${target} <gtest/gtest.h> <Eigen/Core> <Eigen/Geometry>)
endfunction()

add_tests(foldwright_tests ${test_sources})

if(EMSCRIPTEN)
  include(NodeProgram)
  # Some whole jobs, and what another machine could come to other results in: numbers, sizes of integers, exceptions. The
  # other tests find out here what they find out natively, and compile for minutes.
  set(core_tests ${test_sources})
  string(JOIN "|" core job "job_(cancel|compaction|folding)" corpus repro task wire result source_model "read_[a-z]+"
         repair unite_bodies fewer_faces simplify random spectral tree_search genetic_search certificate foldable planner)
  list(FILTER core_tests INCLUDE REGEX "/(${core})_test\\.cpp$")
  add_tests(foldwright_core_tests ${core_tests})
  foreach(program foldwright_tests foldwright_core_tests)
    make_node_program(${program})
    # One ctest entry each: starting node once per test would take longer than the tests.
    add_test(NAME ${program} COMMAND ${program} --gtest_brief=1)
    set_tests_properties(${program} PROPERTIES TIMEOUT 600)
  endforeach()
else()
  include(GoogleTest)
  gtest_discover_tests(foldwright_tests DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300)
endif()
