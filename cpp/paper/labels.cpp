#include "paper/labels.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "paper/joint_line.h"
#include "paper/label_space.h"
#include "paper/tape_marks.h"

namespace foldwright {
namespace {

// Around a net, mm: as far as ids beside it may be away, and their length.
constexpr double kAround = 30;

// Of the names of pieces where these stand, mm: as ids, which they are read with.
constexpr double kStandingSizes[] = {3, 2.5, 2};
constexpr double kStandingClearance = 0.25;

}  // namespace

class LabelPlacer::Work {
 public:
  explicit Work(const LabelTask& task) : task_(task), seams_(find_seams(task.nets)) {
    ids_ = name_seams(task.nets, task.names, seams_, task.joints);
    add_joints();
    for (std::size_t n = 0; n < task.standings.size(); ++n) {
      std::ranges::copy(task.standings[n].lines, std::back_inserter(plan_.joint_lines[n]));
    }
    written_.resize(seams_.size());
    sides_.resize(task.nets.size());
    for (int i = 0; i < static_cast<int>(seams_.size()); ++i) {
      for (const int s : {0, 1}) sides_[seams_[i].sides[s].net].push_back({i, s});
    }
    for (std::vector<SeamStep>& sides : sides_) {
      // Long edges have more places to choose from.
      std::ranges::stable_sort(sides, {}, [&](const SeamStep& step) { return at(step).length(); });
    }
  }

  bool step() {
    if (texts_.size() < task_.nets.size()) {
      write_next();
      return false;
    }
    finish();
    return true;
  }

  LabelPlan take() { return std::move(plan_); }

 private:
  const SeamSide& at(const SeamStep& step) const { return seams_[step.seam].sides[step.side]; }

  void add_joints() {
    plan_.joint_lines.resize(task_.nets.size());
    for (const Seam& joint : task_.joints) {
      seams_.push_back(joint);
      const SeamSide& host = joint.sides[1];
      if (const auto line = joint_line(task_.nets[host.net], host)) {
        plan_.joint_lines[host.net].push_back(*line);
      }
    }
  }

  PieceTextTask task_of(std::size_t n) const {
    PieceTextTask task{&task_.nets[n], task_.flaps[n],       task_.names[n],
                       task_.place,    plan_.joint_lines[n], {}};
    for (const SeamStep& step : sides_[n]) {
      task.ids.push_back({&at(step), ids_[step.seam].texts[step.side]});
    }
    if (task_.place == IdPlace::kOutside) {
      task.around = task_.sheets->around(static_cast<int>(n), kAround);
    }
    return task;
  }

  /// Takes a net's texts from the memory, or does a step of writing them.
  void write_next() {
    if (!writer_) {
      PieceTextTask task = task_of(texts_.size());
      if (task_.memory) {
        key_ = bytes_of(task);
        if (const PieceTexts* known = task_.memory->find(key_)) return add(*known);
      }
      writer_.emplace(std::move(task));
    }
    if (!writer_->step()) return;
    PieceTexts texts = writer_->take();
    writer_.reset();
    if (task_.memory) task_.memory->keep(std::move(key_), texts);
    add(std::move(texts));
  }

  void add(PieceTexts texts) {
    const std::vector<SeamStep>& sides = sides_[texts_.size()];
    for (const TextBox& text : texts.outside) {
      task_.sheets->take(static_cast<int>(texts_.size()), text);
    }
    for (std::size_t i = 0; i < sides.size(); ++i) {
      written_[sides[i].seam][sides[i].side] = texts.is_written[i];
    }
    texts_.push_back(std::move(texts));
  }

  /// What is drawn on a net by now.
  LabelSpace space_of(int net) const {
    LabelSpace space(task_.nets[net], task_.flaps[net]);
    for (const Stroke& line : plan_.joint_lines[net]) space.take(line);
    for (const TextBox& box : texts_[net].boxes) space.take(box);
    for (const Label& label : texts_[net].labels) {
      if (label.leader) space.take(*label.leader);
    }
    return space;
  }

  void mark_for_tape() {
    plan_.tape_marks.resize(task_.nets.size());
    std::map<int, LabelSpace> spaces;
    const auto space = [&](int net) {
      const auto found = spaces.find(net);
      return &(found != spaces.end() ? found : spaces.emplace(net, space_of(net)).first)->second;
    };
    for (const Seam& seam : seams_) {
      if (!std::ranges::binary_search(task_.tape, seam.mesh_edge())) continue;
      const auto marks = tape_marks(seam, {space(seam.sides[0].net), space(seam.sides[1].net)});
      for (const int s : {0, 1}) {
        auto& all = plan_.tape_marks[seam.sides[s].net];
        all.insert(all.end(), marks[s].begin(), marks[s].end());
      }
    }
  }

  /// Writes in the rim of what stands on a net what it is called.
  void name_standings() {
    for (std::size_t n = 0; n < task_.standings.size(); ++n) {
      if (task_.standings[n].names.empty()) continue;
      LabelSpace space = space_of(static_cast<int>(n));
      for (const auto& [guest, centre] : task_.standings[n].names) {
        const auto net = std::ranges::find_if(task_.nets, [&](const Net& net) {
          return std::ranges::binary_search(net.faces, guest);
        });
        if (net == task_.nets.end()) continue;
        const std::string& name = task_.names[net - task_.nets.begin()];
        for (const double size : kStandingSizes) {
          const TextBox box = box_around(name, {size, kStandingClearance}, centre, Vec2(1, 0));
          if (!space.is_free(box)) continue;
          space.take(box);
          texts_[n].boxes.push_back(box);
          texts_[n].labels.push_back({name, centre, 0, size});
          break;
        }
      }
    }
  }

  void finish() {
    name_standings();
    mark_for_tape();
    for (std::size_t i = 0; i < seams_.size(); ++i) {
      const Seam& seam = seams_[i];
      plan_.seams.push_back({seam.mesh_edges, {seam.sides[0].net, seam.sides[1].net}, ids_[i]});
      if (task_.place == IdPlace::kNone) continue;
      const bool is_complete = written_[i][0] && written_[i][1];
      if (is_complete) ++plan_.printed;
      if (!is_complete) plan_.skipped.push_back(ids_[i].name);
    }
    for (PieceTexts& texts : texts_) plan_.labels.push_back(std::move(texts.labels));
  }

  LabelTask task_;
  std::vector<Seam> seams_;
  std::vector<SeamId> ids_;                   ///< per seam
  std::vector<std::vector<SeamStep>> sides_;  ///< per net, short ones first
  std::vector<std::array<char, 2>> written_;  ///< per seam and side
  std::vector<PieceTexts> texts_;             ///< of the nets so far
  std::optional<PieceWriter> writer_;         ///< of the next net
  std::string key_;                           ///< of its texts in the memory
  LabelPlan plan_;
};

LabelPlacer::LabelPlacer(const LabelTask& task) : work_(std::make_unique<Work>(task)) {}
LabelPlacer::~LabelPlacer() = default;
bool LabelPlacer::step() { return work_->step(); }
LabelPlan LabelPlacer::take() { return work_->take(); }

LabelPlan place_labels(const LabelTask& task) {
  LabelPlacer placer(task);
  while (!placer.step()) {
  }
  return placer.take();
}

std::string piece_letter(int index) {
  const std::string last(1, static_cast<char>('A' + index % 26));
  return index < 26 ? last : piece_letter(index / 26 - 1) + last;
}

}  // namespace foldwright
