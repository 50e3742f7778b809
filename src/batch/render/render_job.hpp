#pragma once
#include "base/clock.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/sink/field_files.hpp"
#include "frame/sink/progress.hpp"
#include "frame/sink/sequence.hpp"
#include "gl/context.hpp"
#include "scene/scene.hpp"
#include "scene/scene_input.hpp"
#include "sim/core/numerics.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace simreel::batch {

/// Input of one run. A run is a `simreel render`, a sweep's job, or a piece of a sequence.
struct RenderRequest {
  scene::SceneInput input = {};
  std::string output;
  /// Argument of --frames. "none" draws nothing and simulates up to the last frame in checkpointAt.
  std::optional<std::string> frames;
  frame::Existing existing = frame::Existing::error;
  std::optional<std::string> fields;  ///< argument of --fields
  bool counts = true;
  bool manifest = true;              ///< false to write no manifest.json, run.json and as-run.json
  std::optional<double> checkpoint;  ///< seconds between two checkpoints; nullopt for the default
  std::set<int> checkpointAt;        ///< frames whose checkpoints remain after the run
  std::filesystem::path from;        ///< checkpoint to start from; if empty, the run starts at the scene's
                                     ///< start
  bool checkpointOptional = false;   ///< true to start at the scene's start if `from` cannot be used
  std::string streamFormat = "rgba";
  std::vector<draw::Layer> layers;  ///< layers of OpenEXR pictures in addition to colour
  std::optional<int> bits;          ///< number of bits per value: 8 or 16 in PNG, 16 or 32 for colour in
                                    ///< OpenEXR
  std::string command;              ///< command line to record in run.json
};

/// One run of one scene. The constructor needs no device and reports errors in the request.
class RenderJob {
 public:
  /// Checks the request. Throws UserError.
  explicit RenderJob(RenderRequest request);
  [[nodiscard]] scene::Scene& scene() { return scene_; }
  [[nodiscard]] const std::vector<int>& frames() const { return frames_; }
  [[nodiscard]] const frame::OutputName& output() const { return output_; }

  /// Renders. `began`: start time of the command. Throws UserError.
  frame::SequenceResult run(const gl::Context& context, frame::RunListener& progress,
                            Clock::time_point began, frame::FrameWatch* watch = nullptr);
  /// Returns the written files after run(): "out/000000.png ... out/000119.png".
  [[nodiscard]] const std::string& summary() const { return summary_; }

 private:
  void chooseFrames();
  void chooseManifest();
  void chooseCheckpoints();
  void chooseLayers();
  void placeCamera();
  [[nodiscard]] frame::RunInfo runInfo(const gl::Context& context, const sim::Numerics& numerics) const;

  RenderRequest request_;
  scene::Scene scene_;
  std::vector<int> frames_;
  /// Layers and precision of pictures with more than 8 bits per channel.
  std::optional<draw::LightRequest> layers_;
  frame::OutputName output_;
  std::optional<frame::FieldFiles> fields_;
  std::map<int, std::filesystem::path> kept_;
  std::string asRun_;
  std::vector<std::string> camera_;  ///< overrides of camera and colours for frame::RunInfo::camera
  std::string summary_;
};

}  // namespace simreel::batch
