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

/// A run as a whole. What its pictures depend on stands in the manifest, which holds no time, path or
/// machine: two runs write the same bytes, wherever they ran. The rest goes to run.json (run_log.hpp).
struct RunInfo {
  std::string title;
  std::string sceneHash;
  int seed = 0;
  int width = 0;
  int height = 0;
  double fps = 60;
  std::string numerics;               ///< "exact" or "fast"
  std::string fingerprint;            ///< of the driver's numerics; in the manifest unless exact()
  std::string driver;                 ///< renderer and version string; run.json
  std::string processor = {};         ///< with the driver, the machine; empty: not known; run.json
  std::string rasterizer = "driver";  ///< or "exact"
  /// "path=value" of each -D, --seed, --size, --fps, --samples and --rasterizer.
  std::vector<std::string> overrides = {};
  /// Overrides that place the camera where a first run has found that it sees all; in the manifest.
  std::vector<std::string> camera = {};
  std::string simulation = {};            ///< scene::simulationHash: whose checkpoints it goes on from
  std::string asRun = {};                 ///< the scene with its overrides, as text; as-run.json
  std::string asRunHash = {};             ///< of that text; in the manifest; empty: not known
  std::string command = {};               ///< as typed; run.json
  std::vector<std::string> folders = {};  ///< below which files of the scene were looked for; run.json

  /// Whether every machine makes the same bytes: nothing of the driver matters then.
  [[nodiscard]] bool exact() const { return numerics == "exact" && rasterizer == "exact"; }
};

}  // namespace simreel::frame
