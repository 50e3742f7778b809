#pragma once
#include "draw/exact/scene/picture_layers.hpp"
#include "frame/file/run_info.hpp"
#include "frame/image.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::frame {

/// What is known of a frame besides its pixels.
struct FrameInfo {
  int frame = 0;
  std::string stateHash;
  std::vector<FrameFile> files = {};                            ///< to be stored with it
  std::shared_ptr<const draw::PictureLayers> layers = nullptr;  ///< where the output has them
};

/// Where rendered frames go: a numbered sequence, one picture, a video file, or standard output.
/// add() may return before the frame is stored; finish() waits, and throws what went wrong.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  /// False when this frame need not be drawn: it is already there and of no other run (--skip-existing),
  /// or the manifest and the file's hash say it is whole (--resume).
  [[nodiscard]] virtual bool wants(int frame) = 0;
  /// The state hash that an earlier run's manifest holds for a frame that is not wanted again.
  [[nodiscard]] virtual std::optional<std::string> knownStateHash(int frame) const = 0;
  /// Whether an earlier run's manifest lists this file beside a frame that is not wanted again, and it is
  /// whole.
  [[nodiscard]] virtual bool holds(int /*frame*/, const std::string& /*file*/) const { return false; }
  /// Hands over one frame, or for one that is not wanted only the files beside it; blocks while too many
  /// are waiting. Throws UserError(inputOutput).
  virtual void add(FrameInfo info, std::optional<Image> image) = 0;
  /// Writes what the simulations count (count_table.hpp) beside the manifest, where there is one. A table
  /// that begins with all of this one stays: it is of the same run, which went further then.
  virtual void addCounts(std::string_view /*text*/) {}
  /// Waits until all that was added is stored, and the manifest says so where --resume asks it.
  virtual void settle() {}
  /// Whether a checkpoint beside the frames is this program's to write: of several that render frames of
  /// one run it is one's.
  [[nodiscard]] virtual bool ownsCheckpoint() const { return true; }
  /// Writes all that is pending, then the manifest. Call once; also after an interrupt.
  virtual void finish() = 0;
  /// Seconds of processor time spent encoding and writing so far, over all threads.
  [[nodiscard]] virtual double encodeSeconds() const = 0;
  /// "out/flag_0000.png ... out/flag_0119.png" for the closing line.
  [[nodiscard]] virtual std::string summary() const = 0;
};

}  // namespace simreel::frame
