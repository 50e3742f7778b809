#pragma once
#include "golden/trace/trace.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// Returns the bytes of steps.bin.
[[nodiscard]] std::vector<std::byte> encodeTrace(const StepTrace& trace);
/// Parses the bytes of steps.bin. Throws UserError(inputOutput), whose message contains the file's name and
/// the mistake.
[[nodiscard]] StepTrace decodeTrace(std::span<const std::byte> bytes, const std::string& name);

}  // namespace simreel::golden
