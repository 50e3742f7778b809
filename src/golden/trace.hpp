#pragma once
#include "golden/result.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// Hashes of every state array after every step of a run: enough to say where another run leaves it. Small:
/// a baseline keeps it (steps.bin).
struct StepTrace;

/// Simulates the scene from its start to `lastFrame`, without drawing, and hashes as it goes, in blocks as
/// fine as `mostBytes` allows.
[[nodiscard]] StepTrace traceRun(const scene::Scene& scene, int lastFrame, std::size_t mostBytes);
[[nodiscard]] std::vector<std::byte> encodeTrace(const StepTrace& trace);
/// Throws UserError(inputOutput) naming the file and what is wrong with it.
[[nodiscard]] StepTrace decodeTrace(std::span<const std::byte> bytes, const std::string& name);
/// The first step at which this program's run of the scene leaves the baseline's; nothing when it never
/// does.
[[nodiscard]] std::optional<Divergence> firstDivergence(const scene::Scene& scene,
                                                        const StepTrace& baseline);

}  // namespace simreel::golden
