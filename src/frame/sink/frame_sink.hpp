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

/// Data of a frame in addition to its pixels.
struct FrameInfo {
  int frame = 0;
  std::string stateHash;
  /// additional files to store with the frame
  std::vector<FrameFile> files = {};
  /// layers of the picture; null if the output has none
  std::shared_ptr<const draw::PictureLayers> layers = nullptr;
};

/// Destination of rendered frames: numbered sequence, single picture, video file, or standard output. add()
/// may return before the frame is stored. finish() waits until all frames are stored and throws any error.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  /// False if this frame need not be drawn. With --skip-existing, this means that the frame's file exists
  /// and does not belong to another run. With --resume, it means that the file matches the hash in the
  /// manifest.
  [[nodiscard]] virtual bool wants(int frame) = 0;
  /// For a frame that need not be drawn again, returns the state hash in an earlier run's manifest.
  [[nodiscard]] virtual std::optional<std::string> knownStateHash(int frame) const = 0;
  /// True if an earlier run's manifest lists this additional file and the file is complete. For a frame
  /// that need not be drawn again.
  [[nodiscard]] virtual bool holds(int /*frame*/, const std::string& /*file*/) const { return false; }
  /// Stores one frame. The image is empty if the picture exists and only additional files must be stored.
  /// Blocks while too many frames wait. Throws UserError(inputOutput).
  virtual void add(FrameInfo info, std::optional<Image> image) = 0;
  /// Writes the table of counts (count_table.hpp) next to the manifest, if there is one. An existing longer
  /// table that starts with `text` is kept, because it belongs to a longer rendering of the same run.
  virtual void addCounts(std::string_view /*text*/) {}
  /// Waits until all added frames are stored, and updates the manifest if --resume needs it.
  virtual void settle() {}
  /// True if this program may write the checkpoint next to the frames. If several programs render frames of
  /// one run, only one of them may.
  [[nodiscard]] virtual bool ownsCheckpoint() const { return true; }
  /// Writes all pending frames, then the manifest. Must be called once, even after an interrupt.
  virtual void finish() = 0;
  /// Returns the CPU time (s) spent on encoding and writing so far, summed over all threads.
  [[nodiscard]] virtual double encodeSeconds() const = 0;
  /// Returns the names of the written files for the closing line: "out/flag_0000.png ...
  /// out/flag_0119.png".
  [[nodiscard]] virtual std::string summary() const = 0;
};

}  // namespace simreel::frame
