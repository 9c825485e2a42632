#include "start.h"

#include <cmath>
#include <numbers>

#include "names.h"

namespace foldwright {
namespace {

using emscripten::val;

template <class T>
std::vector<T> numbers(const val& array) {
  return emscripten::convertJSArrayToNumberVector<T>(array);
}

bool is_missing(const val& value) { return value.isNull() || value.isUndefined(); }

SavedNet net_from(const val& object) {
  SavedNet net;
  net.part = object["part"].as<int>();
  net.cause = from_name<Cause>(kCauses, object["cause"].as<std::string>());
  net.faces = numbers<int>(object["faces"]);
  net.folds = numbers<int>(object["folds"]);
  net.motion.kind = from_name<Folding>(kFoldings, object["foldable"].as<std::string>());
  net.motion.times = numbers<double>(object["times"]);
  for (const val& shares : object["shares"]) net.motion.shares.push_back(numbers<double>(shares));
  if (const val place = object["place"]; !is_missing(place)) {
    const double angle = place["angle"].as<double>() * std::numbers::pi / 180;
    const Vec2 shift(place["x"].as<double>(), place["y"].as<double>());
    net.place = {place["sheet"].as<int>(), {std::cos(angle), std::sin(angle), shift}};
  }
  return net;
}

constexpr Name<LockKind> kLockKinds[] = {
    {"fold", LockKind::kFold}, {"cut", LockKind::kCut}, {"free", LockKind::kFree}};

EdgeName edge_from(const val& edge) { return {edge[0].as<int>(), edge[1].as<int>()}; }

NetEdit net_edit_from(const val& edit) {
  const std::string kind = edit["kind"].as<std::string>();
  if (kind == "cut") return CutEdit{edge_from(edit["edge"])};
  if (kind == "lock") {
    return LockEdit{edge_from(edit["edge"]),
                    from_name<LockKind>(kLockKinds, edit["as"].as<std::string>())};
  }
  if (kind == "assign") return AssignEdit{numbers<int>(edit["faces"]), edit["part"].as<int>()};
  if (kind != "join") throw std::invalid_argument("unknown edit: " + kind);
  JoinEdit join{edge_from(edit["edge"])};
  if (!is_missing(edit["open"])) join.open = edge_from(edit["open"]);
  join.search = edit["search"].isTrue();
  return join;
}

}  // namespace

JobStart start_from(const val& object) {
  JobStart start;
  start.labels = numbers<int>(object["labels"]);
  for (const val& net : object["nets"]) start.nets.push_back(net_from(net));
  for (const val& edit : object["netEdits"]) start.net_edits.push_back(net_edit_from(edit));
  for (const val& edit : object["partEdits"]) {
    start.part_edits.push_back({numbers<int>(edit["parts"]), edit["into"].as<int>()});
  }
  if (const val paper = object["paper"]; !is_missing(paper)) {
    start.paper = {paper["scale"].as<double>(), paper["sheets"].as<int>(),
                   paper["sheetWidth"].as<double>()};
  }
  return start;
}

}  // namespace foldwright
