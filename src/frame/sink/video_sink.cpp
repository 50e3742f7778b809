#include "frame/sink/video_sink.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/file/shared_manifest.hpp"
#include "frame/sink/ffmpeg.hpp"
#include "frame/sink/frame_queue.hpp"
#include "frame/sink/frame_rate.hpp"
#include "frame/sink/frame_sink.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace simreel::frame {

namespace {

namespace fs = std::filesystem;

/// Sink for a video file and its manifest. ffmpeg writes to a file with a temporary name, which is renamed
/// when it is complete.
class VideoSink final : public FrameSink {
 public:
  VideoSink(OutputName output, Existing existing, const RunInfo& run, std::span<const int> frames)
      : output_(std::move(output)), file_(output_.file(0)), part_(partName(file_)) {
    manifest_.run = run;
    if (existing == Existing::resume)
      fail(ExitCode::usage,
           "--resume cannot continue the video {}; render frames into a folder, or use --overwrite",
           file_.string());
    std::error_code error;
    if (fs::exists(fs::symlink_status(file_, error))) {
      if (existing == Existing::error)
        fail(ExitCode::inputOutput, "{} exists; use --overwrite or --skip-existing", file_.string());
      if (existing == Existing::skip) {
        skip();
        return;
      }
    }
    makeFolders(output_.folder);
    refuseReadOnly();
    shared_.emplace(output_, run, frames);
    if (const auto [width, height] = videoSize(file_, run.width, run.height);
        width != run.width || height != run.height)
      warn(
          "{}: this encoder needs an even width and height, so {}x{} becomes {}x{} with a black edge; "
          "choose --size {}x{}",
          file_.string(), run.width, run.height, width, height, width, height);
    ffmpeg_.emplace(ffmpegArguments(part_, run.width, run.height, playedRate(run.fps, frames)), file_);
    queue_.emplace(1, FrameQueue::maxWaitingInOrder,
                   [this](const FrameInfo& info, const std::optional<Image>& image) {
                     if (image) handle(info, *image);
                   });
  }

  ~VideoSink() override {
    if (!queue_) return;
    ffmpeg_->kill();  // Ends ffmpeg first, because the queue's thread might be blocked while it writes to
                      // ffmpeg.
    queue_->abandon();
    removePart();
  }
  VideoSink(const VideoSink&) = delete;
  VideoSink& operator=(const VideoSink&) = delete;
  VideoSink(VideoSink&&) = delete;
  VideoSink& operator=(VideoSink&&) = delete;

  bool wants(int /*frame*/) override { return !skipped_; }

  std::optional<std::string> knownStateHash(int frame) const override {
    const auto found = manifest_.frames.find(frame);
    if (!skipped_ || found == manifest_.frames.end() || found->second.state.empty()) return std::nullopt;
    return found->second.state;
  }

  void add(FrameInfo info, std::optional<Image> image) override {
    queue_->push(std::move(info), std::move(image));
  }
  void addCounts(std::string_view text) override { counts_ = text; }

  void finish() override {
    if (skipped_ || !queue_) return;
    queue_->close();
    if (manifest_.frames.empty())
      return;  // The run was interrupted before the first frame, so there is no video.
    ffmpeg_->finish();
    seconds_ = queue_->seconds();
    queue_.reset();
    renameDurably(part_, file_);
    shared_->write(manifest_, counts_);
    shared_.reset();
  }

  double encodeSeconds() const override { return queue_ ? queue_->seconds() : seconds_; }
  std::string summary() const override { return file_.string(); }

 private:
  /// Returns the temporary name "dir/name.part.mp4". The name keeps the extension, because ffmpeg derives
  /// the format from it.
  static fs::path partName(const fs::path& file) {
    return file.parent_path() / (file.stem().string() + ".part" + file.extension().string());
  }

  /// Keeps the existing file. Reads state hashes from its manifest, if the manifest is readable.
  void skip() {
    skipped_ = true;
    std::optional<std::string> difference;
    try {
      auto old = readManifest(output_.manifestFile());
      if (!old) return;
      difference = runDifference(manifest_.run, old->run);
      if (!difference) manifest_ = std::move(*old);
    } catch (const UserError& error) {
      warn("{}", error.what());
    }
    if (difference)
      fail(ExitCode::usage, "cannot skip the existing video: {} ({}); use --overwrite to start afresh",
           *difference, output_.manifestFile().string());
  }

  /// Reports a read-only folder before the first frame is drawn, with a clearer message than ffmpeg's.
  void refuseReadOnly() const {
    const fs::path folder = output_.folder.empty() ? fs::path(".") : output_.folder;
    if (::access(folder.c_str(), W_OK) != 0)
      fail(ExitCode::inputOutput, "cannot create {}: {}", file_.string(), std::strerror(errno));
  }

  void handle(const FrameInfo& info, const Image& image) {
    SIMREEL_CHECK_EQ(image.width, manifest_.run.width);
    SIMREEL_CHECK_EQ(image.height, manifest_.run.height);
    ffmpeg_->write(std::as_bytes(std::span(image.bytes)));
    ManifestFrame& frame = manifest_.frames[info.frame];
    frame = {output_.fileName(info.frame), "", pixelHash(image), info.stateHash};
    frame.drawn = true;
  }

  void removePart() const noexcept {
    std::error_code ignored;
    fs::remove(part_, ignored);
  }

  OutputName output_;
  fs::path file_;
  fs::path part_;
  bool skipped_ = false;
  double seconds_ = 0;
  Manifest manifest_;  ///< accessed only by the queue's thread until the queue is closed
  std::string counts_;
  std::optional<SharedManifest> shared_;
  std::optional<Ffmpeg> ffmpeg_;
  std::optional<FrameQueue> queue_;
};

}  // namespace

std::unique_ptr<FrameSink> openVideoSink(const OutputName& output, Existing existing, const RunInfo& run,
                                         std::span<const int> frames) {
  return std::make_unique<VideoSink>(output, existing, run, frames);
}

}  // namespace simreel::frame
