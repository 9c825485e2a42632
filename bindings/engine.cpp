// The engine's whole surface towards JavaScript: a job, a runner of its tasks, values in and out.

#include <emscripten/bind.h>

#include <exception>
#include <optional>

#include "bytes.h"
#include "options.h"
#include "pipeline/job.h"
#include "pipeline/wire.h"
#include "start.h"
#include "uniter.h"
#include "values.h"

namespace {

using emscripten::val;
using foldwright::bytes_from;
using foldwright::to_array;

EMSCRIPTEN_DECLARE_VAL_TYPE(BytesValue);
EMSCRIPTEN_DECLARE_VAL_TYPE(FilesValue);
EMSCRIPTEN_DECLARE_VAL_TYPE(OptionsValue);
EMSCRIPTEN_DECLARE_VAL_TYPE(StartValue);
EMSCRIPTEN_DECLARE_VAL_TYPE(EventsValue);
EMSCRIPTEN_DECLARE_VAL_TYPE(TaskValue);
EMSCRIPTEN_DECLARE_VAL_TYPE(WordsValue);
EMSCRIPTEN_DECLARE_VAL_TYPE(UniterValue);

EventsValue to_values(const foldwright::Events& events) {
  val array = val::array();
  for (const auto& event : events) array.call<void>("push", foldwright::to_value(event));
  return EventsValue(array);
}

/// Each file's bytes are copied once, into the engine's memory.
std::vector<foldwright::ModelFile> files_from(const FilesValue& files) {
  std::vector<foldwright::ModelFile> found(files["length"].as<std::size_t>());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const val file = files[i];
    found[i].name = file["name"].as<std::string>();
    found[i].bytes = bytes_from(file["bytes"]);
  }
  return found;
}

/// A surface that tasks run on.
class SurfaceHandle {
 public:
  explicit SurfaceHandle(std::shared_ptr<const foldwright::Surface> surface)
      : surface_(std::move(surface)) {}

  std::shared_ptr<const foldwright::Surface> get() const { return surface_; }

 private:
  std::shared_ptr<const foldwright::Surface> surface_;
};

/// Of all jobs of this instance of the engine, which come one after the other.
std::shared_ptr<foldwright::JobMemory> memory() {
  static const auto of_instance = std::make_shared<foldwright::JobMemory>();
  return of_instance;
}

/// A job behind a boundary that no exception crosses: what goes wrong becomes its one event.
class JobHandle {
 public:
  JobHandle(const FilesValue& files, const OptionsValue& options, const StartValue& start) {
    try {
      std::optional<foldwright::JobStart> from;
      if (!start.isNull()) from = foldwright::start_from(start);
      job_.emplace(files_from(files), foldwright::options_from(options), std::move(from), memory());
    } catch (const std::bad_alloc&) {
      failure_ = {{"out-of-memory", {{"what", "file"}}}};
    } catch (const std::exception& error) {
      failure_ = {{"bad-option", {{"what", "unreadable"}, {"detail", error.what()}}}};
    }
  }

  EventsValue step(double budget) {
    return to_values(job_ ? job_->step(static_cast<std::int64_t>(budget)) : failed());
  }

  EventsValue advance() { return to_values(job_ ? job_->advance() : failed()); }

  EventsValue draft() { return job_ ? to_values(job_->draft()) : EventsValue(val::array()); }

  EventsValue cancel() { return to_values(job_ ? job_->cancel() : failed()); }

  /// The next waiting task as {id, surface, bytes}, or undefined. The surface is a key: see
  /// `surface`.
  TaskValue take_task() {
    const auto task = job_ ? job_->take_task() : std::nullopt;
    if (!task) return TaskValue(val::undefined());
    surfaces_[task->surface->key] = task->surface;
    val object = val::object();
    object.set("id", task->id);
    object.set("surface", task->surface->key);
    object.set("bytes", to_array(encode(*task)));
    return TaskValue(object);
  }

  /// A surface that a taken task named, for tasks that this instance of the engine runs itself.
  SurfaceHandle* surface(int key) const { return new SurfaceHandle(surfaces_.at(key)); }

  /// Its bytes, for others.
  BytesValue surface_bytes(int key) const {
    return BytesValue(to_array(encode(*surfaces_.at(key))));
  }

  EventsValue report(int task, const BytesValue& status) {
    return to_values(job_->report(task, foldwright::decode_status(bytes_from(status))));
  }

  EventsValue complete(int task, const BytesValue& result) {
    return to_values(job_->complete(task, foldwright::decode_result(bytes_from(result))));
  }

 private:
  foldwright::Events failed() const { return {failure_}; }

  std::optional<foldwright::Job> job_;
  foldwright::ErrorEvent failure_;
  std::map<int, std::shared_ptr<const foldwright::Surface>> surfaces_;
};

/// Runs one task. Memory that runs out ends the worker, which its owner replaces.
class TaskHandle {
 public:
  TaskHandle(const SurfaceHandle& surface, const BytesValue& task)
      : runner_(foldwright::decode_task(bytes_from(task), surface.get())) {}

  bool step(double budget) { return runner_.step(static_cast<std::int64_t>(budget)); }
  bool is_folding() const { return runner_.is_folding(); }
  BytesValue status(bool with_net) {
    return BytesValue(to_array(encode(runner_.status(with_net))));
  }
  BytesValue result() const { return BytesValue(to_array(encode(runner_.result()))); }

 private:
  foldwright::TaskRunner runner_;
};

JobHandle* create_job(const FilesValue& files, const OptionsValue& options,
                      const StartValue& start) {
  return new JobHandle(files, options, start);
}

SurfaceHandle* create_surface(const BytesValue& bytes) {
  return new SurfaceHandle(foldwright::decode_surface(bytes_from(bytes)));
}

/// Lends all jobs to come a function that unites bodies.
void set_uniter(const UniterValue& unite) { memory()->uniter = foldwright::uniter_from(unite); }

/// The codes of all messages, for a test of the table of sentences.
WordsValue message_codes() {
  val codes = val::array();
  for (const std::string_view code : foldwright::kMessageCodes) {
    codes.call<void>("push", std::string(code));
  }
  return WordsValue(codes);
}

TaskHandle* create_task(const SurfaceHandle& surface, const BytesValue& task) {
  return new TaskHandle(surface, task);
}

}  // namespace

EMSCRIPTEN_BINDINGS(foldwright) {
  using emscripten::allow_raw_pointers;
  emscripten::register_type<BytesValue>("Uint8Array");
  emscripten::register_type<FilesValue>("import('../../model/model-files.js').ModelFiles");
  emscripten::register_type<OptionsValue>("import('../../model/job.js').JobOptions");
  emscripten::register_type<StartValue>("import('../../model/job.js').JobStart | null");
  emscripten::register_type<EventsValue>("import('../../model/job.js').EngineEvent[]");
  emscripten::register_type<TaskValue>(
      "{ id: number; surface: number; bytes: Uint8Array } | undefined");
  emscripten::register_type<WordsValue>("string[]");
  emscripten::register_type<UniterValue>("import('../../model/solids.js').SolidUniter");
  emscripten::class_<JobHandle>("Job")
      .function("step", &JobHandle::step)
      .function("advance", &JobHandle::advance)
      .function("draft", &JobHandle::draft)
      .function("cancel", &JobHandle::cancel)
      .function("takeTask", &JobHandle::take_task)
      .function("surface", &JobHandle::surface, allow_raw_pointers())
      .function("surfaceBytes", &JobHandle::surface_bytes)
      .function("report", &JobHandle::report)
      .function("complete", &JobHandle::complete);
  emscripten::class_<SurfaceHandle>("Surface");
  emscripten::class_<TaskHandle>("Task")
      .function("step", &TaskHandle::step)
      .function("isFolding", &TaskHandle::is_folding)
      .function("status", &TaskHandle::status)
      .function("result", &TaskHandle::result);
  emscripten::function("createJob", &create_job, allow_raw_pointers());
  emscripten::function("createSurface", &create_surface, allow_raw_pointers());
  emscripten::function("messageCodes", &message_codes);
  emscripten::function("setUniter", &set_uniter);
  emscripten::function("createTask", &create_task, allow_raw_pointers());
}
