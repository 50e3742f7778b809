#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace simreel::frame {

/// A file beside the picture of a frame.
struct FrameFile {
  std::string name;  ///< without a folder
  std::vector<std::byte> bytes;
};

/// What every manifest says of the run as a whole. No times, no paths: two runs write the same bytes.
struct RunInfo {
  std::string title;
  std::string sceneHash;
  int seed = 0;
  int width = 0;
  int height = 0;
  double fps = 60;
  std::string numerics;               ///< "exact" or "fast"
  std::string fingerprint;            ///< of the driver's numerics
  std::string driver;                 ///< renderer and version string
  std::string processor = {};         ///< with the driver, the machine; empty: not known
  std::string rasterizer = "driver";  ///< or "exact"
  /// "path=value" of each -D, --seed, --size, --fps, --samples and --rasterizer.
  std::vector<std::string> overrides = {};

  /// Whether every machine makes the same bytes: nothing of the driver matters then.
  [[nodiscard]] bool exact() const { return numerics == "exact" && rasterizer == "exact"; }
};

}  // namespace simreel::frame
