#pragma once
#include "base/clock.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/sink/field_files.hpp"
#include "frame/sink/progress.hpp"
#include "frame/sink/sequence.hpp"
#include "gl/context.hpp"
#include "scene/scene.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace simreel::batch {

/// What `simreel render`, a job of a sweep and a piece of a sequence are asked for.
struct RenderRequest {
  std::filesystem::path scene;  ///< "-": standard input
  std::vector<scene::Override> overrides;
  std::vector<std::filesystem::path> assets;  ///< further folders
  std::string output;
  /// As --frames takes them, or "none": the simulation goes to the last checkpoint, and nothing is drawn.
  std::optional<std::string> frames;
  frame::Existing existing = frame::Existing::error;
  std::optional<std::string> fields;  ///< "npy" or "pfm"
  bool counts = true;
  std::optional<double> checkpoint;  ///< s between two; else the default
  std::set<int> checkpointAt;        ///< frames whose states are kept for good
  std::filesystem::path from;        ///< checkpoint to begin at; empty: the scene's start
  bool mayDoWithout = false;         ///< begin at the scene's start where `from` cannot be used
  std::string streamFormat = "rgba";
  std::vector<draw::Layer> layers;  ///< of OpenEXR pictures, besides colour
  std::optional<int> bits;          ///< of each number: of PNG 8 or 16, of OpenEXR's colour 16 or 32
  std::string command;              ///< for run.json
};

/// One run of one scene. Made before there is a device: what is wrong with the request shows then.
class RenderJob {
 public:
  /// Throws UserError.
  explicit RenderJob(RenderRequest request);
  [[nodiscard]] scene::Scene& scene() { return scene_; }
  [[nodiscard]] const std::vector<int>& frames() const { return frames_; }
  [[nodiscard]] const frame::OutputName& output() const { return output_; }

  /// Renders. `began`: when the command did. Throws UserError.
  frame::SequenceResult run(const gl::Context& context, frame::Progress& progress, Clock::time_point began,
                            frame::FrameWatch* watch = nullptr);
  /// "out/000000.png ... out/000119.png", after run().
  [[nodiscard]] const std::string& summary() const { return summary_; }

 private:
  void chooseFrames();
  void chooseCheckpoints();
  void chooseLayers();
  void placeCamera();
  [[nodiscard]] frame::RunInfo runInfo(const gl::Context& context) const;

  RenderRequest request_;
  scene::Scene scene_;
  std::vector<int> frames_;
  std::optional<draw::LightRequest> layers_;  ///< of pictures that are not made of their bytes
  frame::OutputName output_;
  std::optional<frame::FieldFiles> fields_;
  std::map<int, std::filesystem::path> kept_;
  std::string asRun_;
  std::vector<std::string> camera_;  ///< frame::RunInfo::camera
  std::string summary_;
};

}  // namespace simreel::batch
