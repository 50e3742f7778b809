#pragma once
#include <span>
#include <string>

namespace simreel::frame {

/// Frames per second as a fraction.
struct FrameRate {
  long numerator = 0, denominator = 1;
  /// Returns a text such as "30000:1001", with `between` between the numbers. ffmpeg reads the form with
  /// '/'.
  [[nodiscard]] std::string text(char between) const;
};

/// Returns the frame rate at which the given frames play at the scene's speed. If, for example, every fifth
/// frame is given, this is a fifth of the scene's rate. Rates like 59.94 become 60000/1001. If frames are
/// not evenly spaced, returns the scene's rate and warns.
[[nodiscard]] FrameRate playedRate(double fps, std::span<const int> frames);

}  // namespace simreel::frame
