#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

/// What the fuzzed programs ask of the engine: a promise that is broken ends the process, and
/// libFuzzer keeps the input.
namespace foldwright::fuzz {

inline void expect(bool holds, std::string_view promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %.*s\n", static_cast<int>(promise.size()), promise.data());
  std::abort();
}

/// A refusal names a code for programs and one line for developers.
inline void expect_refusal(std::string_view code, std::string_view sentence) {
  expect(!code.empty() && code.find(' ') == std::string_view::npos, "a code is a word");
  expect(!sentence.empty(), "a refusal has a description");
  expect(sentence.find('\n') == std::string_view::npos, "a description is one line");
}

}  // namespace foldwright::fuzz
