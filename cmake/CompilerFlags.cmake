# Flags of everything that is compiled here, third-party code included.

# Contracted multiply-adds would give other bits on machines that have them: results must not depend on the machine.
add_compile_options(-ffp-contract=off)

if(EMSCRIPTEN)
  # SIMD and native exceptions are part of the ABI: every object file must agree on them.
  add_compile_options(-msimd128 -fwasm-exceptions)
  add_link_options(-fwasm-exceptions)
endif()

option(FOLDWRIGHT_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)
option(FOLDWRIGHT_FUZZ "Build libFuzzer's programs, with the same sanitizers" OFF)
if(FOLDWRIGHT_FUZZ)
  set(FOLDWRIGHT_SANITIZE ON)
  add_compile_options(-fsanitize=fuzzer-no-link)  # tells libFuzzer which branches were taken
endif()
if(FOLDWRIGHT_SANITIZE)
  set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  if(FOLDWRIGHT_FUZZ)
    # What the address sanitizer finds as well, at a quarter of the time that compiling takes.
    list(APPEND sanitizers -fno-sanitize=null,alignment,vptr,object-size)
    list(APPEND sanitizers "-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/fuzz-ignorelist.txt")
  endif()
  add_compile_options(${sanitizers})
  add_link_options(${sanitizers})
endif()

# Warnings are for the project's own code alone.
add_library(project_warnings INTERFACE)
target_compile_options(project_warnings INTERFACE -Wall -Wextra -Wpedantic)
# GCC 12 takes moved-from variants for uninitialised and short strings for overlapping, wrongly (its bugs 105562, 105329).
target_compile_options(project_warnings INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-restrict>)
