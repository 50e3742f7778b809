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

/// Data of a frame besides its pixels.
struct FrameInfo {
  int frame = 0;
  std::string stateHash;
  /// additional files to store with the frame
  std::vector<FrameFile> files = {};
  /// layers of the picture; null if the output has none
  std::shared_ptr<const draw::PictureLayers> layers = nullptr;
};

/// Destination of rendered frames: numbered sequence, single picture, video file, or standard output. add()
/// may return before the frame is stored. finish() waits and throws any error.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  /// False if this frame need not be drawn: with --skip-existing, because it exists and does not belong to
  /// another run; with --resume, because it matches the hash in the manifest.
  [[nodiscard]] virtual bool wants(int frame) = 0;
  /// Returns the state hash in an earlier run's manifest for a frame that need not be drawn again.
  [[nodiscard]] virtual std::optional<std::string> knownStateHash(int frame) const = 0;
  /// True if an earlier run's manifest lists this additional file of a frame that need not be drawn again,
  /// and the file is complete.
  [[nodiscard]] virtual bool holds(int /*frame*/, const std::string& /*file*/) const { return false; }
  /// Stores one frame. The image is empty if the picture exists and only additional files must be stored.
  /// Blocks while too many frames wait. Throws UserError(inputOutput).
  virtual void add(FrameInfo info, std::optional<Image> image) = 0;
  /// Writes the table of counts (count_table.hpp) beside the manifest, if there is one. Keeps an existing
  /// longer table that starts with `text`, because it belongs to the same run rendered further.
  virtual void addCounts(std::string_view /*text*/) {}
  /// Waits until all added frames are stored, and updates the manifest if --resume needs it.
  virtual void settle() {}
  /// True if this program may write the checkpoint beside the frames. Of several programs that render
  /// frames of one run, only one may.
  [[nodiscard]] virtual bool ownsCheckpoint() const { return true; }
  /// Writes all pending frames, then the manifest. Call once, also after an interrupt.
  virtual void finish() = 0;
  /// Returns the CPU time (s) spent encoding and writing so far, over all threads.
  [[nodiscard]] virtual double encodeSeconds() const = 0;
  /// Returns the text for the closing line: "out/flag_0000.png ... out/flag_0119.png".
  [[nodiscard]] virtual std::string summary() const = 0;
};

}  // namespace simreel::frame
