#pragma once
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace simreel::frame {

constexpr int largestFrame = 9'999'999;
constexpr std::size_t maxFrames = 1'000'000;

/// Parses a frame list such as `0-99x2,150`. The list consists of numbers and inclusive ranges with an
/// optional step, separated by commas. If `last` is set, the word "last" stands for that number. Returns
/// the frames sorted, without duplicates. `option`: name of the option, for error messages. Throws
/// UserError(usage) with the position of the mistake.
[[nodiscard]] std::vector<int> parseFrames(const std::string& text, const char* option = "--frames",
                                           std::optional<int> last = std::nullopt);

/// Formats frames as ranges that parseFrames() can read: "0-99,150".
[[nodiscard]] std::string framesText(const std::set<int>& frames);

}  // namespace simreel::frame
