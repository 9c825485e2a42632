// The engine's whole surface towards JavaScript: one handle, values in, values out.

#include <emscripten/bind.h>

#include <exception>
#include <optional>

#include "values.h"
#include "pipeline/job.h"

namespace {

using emscripten::val;

EMSCRIPTEN_DECLARE_VAL_TYPE(BytesValue);
EMSCRIPTEN_DECLARE_VAL_TYPE(OptionsValue);
EMSCRIPTEN_DECLARE_VAL_TYPE(EventsValue);

/// A job behind a boundary that no exception crosses: what goes wrong becomes its one event.
class JobHandle {
 public:
  JobHandle(const BytesValue& bytes, const std::string& file_name, const OptionsValue& options) {
    try {
      std::vector<std::byte> file(bytes["length"].as<std::size_t>());
      val(emscripten::typed_memory_view(file.size(), reinterpret_cast<std::uint8_t*>(file.data())))
          .call<void>("set", bytes);
      job_.emplace(std::move(file), file_name, foldwright::options_from(options));
    } catch (const std::bad_alloc&) {
      failure_ = {"out-of-memory", "the model needs more memory than there is"};
    } catch (const std::exception& error) {
      failure_ = {"bad-option", error.what()};
    }
  }

  EventsValue step(double budget) {
    val events = val::array();
    if (job_) {
      for (const auto& event : job_->step(static_cast<std::int64_t>(budget))) {
        events.call<void>("push", foldwright::to_value(event));
      }
    } else {
      events.call<void>("push", foldwright::to_value(failure_));
    }
    return EventsValue(events);
  }

 private:
  std::optional<foldwright::Job> job_;
  foldwright::ErrorEvent failure_;
};

JobHandle* create_job(const BytesValue& bytes, const std::string& file_name,
                      const OptionsValue& options) {
  return new JobHandle(bytes, file_name, options);
}

}  // namespace

EMSCRIPTEN_BINDINGS(foldwright) {
  emscripten::register_type<BytesValue>("Uint8Array");
  emscripten::register_type<OptionsValue>("import('../../model/job.js').JobOptions");
  emscripten::register_type<EventsValue>("import('../../model/job.js').JobEvent[]");
  emscripten::class_<JobHandle>("Job").function("step", &JobHandle::step);
  emscripten::function("createJob", &create_job, emscripten::allow_raw_pointers());
}
