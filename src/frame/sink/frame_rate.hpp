#pragma once
#include <span>
#include <string>

namespace simreel::frame {

/// Pictures a second of a film, as a fraction.
struct FrameRate {
  long numerator = 0, denominator = 1;
  /// "30000:1001" or, with '/', as ffmpeg reads it.
  [[nodiscard]] std::string text(char between) const;
};

/// The rate at which these frames of a scene play as fast as it does: every fifth one a fifth of the
/// scene's. Rates like 59.94 are 60000/1001. Where frames are not evenly spaced each is shown as long as
/// one of the scene, and a warning says so.
[[nodiscard]] FrameRate playedRate(double fps, std::span<const int> frames);

}  // namespace simreel::frame
