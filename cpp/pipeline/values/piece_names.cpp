#include "pipeline/values/piece_names.h"

#include <algorithm>
#include <map>
#include <set>

#include "paper/labels.h"

namespace foldwright {
namespace {

// Longer ones would cover a piece.
constexpr int kLongest = 16;

}  // namespace

std::vector<std::string> piece_names(std::span<const int> parts, std::span<const PartName> chosen) {
  std::map<int, std::string> name_of;
  for (const auto& [part, name] : chosen) name_of[part] = name;
  std::map<int, int> seen;
  std::set<std::string> taken;
  std::vector<std::string> names(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto name = name_of.find(parts[i]);
    if (name == name_of.end()) continue;
    names[i] = name->second;
    if (std::ranges::count(parts, parts[i]) > 1) {
      // "Wing 1" may be another part's own name.
      do {
        names[i] = name->second + " " + std::to_string(++seen[parts[i]]);
      } while (taken.contains(names[i]) ||
               std::ranges::any_of(chosen, [&](const PartName& c) { return c.name == names[i]; }));
    }
    taken.insert(names[i]);
  }
  int next = static_cast<int>(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!names[i].empty()) continue;
    names[i] = piece_letter(static_cast<int>(i));
    while (taken.contains(names[i])) names[i] = piece_letter(next++);
    taken.insert(names[i]);
  }
  return names;
}

std::string fault_of_name(const std::string& name) {
  int characters = 0;
  bool only_digits = true;
  for (const char byte : name) {
    const auto code = static_cast<unsigned char>(byte);
    if (code < 0x20 || code == 0x7f) return "name-control";
    if (byte == ':') return "name-colon";
    if (code < 0x80 || code >= 0xc0) ++characters;
    only_digits = only_digits && byte >= '0' && byte <= '9';
  }
  if (characters == 0 || characters > kLongest || name.front() == ' ' || name.back() == ' ') {
    return "name-length";
  }
  if (only_digits) return "name-number";
  return "";
}

}  // namespace foldwright
