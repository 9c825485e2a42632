#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "mesh/message_codes.h"

namespace foldwright {

/// A word of `kMessageCodes`; any other does not compile.
class Code {
 public:
  consteval Code(const char* word) : word_(word) {
    if (!is_message_code(word)) throw "not in kMessageCodes";
  }
  const char* word() const { return word_; }

 private:
  const char* word_;
};

/// A value that a sentence needs, by its name. Lengths are in mm if the name ends in `_mm`; parts,
/// pieces, sheets and faces of files count from 1 as people count them.
struct Parameter {
  std::string name;
  std::variant<double, std::string, std::vector<int>, std::vector<std::string>> value;

  template <class Number>
  requires std::is_arithmetic_v<Number> Parameter(std::string of, Number number)
      : name(std::move(of)), value(static_cast<double>(number)) {}
  Parameter(std::string of, std::string_view text)
      : name(std::move(of)), value(std::string(text)) {}
  Parameter(std::string of, const std::string& text) : name(std::move(of)), value(text) {}
  Parameter(std::string of, const char* text) : name(std::move(of)), value(std::string(text)) {}
  Parameter(std::string of, std::vector<int> numbers)
      : name(std::move(of)), value(std::move(numbers)) {}
  Parameter(std::string of, std::vector<std::string> texts)
      : name(std::move(of)), value(std::move(texts)) {}

  bool operator==(const Parameter&) const = default;
};
using Parameters = std::vector<Parameter>;

/// Where something stands in a file: "line" 23 or "triangle" 7.
struct Place {
  const char* unit;
  long long number;
};

/// The parameters of a message about a place, and further ones.
Parameters at(const Place& place, Parameters more = {});

/// Something that people are told. Its sentence is made elsewhere, in their language, from the code
/// and the parameters; where a code has several sentences, the parameter `what` says which.
struct Message {
  std::string code;
  Parameters parameters;

  Message() = default;
  Message(Code word, Parameters values = {}) : code(word.word()), parameters(std::move(values)) {}
};

/// The message for developers: "bad-number place=line at=3 what=comma word=1,5".
std::string describe(const Message& message);

}  // namespace foldwright
