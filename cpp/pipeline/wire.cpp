#include "pipeline/wire.h"

#include <cassert>
#include <cstring>
#include <type_traits>

namespace foldwright {
namespace {

/// Appends values. Structures come apart by `each_field`.
class Writer {
 public:
  Bytes take() { return std::move(bytes_); }

  template <class T>
  void operator()(const T& value);

  void raw(const void* data, std::size_t size) {
    const auto* begin = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), begin, begin + size);
  }

 private:
  Bytes bytes_;
};

/// Reads values back in the same order.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : left_(bytes) {}

  template <class T>
  void operator()(T& value);

  void raw(void* data, std::size_t size) {
    assert(size <= left_.size());
    if (size > 0) std::memcpy(data, left_.data(), size);
    left_ = left_.subspan(size);
  }

 private:
  std::span<const std::byte> left_;
};

template <class T, class... Kinds>
constexpr bool is_any_of = (std::is_same_v<std::remove_cvref_t<T>, Kinds> || ...);

/// Whether a value's bytes are all there is to it.
template <class T>
constexpr bool is_plain = std::is_arithmetic_v<T> || std::is_enum_v<T> ||
                          is_any_of<T, std::array<int, 3>, std::array<int, 2>>;

// One list of fields per structure serves both directions: `value` is const when writing. Longer
// than other functions: it is one list.
template <class T, class F>
void each_field(T& value, F& f) {
  if constexpr (is_any_of<T, LearnOptions>) {
    f(value.heuristic), f(value.directions), f(value.runs), f(value.seed);
  } else if constexpr (is_any_of<T, LearnTask>) {
    f(value.options), f(value.first_run), f(value.last_run);
  } else if constexpr (is_any_of<T, TreeSearchOptions>) {
    f(value.starts), f(value.temperature), f(value.patience), f(value.good_enough);
    f(value.clearance), f(value.seed);
  } else if constexpr (is_any_of<T, SearchTask>) {
    f(value.options), f(value.initial);
  } else if constexpr (is_any_of<T, GeneticTask>) {
    f(value.options);
  } else if constexpr (is_any_of<T, GeneticOptions>) {
    f(value.population), f(value.offspring), f(value.generations), f(value.tournament);
    f(value.crossover), f(value.mutation), f(value.step);
    f(value.overlap_cost), f(value.hyperbolic_cost), f(value.seed);
  } else if constexpr (is_any_of<T, ExchangeOptions>) {
    f(value.part), f(value.most_steps), f(value.most_moves), f(value.temperature);
    f(value.clearance), f(value.seed);
  } else if constexpr (is_any_of<T, PartsSoFar>) {
    f(value.labels), f(value.fold_edges), f(value.shortfalls);
  } else if constexpr (is_any_of<T, ExchangeTask>) {
    f(value.parts), f(value.options);
  } else if constexpr (is_any_of<T, FoldabilityCounts>) {
    f(value.size), f(value.runs), f(value.counts);
  } else if constexpr (is_any_of<T, SearchResult>) {
    f(value.folds), f(value.overlaps), f(value.shortfall), f(value.folds_straight);
    f(value.moves), f(value.generations);
  } else if constexpr (is_any_of<T, PlanTask>) {
    f(value.folds), f(value.clearance), f(value.seed);
  } else if constexpr (is_any_of<T, CompactTask>) {
    f(value.folds), f(value.craft), f(value.annealing);
  } else if constexpr (is_any_of<T, CraftOptions>) {
    f(value.scale), f(value.shape), f(value.weights), f(value.room), f(value.borders);
  } else if constexpr (is_any_of<T, FlapShape>) {
    f(value.height), f(value.least), f(value.angles[0]), f(value.angles[1]);
  } else if constexpr (is_any_of<T, CraftWeights>) {
    f(value.flaps), f(value.hull), f(value.necks), f(value.excess), f(value.glue);
  } else if constexpr (is_any_of<T, Extent>) {
    f(value.width), f(value.height);
  } else if constexpr (is_any_of<T, BorderRoom>) {
    f(value.mesh_edge), f(value.height);
  } else if constexpr (is_any_of<T, AnnealingOptions>) {
    f(value.work), f(value.hot), f(value.cold), f(value.clearance), f(value.seed);
  } else if constexpr (is_any_of<T, CompactResult>) {
    f(value.folds), f(value.borders), f(value.moves);
  } else if constexpr (is_any_of<T, FoldMotion>) {
    f(value.kind), f(value.times), f(value.shares);
  } else if constexpr (is_any_of<T, PlanResult>) {
    f(value.motion);
  } else if constexpr (is_any_of<T, ExchangeResult>) {
    f(value.found), f(value.labels), f(value.changed), f(value.shortfalls), f(value.moves);
  } else if constexpr (is_any_of<T, SearchStatus>) {
    f(value.best), f(value.overlaps), f(value.hyperbolic);
  } else if constexpr (is_any_of<T, EdgeLock>) {
    f(value.vertices), f(value.is_fold);
  } else if constexpr (is_any_of<T, NetPicture>) {
    f(value.corners), f(value.sources), f(value.overlapping);
  } else {
    static_assert(is_any_of<T, TaskStatus>, "a structure without a list of fields");
    f(value.progress), f(value.runs), f(value.generations), f(value.net);
  }
}

void write(Writer& writer, const Vec3& value) { writer.raw(value.data(), sizeof(double) * 3); }
void read(Reader& reader, Vec3& value) { reader.raw(value.data(), sizeof(double) * 3); }

template <class T>
void write(Writer& writer, const std::vector<T>& values) {
  writer(values.size());
  if constexpr (is_plain<T>) {
    writer.raw(values.data(), values.size() * sizeof(T));
  } else {
    for (const T& value : values) writer(value);
  }
}
template <class T>
void read(Reader& reader, std::vector<T>& values) {
  std::size_t size = 0;
  reader(size);
  values.resize(size);
  if constexpr (is_plain<T>) {
    reader.raw(values.data(), values.size() * sizeof(T));
  } else {
    for (T& value : values) reader(value);
  }
}

template <class T>
void write(Writer& writer, const std::map<int, T>& values) {
  writer(values.size());
  for (const auto& [key, value] : values) writer(key), writer(value);
}
template <class T>
void read(Reader& reader, std::map<int, T>& values) {
  std::size_t size = 0;
  for (reader(size); size > 0; --size) {
    int key = 0;
    reader(key);
    reader(values[key]);
  }
}

template <class T>
void write(Writer& writer, const std::optional<T>& value) {
  writer(value.has_value());
  if (value) writer(*value);
}
template <class T>
void read(Reader& reader, std::optional<T>& value) {
  bool present = false;
  reader(present);
  if (present) reader(value.emplace());
}

template <class... Ts>
void write(Writer& writer, const std::variant<Ts...>& value) {
  writer(value.index());
  std::visit(writer, value);
}
template <class... Ts>
void read(Reader& reader, std::variant<Ts...>& value) {
  std::size_t index = 0;
  reader(index);
  std::size_t i = 0;
  ((i++ == index ? reader(value.template emplace<Ts>()) : void()), ...);
}

template <class T>
void Writer::operator()(const T& value) {
  if constexpr (is_plain<T>) {
    raw(&value, sizeof(T));
  } else if constexpr (requires { write(*this, value); }) {
    write(*this, value);
  } else {
    each_field(value, *this);
  }
}

template <class T>
void Reader::operator()(T& value) {
  if constexpr (is_plain<T>) {
    raw(&value, sizeof(T));
  } else if constexpr (requires { read(*this, value); }) {
    read(*this, value);
  } else {
    each_field(value, *this);
  }
}

template <class T>
Bytes encoded(const T& value) {
  Writer writer;
  writer(value);
  return writer.take();
}

template <class T>
T decoded(std::span<const std::byte> bytes) {
  T value{};
  Reader reader(bytes);
  reader(value);
  return value;
}

}  // namespace

Bytes encode(const Surface& surface) {
  Writer writer;
  writer(surface.key);
  writer(surface.mesh.positions);
  writer(surface.mesh.faces);
  writer(surface.mesh.source_faces);
  writer(surface.locks);
  return writer.take();
}

std::shared_ptr<const Surface> decode_surface(std::span<const std::byte> bytes) {
  Reader reader(bytes);
  int key = 0;
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  std::vector<int> source_faces;
  reader(key);
  reader(positions);
  reader(faces);
  reader(source_faces);
  std::vector<EdgeLock> locks;
  reader(locks);
  Mesh mesh = make_mesh(std::move(positions), std::move(faces), std::move(source_faces));
  return make_surface(key, std::move(mesh), std::move(locks));
}

Bytes encode(const Task& task) {
  Writer writer;
  writer(task.id);
  writer(task.panels);
  writer(task.work);
  return writer.take();
}

Task decode_task(std::span<const std::byte> bytes, std::shared_ptr<const Surface> surface) {
  Task task{0, std::move(surface), {}, {}};
  Reader reader(bytes);
  reader(task.id);
  reader(task.panels);
  reader(task.work);
  return task;
}

Bytes encode(const TaskStatus& status) { return encoded(status); }
TaskStatus decode_status(std::span<const std::byte> bytes) { return decoded<TaskStatus>(bytes); }
Bytes encode(const TaskResult& result) { return encoded(result); }
TaskResult decode_result(std::span<const std::byte> bytes) { return decoded<TaskResult>(bytes); }

}  // namespace foldwright
