#include "start.h"

#include "names.h"

namespace foldwright {
namespace {

using emscripten::val;

template <class T>
std::vector<T> numbers(const val& array) {
  return emscripten::convertJSArrayToNumberVector<T>(array);
}

SavedNet net_from(const val& object) {
  SavedNet net;
  net.part = object["part"].as<int>();
  net.cause = from_name<Cause>(kCauses, object["cause"].as<std::string>());
  net.faces = numbers<int>(object["faces"]);
  net.folds = numbers<int>(object["folds"]);
  net.motion.kind = from_name<Folding>(kFoldings, object["foldable"].as<std::string>());
  net.motion.times = numbers<double>(object["times"]);
  for (const val& shares : object["shares"]) net.motion.shares.push_back(numbers<double>(shares));
  return net;
}

}  // namespace

JobStart start_from(const val& object) {
  JobStart start;
  start.labels = numbers<int>(object["labels"]);
  for (const val& net : object["nets"]) start.nets.push_back(net_from(net));
  for (const val& edit : object["edits"]) {
    start.edits.push_back({numbers<int>(edit["parts"]), edit["into"].as<int>()});
  }
  return start;
}

}  // namespace foldwright
