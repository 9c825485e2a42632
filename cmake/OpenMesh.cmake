# OpenMesh's kernel and decimater as a static library. The shared library of the distributions decimates four times
# slower than this build, and WASM needs the source in any case.

set(FOLDWRIGHT_OPENMESH_SOURCE "${PROJECT_SOURCE_DIR}/.toolchain/src/openmesh" CACHE PATH
    "Source tree of OpenMesh 9.0 (scripts/setup.mjs puts it there on Debian)")
set(FOLDWRIGHT_OPENMESH_ARCHIVE "" CACHE STRING
    "Address of the source archive of OpenMesh 9.0, fetched when the source tree is not there")

if(NOT EXISTS "${FOLDWRIGHT_OPENMESH_SOURCE}/src/OpenMesh")
  if(NOT FOLDWRIGHT_OPENMESH_ARCHIVE)
    message(FATAL_ERROR "OpenMesh 9.0 is missing: run `node scripts/setup.mjs` (Debian), or configure with "
                        "-DFOLDWRIGHT_OPENMESH_SOURCE=<folder> or -DFOLDWRIGHT_OPENMESH_ARCHIVE=<address>")
  endif()
  include(FetchContent)
  # SOURCE_SUBDIR without a CMakeLists.txt: only the files are wanted, not OpenMesh's own build.
  FetchContent_Declare(openmesh_source URL "${FOLDWRIGHT_OPENMESH_ARCHIVE}" SOURCE_SUBDIR none)
  FetchContent_MakeAvailable(openmesh_source)
  set(FOLDWRIGHT_OPENMESH_SOURCE "${openmesh_source_SOURCE_DIR}")
endif()

set(openmesh_root "${FOLDWRIGHT_OPENMESH_SOURCE}/src")
file(GLOB_RECURSE openmesh_sources "${openmesh_root}/OpenMesh/Core/*.cc")
list(FILTER openmesh_sources EXCLUDE REGEX "/Core/IO/")  # readers and writers: not used, and most of the build time
# What stores properties or prints is replaced, so that the WASM module needs no streams.
set(openmesh_without_streams "${PROJECT_SOURCE_DIR}/cmake/openmesh")
list(FILTER openmesh_sources EXCLUDE REGEX "/(BaseProperty|PropertyCreator|omstream)\\.cc$")
list(APPEND openmesh_sources "${openmesh_without_streams}/base_property.cpp")
list(APPEND openmesh_sources "${openmesh_root}/OpenMesh/Tools/Decimater/Observer.cc")

add_library(openmesh STATIC ${openmesh_sources})
target_compile_definitions(openmesh PUBLIC OM_STATIC_BUILD)
target_include_directories(openmesh SYSTEM PUBLIC "${openmesh_without_streams}" "${openmesh_root}")
# Optimised in the test build as well: only the project's own code is under test. Its warnings are not ours to mend.
target_compile_options(openmesh PRIVATE $<IF:$<BOOL:${EMSCRIPTEN}>,-Os,-O3> -w)  # WASM is fetched: see SmallSources.cmake
if(FOLDWRIGHT_SANITIZE)
  target_compile_options(openmesh PRIVATE -fno-sanitize=all)  # instrumented, one of its files alone compiles for minutes
endif()
