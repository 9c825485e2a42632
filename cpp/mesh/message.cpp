#include "mesh/message.h"

#include <array>
#include <cstdio>
#include <string>

namespace foldwright {
namespace {

std::string written(double number) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.15g", number);  // whole numbers in full
  return text.data();
}
std::string written(int number) { return std::to_string(number); }
std::string written(const std::string& text) { return text; }
template <class Item>
std::string written(const std::vector<Item>& list) {
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i) text += (i == 0 ? "" : ",") + written(list[i]);
  return text;
}

}  // namespace

Parameters at(const Place& place, Parameters more) {
  Parameters parameters = {{"place", place.unit}, {"at", place.number}};
  parameters.insert(parameters.end(), std::make_move_iterator(more.begin()),
                    std::make_move_iterator(more.end()));
  return parameters;
}

std::string describe(const Message& message) {
  std::string text = message.code;
  for (const auto& [name, value] : message.parameters) {
    text += ' ' + name + '=';
    text += std::visit([](const auto& held) { return written(held); }, value);
  }
  return text;
}

}  // namespace foldwright
