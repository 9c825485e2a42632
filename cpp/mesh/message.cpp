#include "mesh/message.h"

#include <sstream>

namespace foldwright {
namespace {

/// Writes a value; lists with commas.
struct Writer {
  std::ostream& out;

  void operator()(double number) const { out << number; }
  void operator()(const std::string& text) const { out << text; }
  template <class Item>
  void operator()(const std::vector<Item>& list) const {
    for (std::size_t i = 0; i < list.size(); ++i) out << (i == 0 ? "" : ",") << list[i];
  }
};

}  // namespace

Parameters at(const Place& place, Parameters more) {
  Parameters parameters = {{"place", place.unit}, {"at", place.number}};
  parameters.insert(parameters.end(), std::make_move_iterator(more.begin()),
                    std::make_move_iterator(more.end()));
  return parameters;
}

std::string describe(const Message& message) {
  std::ostringstream text;
  text.precision(15);  // whole numbers in full
  text << message.code;
  for (const auto& [name, value] : message.parameters) {
    text << ' ' << name << '=';
    std::visit(Writer{text}, value);
  }
  return text.str();
}

}  // namespace foldwright
