#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace simreel::frame {

constexpr int largestFrame = 9'999'999;
constexpr std::size_t maxFrames = 1'000'000;

/// Reads `--frames 0-99x2,150`: numbers and inclusive ranges with an optional step, separated by
/// commas. Returns them sorted, each once. Throws UserError(usage) naming the position of the mistake.
/// `option`: how the message calls it.
[[nodiscard]] std::vector<int> parseFrames(const std::string& text, const char* option = "--frames");

/// The frames as parseFrames() reads them, in ranges: "0-99,150".
[[nodiscard]] std::string framesText(const std::set<int>& frames);

}  // namespace simreel::frame
