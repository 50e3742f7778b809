#pragma once
#include "golden/trace/trace.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// Returns a trace without words. Each array is divided into as many blocks as `maxBytes` allows: 64, 32,
/// ... or 1. If even one block per array is too large, only the first frames keep every step.
[[nodiscard]] StepTrace layOut(std::vector<StepTrace::Array> arrays, int firstFrame, int lastFrame,
                               std::size_t maxBytes);
/// Returns the number of elements that one invocation of the hash kernel processes. It is a divisor of
/// perBlock and at most 64.
[[nodiscard]] std::uint32_t elementsPerInvocation(std::uint32_t perBlock);
/// Returns a coarser version of a trace. If `whole` is true, each array becomes one block. Only the first
/// `detailed` frames keep every step. `detailed` must not exceed trace.detailed.
[[nodiscard]] StepTrace reduced(const StepTrace& trace, bool whole, std::uint32_t detailed);
/// Returns the first difference within a frame. The earliest step counts, and within a step the first
/// array. The message of the result stays empty.
[[nodiscard]] std::optional<Divergence> compareFrame(const StepTrace& layout, std::uint32_t index,
                                                     std::span<const std::uint32_t> run,
                                                     std::span<const std::uint32_t> baseline);
/// Fills in the message: "leaves the baseline at frame 37, step 4 of 22: flag.positions, particle (12,
/// 30)". `elementName` returns an element's name.
[[nodiscard]] Divergence describe(
    Divergence found, const std::function<std::string(const Divergence&, long element)>& elementName);

}  // namespace simreel::golden
