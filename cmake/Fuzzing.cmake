# libFuzzer's programs from tests/fuzz, in the preset `fuzz` only: they need clang and its runtime library.

if(NOT FOLDWRIGHT_FUZZ)
  return()
endif()

add_custom_target(fuzzers)

# What the tests start from: own models, and a file for every failure that was mended. As files and not as folders, since
# libFuzzer puts new inputs into the first folder that it is given.
file(GLOB fuzz_seeds CONFIGURE_DEPENDS
  "${PROJECT_SOURCE_DIR}/tests/data/corpus/*" "${PROJECT_SOURCE_DIR}/tests/repro/*")
list(JOIN fuzz_seeds "," fuzz_seeds)
set(fuzz_options -dict=${PROJECT_SOURCE_DIR}/tests/fuzz/words.dict -seed=1 -seed_inputs=${fuzz_seeds})

# A program `fuzz_NAME`, and a short run of it as a test. Bounded by `runs`, not by time: it does the same everywhere.
function(add_fuzzer name source runs)
  add_executable(fuzz_${name} "${PROJECT_SOURCE_DIR}/tests/fuzz/${source}.cpp")
  target_link_libraries(fuzz_${name} PRIVATE foldwright project_warnings)
  add_dependencies(fuzzers fuzz_${name})
  target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
  add_test(NAME fuzz_${name} COMMAND fuzz_${name} ${fuzz_options} -runs=${runs})
  set_tests_properties(fuzz_${name} PROPERTIES TIMEOUT 300)
endfunction()

foreach(format obj stl off ply)
  add_fuzzer(read_${format} read_model 20000)
  target_compile_definitions(fuzz_read_${format} PRIVATE FUZZED_FILE_NAME="model.${format}")
endforeach()
add_fuzzer(read_to_nets read_to_nets 100)
# One file of the tests' helpers alone: with sanitizers all of them would compile for half a minute.
target_sources(fuzz_read_to_nets PRIVATE "${PROJECT_SOURCE_DIR}/tests/cpp/result_faults.cpp")
target_include_directories(fuzz_read_to_nets PRIVATE "${PROJECT_SOURCE_DIR}/tests/cpp")
