#pragma once
#include "golden/trace/trace.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// The bytes of steps.bin.
[[nodiscard]] std::vector<std::byte> encodeTrace(const StepTrace& trace);
/// Throws UserError(inputOutput) naming the file and what is wrong with it.
[[nodiscard]] StepTrace decodeTrace(std::span<const std::byte> bytes, const std::string& name);

}  // namespace simreel::golden
