#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace simreel::frame {

/// An additional output file of a frame, such as a field.
struct FrameFile {
  std::string name;  ///< file name without its folder
  std::vector<std::byte> bytes;
};

/// Description of a whole run. The manifest holds everything that determines the run's pictures. It
/// contains no time, path or machine, so two runs on any machines write the same bytes. The other members
/// are in run.json (run_log.hpp).
struct RunInfo {
  std::string title;
  std::string sceneHash;
  int seed = 0;
  int width = 0;
  int height = 0;
  double fps = 60;
  std::string numerics;  ///< arithmetic of the simulations, "exact" or "fast"
  /// fingerprint of the driver's numerics; written to the manifest unless exact() is true
  std::string fingerprint;
  std::string driver;  ///< renderer and version string of the driver; written to run.json
  /// CPU model, which together with the driver identifies the machine; empty if unknown; written to
  /// run.json
  std::string processor = {};
  std::string rasterizer = "driver";  ///< rasterizer: "driver" (rasterization by the OpenGL driver) or
                                      ///< "exact"
  /// Scene changes as "path=value", from -D, --seed, --size, --fps, --samples and --rasterizer.
  std::vector<std::string> overrides = {};
  /// Scene changes as found in a trial run. They place the camera so that the whole scene is visible, and
  /// set the ranges of colours. Written to the manifest.
  std::vector<std::string> camera = {};
  /// result of scene::simulationHash; a run can resume only from a checkpoint with the same hash
  std::string simulation = {};
  std::string asRun = {};                 ///< scene text with all changes applied; written to as-run.json
  std::string asRunHash = {};             ///< hash of `asRun`, which is written to the manifest; empty if
                                          ///< unknown
  std::string command = {};               ///< command line as typed by the user; written to run.json
  std::vector<std::string> folders = {};  ///< folders in which files of the scene are searched; written to
                                          ///< run.json

  /// True if every machine produces the same bytes, regardless of the driver.
  [[nodiscard]] bool exact() const { return numerics == "exact" && rasterizer == "exact"; }
};

}  // namespace simreel::frame
