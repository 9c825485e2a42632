#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mesh/message.h"

namespace foldwright {

/// The one exception for bad input: a model that cannot be read or used, or an unusable option.
///
/// `code` is a stable kebab-case word for programs ("bad-index"), `parameters` are what a sentence
/// about it needs: what is wrong and where. `what()` has both, for developers. `faces()` are those
/// of the repaired mesh that it is about, ascending, where that helps.
class InputError : public std::runtime_error {
 public:
  InputError(Code code, Parameters parameters = {}, std::vector<int> faces = {})
      : InputError(Message(code, std::move(parameters)), std::move(faces)) {}
  InputError(Code code, const Place& place, Parameters more = {})
      : InputError(code, at(place, std::move(more))) {}

  const Message& message() const { return message_; }
  const std::string& code() const { return message_.code; }
  const Parameters& parameters() const { return message_.parameters; }
  const std::vector<int>& faces() const { return faces_; }

 private:
  InputError(Message message, std::vector<int> faces)
      : std::runtime_error(describe(message)),
        message_(std::move(message)),
        faces_(std::move(faces)) {}

  Message message_;
  std::vector<int> faces_;
};

}  // namespace foldwright
