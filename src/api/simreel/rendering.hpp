#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <simreel/device.hpp>
#include <simreel/load.hpp>
#include <simreel/values.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace simreel {

/// Treatment of files that a rendering finds where it writes.
enum class Existing {
  error,      ///< the files are an error
  overwrite,  ///< they are replaced
  skip,       ///< whole pictures of frames are kept
  resume      ///< whole frames are kept, and the run goes on from its last checkpoint
};

/// Options of a rendering. They have the meaning of the options of `simreel render`.
struct RenderOptions {
  std::optional<std::string> frames = {};  ///< frames in the syntax of --frames, such as "0-99x2,150";
                                           ///< nullopt for all frames; "none" draws nothing
  Existing existing = Existing::error;
  bool manifest = true;  ///< false to write no manifest.json, run.json and as-run.json next to the pictures
  bool counts = true;    ///< false to write no counts of epidemics, fires, fluids and water
  std::optional<std::string> fields = {};  ///< raw values to write beside each picture: an argument of
                                           ///< --fields
  std::vector<std::string> layers = {};    ///< layers of OpenEXR pictures beside the light, as in --layers
  std::optional<int> bits = {};            ///< bits of each number: 8 or 16 in PNG, 16 or 32 in OpenEXR
  std::optional<double> checkpoint = {};   ///< seconds between checkpoints; 0 for none
  std::optional<std::string> checkpointAt = {};  ///< frames whose checkpoints remain, in the syntax of
                                                 ///< --frames
  std::string from = {};                         ///< checkpoint to begin with; empty for the scene's start
  std::string streamFormat = "rgba";  ///< format of the output "-", standard output: "rgba" or "y4m"
  std::string command = {};           ///< text for run.json that says what made the pictures
};

/// Times (s) that stages of a rendering took.
struct StageTimes {
  double start = 0;     ///< before the first step, for device, shaders and textures
  double simulate = 0;  ///< on a GPU, time of the device
  double draw = 0;      ///< on a GPU, time of the device
  double readBack = 0;
  double encode = 0;  ///< CPU time of all threads that encode frames
  double wait = 0;    ///< waiting for encoders, ffmpeg or the disk
};

/// Functions that Rendering::run() calls on the device's thread, in which no function of the library may be
/// called. Empty ones are not called. An exception ends the rendering, and run() throws Error(internal)
/// with its text.
struct RenderEvents {
  std::function<void(int frames)> start = {};
  std::function<void(long done, long total)> prepare = {};  ///< steps of the pre-roll
  /// A frame is done or existed already. Its times include the frames before it that are not drawn.
  std::function<void(int frame, const StageTimes& stages)> frame = {};
  std::function<void(const CheckResult& result)> check = {};  ///< if set, the scene's checks are evaluated
  /// Counts of the scene, as in the lines of NAME.counts.csv.
  std::function<void(int frame, std::string_view names, std::string_view row)> counts = {};
  std::function<void()> complete = {};  ///< all frames are delivered, and files are completed next
  /// The rendering ends. `status`: "ok", "interrupted" or "failed".
  std::function<void(std::string_view status, const StageTimes& stages)> end = {};
};

/// Result of a rendering.
struct RenderResult {
  int frames = 0;            ///< number of frames that are written or existed already
  bool interrupted = false;  ///< true if the rendering was interrupted; files that it wrote are whole
  double seconds = 0;        ///< wall-clock time since the Rendering was made
  StageTimes stages;
  std::string files;  ///< the written files, such as "out/000000.png ... out/000119.png"
};

/// Rendering of a scene from its start, or from a checkpoint, to files. It makes the files of `simreel
/// render`, which is a client of this class. Functions throw Error.
class SIMREEL_API Rendering {
 public:
  /// Reads a scene as Scene::load() does, or as Scene::parse() if there is `text`, and checks the options
  /// and the output. Needs no device. `output`: folder, pattern (out/flag_####.png), picture, video, or
  /// "-".
  Rendering(const std::string& file, const std::string& output, const RenderOptions& options = {},
            const LoadOptions& load = {}, const std::optional<std::string>& text = std::nullopt);
  ~Rendering();
  Rendering(Rendering&&) noexcept;
  Rendering& operator=(Rendering&&) noexcept;
  Rendering(const Rendering&) = delete;
  Rendering& operator=(const Rendering&) = delete;

  /// Renders, once. Device::interrupt() ends the rendering without an exception between two frames:
  /// see RenderResult::interrupted. Throws Error(different) if a frame of an earlier run, which
  /// Existing::resume keeps, has another state now.
  RenderResult run(const Device& device, const RenderEvents& events = {});

 private:
  friend class Scene;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel
