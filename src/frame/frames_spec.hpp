#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace simreel::frame {

constexpr int largestFrame = 9'999'999;
constexpr std::size_t maxFrames = 1'000'000;

/// Reads `--frames 0-99x2,150`: numbers and inclusive ranges with an optional step, separated by
/// commas. Returns them sorted, each once. Throws UserError(usage) naming the position of the mistake.
[[nodiscard]] std::vector<int> parseFrames(const std::string& text);

}  // namespace simreel::frame
