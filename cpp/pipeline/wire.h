#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "pipeline/values/task.h"

namespace foldwright {

/// Bytes that carry a task and what comes of it between instances of the engine of one build. Not a
/// file format: numbers as they lie in memory, no version.
using Bytes = std::vector<std::byte>;

Bytes encode(const Surface& surface);
Bytes encode(const Task& task);  ///< without its surface
Bytes encode(const TaskStatus& status);
Bytes encode(const TaskResult& result);

/// Back from bytes that `encode` made; damaged bytes are a programmer's error.
std::shared_ptr<const Surface> decode_surface(std::span<const std::byte> bytes);
Task decode_task(std::span<const std::byte> bytes, std::shared_ptr<const Surface> surface);
TaskStatus decode_status(std::span<const std::byte> bytes);
TaskResult decode_result(std::span<const std::byte> bytes);

}  // namespace foldwright
