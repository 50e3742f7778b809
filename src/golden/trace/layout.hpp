#pragma once
#include "golden/trace/trace.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// A trace without words yet, cut into as many blocks as fit: powers of two down to whole arrays, then
/// fewer frames with every step.
[[nodiscard]] StepTrace layOut(std::vector<StepTrace::Array> arrays, int firstFrame, int lastFrame,
                               std::size_t maxBytes);
/// Elements that one invocation of the hash kernel takes: a divisor of perBlock, at most 64.
[[nodiscard]] std::uint32_t elementsPerInvocation(std::uint32_t perBlock);
/// The same trace with less in it, as if it had been laid out so: each array as one block where `whole`,
/// and every step of the first `detailed` frames only (at most as many as it has).
[[nodiscard]] StepTrace reduced(const StepTrace& trace, bool whole, std::uint32_t detailed);
/// The first difference of a frame: the earliest step, then the first array. The message is empty.
[[nodiscard]] std::optional<Divergence> compareFrame(const StepTrace& layout, std::uint32_t index,
                                                     std::span<const std::uint32_t> run,
                                                     std::span<const std::uint32_t> baseline);
/// With its message: "leaves the baseline at frame 37, step 4 of 22: flag.positions, particle (12, 30)".
[[nodiscard]] Divergence describe(
    Divergence found, const std::function<std::string(const Divergence&, long element)>& elementName);

}  // namespace simreel::golden
