#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace foldwright {

/// The one exception for bad input: a model that cannot be read or used, or an unusable option.
///
/// `code` is a stable kebab-case word for programs ("bad-index"); `what()` is one clear sentence
/// for people that names what is wrong and where, without the file's name and without a newline.
/// `faces()` are those of the repaired mesh that it is about, ascending, where that helps.
class InputError : public std::runtime_error {
 public:
  InputError(std::string code, const std::string& sentence, std::vector<int> faces = {})
      : std::runtime_error(sentence), code_(std::move(code)), faces_(std::move(faces)) {}

  const std::string& code() const { return code_; }
  const std::vector<int>& faces() const { return faces_; }

 private:
  std::string code_;
  std::vector<int> faces_;
};

}  // namespace foldwright
