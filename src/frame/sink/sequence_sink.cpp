#include "frame/sink/sequence_sink.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/log.hpp"
#include "base/png.hpp"
#include "base/processor.hpp"
#include "base/version.hpp"
#include "frame/exr.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/picture_origin.hpp"
#include "frame/file/reserved_room.hpp"
#include "frame/file/run_info.hpp"
#include "frame/file/shared_manifest.hpp"
#include "frame/png_text.hpp"
#include "frame/sink/frame_queue.hpp"
#include "frame/sink/frame_sink.hpp"
#include "frame/sink/open_sink.hpp"
#include "scene/json/words.hpp"
#include "scene/scene.hpp"
#include "sim/light/light_file.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <mutex>

#include <tbb/parallel_for.h>

namespace simreel::frame {

namespace {

namespace fs = std::filesystem;
constexpr std::chrono::milliseconds manifestEvery{1000};

/// Sink that writes PNG or OpenEXR files, additional files and a manifest. Worker threads encode the files.
class SequenceSink final : public FrameSink {
 public:
  SequenceSink(OutputName output, Existing existing, const RunInfo& run, std::span<const int> frames)
      : output_(std::move(output)),
        frames_(frames.begin(), frames.end()),
        folder_(output_.folder),
        file_(output_, run, frames) {
    manifest_.run = run;
    if (existing == Existing::error) refuseExisting(output_, frames_);
    // Upper bounds (bytes) for run.json and for each frame in the manifest.
    constexpr std::size_t runBytes = 16384, frameBytes = 256;
    room_ = ReservedRoom(output_.folder, runBytes + frameBytes * frames_.size());
    auto known = file_.inherit(existing);
    if (existing == Existing::skip || existing == Existing::resume)
      keepWholeFrames(existing, known);
    else
      manifest_.frames = std::move(known);
  }

  ~SequenceSink() override {
    if (finished_) return;
    // Another error ended the run. The frames stored so far can still be resumed.
    try {
      queue_.settle();
    } catch (...) {  // NOLINT(bugprone-empty-catch): the other error is the one to report.
    }
    queue_.abandon();
    writeManifestQuietly();
  }
  SequenceSink(const SequenceSink&) = delete;
  SequenceSink& operator=(const SequenceSink&) = delete;
  SequenceSink(SequenceSink&&) = delete;
  SequenceSink& operator=(SequenceSink&&) = delete;

  bool wants(int frame) override { return !kept_.contains(frame); }

  std::optional<std::string> knownStateHash(int frame) const override {
    const auto found = kept_.find(frame);
    if (found == kept_.end() || found->second.state.empty()) return std::nullopt;
    return found->second.state;
  }

  bool holds(int frame, const std::string& file) const override {
    const auto found = kept_.find(frame);
    return found != kept_.end() && found->second.files.contains(file);
  }

  void add(FrameInfo info, std::optional<Image> image) override {
    try {
      queue_.push(std::move(info), std::move(image));
    } catch (...) {
      giveUp();
    }
  }

  void addCounts(std::string_view text) override { counts_ = text; }

  void settle() override {
    waitForAll();
    file_.write(manifest_);
  }

  bool ownsCheckpoint() const override { return file_.ownsCheckpoint(); }

  void finish() override {
    waitForAll();
    finished_ = true;
    file_.write(manifest_, counts_);
    leaveFolder();
  }

  double encodeSeconds() const override { return queue_.seconds(); }

  std::string summary() const override {
    const std::lock_guard lock(mutex_);
    std::optional<int> first, last;
    for (const int frame : frames_) {
      if (!manifest_.frames.contains(frame)) continue;
      first = std::min(first.value_or(frame), frame);
      last = std::max(last.value_or(frame), frame);
    }
    if (!first) return {};
    const std::string begin = output_.file(*first).string();
    return *first == *last ? begin : begin + " ... " + output_.file(*last).string();
  }

 private:
  /// Creates the output folder before other members create files in it. A new folder is removed again if
  /// nothing was rendered into it.
  struct Folder {
    explicit Folder(const fs::path& path) : made(!pathExists(path)) { makeFolders(path); }
    bool made;
  };

  /// State of a frame's file that already exists.
  struct Kept {
    bool exists = false;
    /// true if the file is empty or not a decodable picture, so that it must be drawn again
    bool damaged = false;
    std::optional<ManifestFrame> whole = {};  ///< manifest entry of the frame if the frame is complete;
                                              ///< otherwise nothing
    /// description of how the file differs from pictures of this run; empty if it does not differ
    std::string difference = {};
  };

  /// Determines which frames need not be drawn. Uses all cores, because it must read every existing file.
  void keepWholeFrames(Existing existing, const std::map<int, ManifestFrame>& known) {
    std::vector<Kept> found(frames_.size());
    tbb::parallel_for(std::size_t{0}, frames_.size(), [&](std::size_t i) {
      const auto entry = known.find(frames_[i]);
      if (entry != known.end()) found[i].whole = wholeFrame(frames_[i], entry->second);
      if (found[i].whole) return;
      const fs::path file = output_.file(frames_[i]);
      if (existing == Existing::skip)
        found[i] = unlistedFrame(frames_[i]);
      else
        found[i].difference = reasonToKeep(file, manifest_.run, frames_[i], entry != known.end());
    });
    std::size_t unlisted = 0, damaged = 0;
    fs::path firstDamaged;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      if (!found[i].difference.empty())
        fail(ExitCode::usage, "cannot {}: {}; use --overwrite, or another folder",
             existing == Existing::skip ? "skip existing frames" : "resume", found[i].difference);
      if (found[i].whole)
        kept_[frames_[i]] = manifest_.frames[frames_[i]] = *found[i].whole;
      else if (found[i].damaged && damaged++ == 0)
        firstDamaged = output_.file(frames_[i]);
      else if (found[i].exists && !found[i].damaged)
        kept_[frames_[i]] = {}, ++unlisted;
    }
    if (damaged > 0)
      warn("{}{} {} empty or damaged; drawn again", firstDamaged.string(),
           damaged == 1 ? "" : fmt::format(" and {} more", damaged - 1), damaged == 1 ? "is" : "are");
    if (unlisted > 0)
      warn("{} of {} kept frames do not name the run that drew them; the manifest does not list them",
           unlisted, kept_.size());
    if (existing == Existing::resume) tellOfRedrawn(output_, frames_, kept_);
    tellOfOtherMachines();
  }

  /// Warns about kept frames that another machine drew, because their pixels may differ slightly.
  void tellOfOtherMachines() const {
    std::size_t count = 0;
    std::string machine;
    for (const auto& [number, frame] : kept_) {
      const std::string other = file_.otherMachineOf(number);
      if (other.empty()) continue;
      ++count;
      machine = other;
    }
    if (count > 0)
      warn(
          "{} of {} kept frames were drawn on another machine ({}) and may differ slightly from what this "
          "one draws; --overwrite draws all frames again",
          count, kept_.size(), scene::printable(machine));
  }

  /// Returns the manifest entry of a listed frame. The entry contains only the complete additional files.
  /// Returns nothing if the picture's hash does not match.
  [[nodiscard]] std::optional<ManifestFrame> wholeFrame(int frame, ManifestFrame listed) const {
    if (hashOfFile(output_.file(frame)) != listed.bytes) return std::nullopt;
    std::erase_if(listed.files, [&](const auto& file) {
      const auto& [name, hash] = file;
      return name.find('/') != std::string::npos || hashOfFile(output_.folder / name) != hash;
    });
    return listed;
  }

  /// Examines a picture that the manifest does not list. If the picture's header says that the picture
  /// belongs to this run, it counts as listed. If it belongs to another run, sets `difference`.
  [[nodiscard]] Kept unlistedFrame(int frame) const {
    const fs::path path = output_.file(frame);
    Kept kept;
    kept.exists = pathExists(path);
    if (!kept.exists) return kept;
    std::error_code unknown;
    if (fs::is_directory(path, unknown))
      fail(ExitCode::inputOutput, "cannot write the picture {}: a folder has this name; remove it",
           path.string());
    try {
      const std::string bytes = readFile(path, "frame");
      const auto file = std::as_bytes(std::span(bytes));
      const PictureOrigin origin = originOf(file, path, manifest_.run, frame);
      kept.difference = origin.difference;
      if (origin.difference.empty() && bytes.starts_with("\x89PNG") && !isWholePng(file)) {
        kept.damaged = true;
        return kept;
      }
      const auto header = pngHeaderOf(bytes);
      // The file may have more than 8 bits per channel, but decodeImage() returns 8 bits.
      const bool deep = !header || header->depth != 8;
      if (!origin.identified || !origin.difference.empty() || output_.isLight() || deep ||
          origin.driver != (manifest_.run.exact() ? std::string() : manifest_.run.driver)) {
        if (origin.difference.empty()) checkWhole(bytes, path);
        return kept;
      }
      const std::string pixels = pixelHash(decodeImage(file, path.string()));
      kept.whole = {output_.fileName(frame), hashHex(bytes), pixels, origin.state};
    } catch (const UserError&) {
      kept.damaged = true;
    }
    return kept;
  }

  /// Throws UserError if the picture cannot be decoded.
  static void checkWhole(const std::string& bytes, const fs::path& path) {
    if (sim::isExr(bytes))
      static_cast<void>(sim::decodeExr(bytes, path.string(), ""));
    else
      static_cast<void>(decodeImage(std::as_bytes(std::span(bytes)), path.string()));
  }

  /// Returns the hash of a file, or an empty text if it cannot be read.
  static std::string hashOfFile(const fs::path& path) {
    try {
      return pathExists(path) ? hashHex(readFile(path, "frame")) : "";
    } catch (const UserError&) {
      return {};
    }
  }

  void store(const FrameInfo& info, const std::optional<Image>& image) {
    ManifestFrame entry;
    for (const FrameFile& file : info.files) {
      writeFileAtomically(output_.folder / file.name, file.bytes, NameSync::later);
      entry.files[file.name] = hashHex(file.bytes);
    }
    if (image) {
      const HashedFile picture =
          info.layers ? HashedFile{info.layers->filmed ? encodeDeepPng(*info.layers, chunks(info))
                                                       : encodeExr(*info.layers, chunks(info)),
                                   pixelHash(*info.layers)}
                      : encodeHashedPng(*image, chunks(info));
      writeFileAtomically(output_.file(info.frame), picture.file, NameSync::later);
      entry.file = output_.fileName(info.frame);
      entry.bytes = hashHex(picture.file);
      entry.pixels = picture.pixels;
      entry.state = info.stateHash;
      entry.drawn = true;
    }
    record(info.frame, std::move(entry));
  }

  /// Adds the frame to the manifest, and writes the manifest at most once a second.
  void record(int frame, ManifestFrame entry) {
    Manifest present;
    {
      const std::lock_guard lock(mutex_);
      ManifestFrame& listed = manifest_.frames[frame];
      if (entry.file.empty())
        for (auto& [name, hash] : entry.files) listed.files[name] = std::move(hash);
      else
        listed = std::move(entry);
      if (writingManifest_ || Clock::now() - manifestTime_ < manifestEvery) return;
      writingManifest_ = true;
      present = manifest_;
    }
    std::exception_ptr error;
    try {
      file_.write(std::move(present));
    } catch (...) {
      error = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    writingManifest_ = false;
    manifestTime_ = Clock::now();
    if (error) std::rethrow_exception(error);
  }

  ImageText chunks(const FrameInfo& info) const {
    ImageText text = {{"Software", fmt::format("simreel {}", version())},
                      {"simreel:scene", manifest_.run.sceneHash},
                      {"simreel:seed", fmt::format("{}", manifest_.run.seed)},
                      {"simreel:frame", fmt::format("{}", info.frame)},
                      {"simreel:state", info.stateHash}};
    if (!manifest_.run.exact()) text.emplace_back("simreel:driver", manifest_.run.driver);
    if (!manifest_.run.overrides.empty())
      text.emplace_back("simreel:overrides", scene::asArguments(manifest_.run.overrides));
    return text;
  }

  void waitForAll() {
    try {
      queue_.settle();
    } catch (...) {
      giveUp();
    }
  }

  /// Writes the manifest and ignores errors. Call only while no worker is running.
  void writeManifestQuietly() noexcept {
    try {
      file_.write(manifest_, counts_);
    } catch (...) {  // NOLINT(bugprone-empty-catch): the error that ended the run is the one to report.
    }
    leaveFolder();
  }

  void leaveFolder() noexcept {
    room_.release();
    file_.release();
    std::error_code notEmpty;
    if (folder_.made) fs::remove(output_.folder, notEmpty);
  }

  /// Cleans up and rethrows the current exception. Must be called in a catch block.
  [[noreturn]] void giveUp() {
    const std::exception_ptr error = std::current_exception();
    queue_.abandon();
    room_.release();
    if (!finished_) writeManifestQuietly();
    finished_ = true;
    std::rethrow_exception(error);
  }

  OutputName output_;
  std::vector<int> frames_;
  Folder folder_;
  SharedManifest file_;
  ReservedRoom room_;  ///< disk space that is reserved so that the manifest can be written on a full disk
  std::map<int, ManifestFrame> kept_;
  std::string counts_;
  bool finished_ = false;

  mutable std::mutex mutex_;  ///< guards all members declared below
  Manifest manifest_;
  bool writingManifest_ = false;
  Clock::time_point manifestTime_ = Clock::now();
  /// One worker per processor, because the calling thread mostly waits for the device or for the workers.
  /// This is the last member, so that its threads end before other members are destroyed.
  FrameQueue queue_{
      processorCount(), processorCount(),
      [this](const FrameInfo& info, const std::optional<Image>& image) { store(info, image); }};
};

}  // namespace

std::unique_ptr<FrameSink> openSequenceSink(const OutputName& output, Existing existing, const RunInfo& run,
                                            std::span<const int> frames) {
  return std::make_unique<SequenceSink>(output, existing, run, frames);
}

}  // namespace simreel::frame
