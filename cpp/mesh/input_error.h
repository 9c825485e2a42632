#pragma once

#include <stdexcept>
#include <string>

namespace foldwright {

/// The one exception for bad input: a model that cannot be read or used, or an unusable option.
///
/// `code` is a stable kebab-case word for programs ("bad-index"); `what()` is one clear sentence
/// for people that names what is wrong and where, without the file's name and without a newline.
class InputError : public std::runtime_error {
 public:
  InputError(std::string code, const std::string& sentence)
      : std::runtime_error(sentence), code_(std::move(code)) {}

  const std::string& code() const { return code_; }

 private:
  std::string code_;
};

}  // namespace foldwright
