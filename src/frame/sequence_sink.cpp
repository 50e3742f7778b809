#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/version.hpp"
#include "frame/reserved_room.hpp"
#include "frame/sinks.hpp"
#include "scene/scene.hpp"
#include "scene/words.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace simreel::frame {

namespace {

namespace fs = std::filesystem;
constexpr std::chrono::milliseconds manifestEvery{1000};

/// PNG files, encoded by worker threads, and the manifest beside them.
class SequenceSink final : public FrameSink {
 public:
  SequenceSink(OutputName output, Existing existing, const RunInfo& run, std::span<const int> frames)
      : output_(std::move(output)), frames_(frames.begin(), frames.end()) {
    manifest_.run = run;
    if (existing == Existing::error) refuseExisting();
    madeFolder_ = !pathExists(output_.folder);
    makeFolders(output_.folder);
    room_ = ReservedRoom(output_.folder, 1024 + 192 * frames_.size());
    inherit(existing);
    if (existing == Existing::skip || existing == Existing::resume) keepWholeFrames(existing);
  }

  ~SequenceSink() override {
    waitForWorkers();
    // Not finished: an error elsewhere ends the run. What is done can still be resumed.
    if (!finished_) writeManifestQuietly();
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

  void add(FrameInfo info, Image image) override {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return error_ || pending_ < mostPending_; });
    if (error_) {
      lock.unlock();
      giveUp();
    }
    ++pending_;
    lock.unlock();
    auto task = std::make_shared<std::pair<FrameInfo, Image>>(std::move(info), std::move(image));
    arena_.enqueue([this, task] { work(task->first, task->second); });
  }

  void settle() override {
    waitForWorkers();
    if (error_) giveUp();
    if (!manifest_.frames.empty()) writeFileAtomically(output_.manifestFile(), manifestText(manifest_));
  }

  void finish() override {
    waitForWorkers();
    if (error_) giveUp();
    finished_ = true;
    // Nothing rendered, nothing to say: an empty manifest would only stand in the way of the next scene.
    if (!manifest_.frames.empty())
      return writeFileAtomically(output_.manifestFile(), manifestText(manifest_));
    room_.release();
    std::error_code notEmpty;
    if (madeFolder_) fs::remove(output_.folder, notEmpty);
  }

  double encodeSeconds() const override { return static_cast<double>(encodeNanoseconds_.load()) * 1e-9; }

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
  void refuseExisting() const {
    std::size_t count = 0;
    fs::path first;
    for (const int frame : frames_) {
      const fs::path file = output_.file(frame);
      std::error_code error;
      if (!fs::exists(fs::symlink_status(file, error))) continue;
      if (count++ == 0) first = file;
    }
    if (count == 0) return;
    const std::string more = count == 1 ? "" : fmt::format(" and {} more", count - 1);
    fail(ExitCode::inputOutput, "{}{} exist{}; use --overwrite, --skip-existing or --resume",
         first.string(), more, count == 1 ? "s" : "");
  }

  /// Takes over the frames that an earlier manifest of the same run lists, so that rendering some
  /// frames anew does not forget the others.
  void inherit(Existing existing) {
    std::optional<Manifest> old;
    try {
      old = readManifest(output_.manifestFile());
    } catch (const UserError&) {
      if (existing == Existing::resume) throw;
    }
    if (!old) return;
    if (const auto difference = runDifference(manifest_.run, old->run)) {
      if (existing == Existing::resume)
        fail(ExitCode::usage, "cannot resume: {} ({}); use --overwrite to start afresh", *difference,
             output_.manifestFile().string());
      return;
    }
    for (auto& [number, frame] : old->frames) {
      std::error_code error;
      if (frame.machine.empty()) frame.machine = machineOf(old->run);
      if (frame.machine == machineOf(manifest_.run)) frame.machine.clear();
      if (number >= 0 && frame.file == output_.fileName(number) && fs::exists(output_.file(number), error))
        manifest_.frames[number] = std::move(frame);
    }
  }

  /// Decides which frames need not be drawn. Reads the files, so on all cores.
  void keepWholeFrames(Existing existing) {
    std::vector<std::optional<ManifestFrame>> found(frames_.size());
    tbb::parallel_for(std::size_t{0}, frames_.size(), [&](std::size_t i) {
      const auto known = manifest_.frames.find(frames_[i]);
      if (known == manifest_.frames.end() && existing == Existing::resume) return;
      std::error_code error;
      if (!fs::exists(output_.file(frames_[i]), error)) return;
      if (known != manifest_.frames.end() && existing == Existing::skip) {
        found[i] = known->second;
        return;
      }
      const std::string hash = hashOfFile(output_.file(frames_[i]));
      if (existing == Existing::skip)
        found[i] = ManifestFrame{output_.fileName(frames_[i]), hash, ""};
      else if (!hash.empty() && hash == known->second.pixels)
        found[i] = known->second;
    });
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      if (found[i])
        kept_[frames_[i]] = manifest_.frames[frames_[i]] = *found[i];
      else
        manifest_.frames.erase(frames_[i]);
    }
    tellOfOtherMachines();
  }

  /// What is kept stays as it is; whoever wants pictures of one machine has to know.
  void tellOfOtherMachines() const {
    std::size_t count = 0;
    std::string machine;
    for (const auto& [number, frame] : kept_) {
      if (frame.machine.empty()) continue;
      ++count;
      machine = frame.machine;
    }
    if (count > 0)
      warn(
          "{} of {} kept frames were drawn on another machine ({}) and may differ by a hair from what this "
          "one draws; --overwrite draws all anew",
          count, kept_.size(), scene::printable(machine));
  }

  /// Pixel hash of a picture, empty when it is not a whole one.
  static std::string hashOfFile(const fs::path& path) {
    try {
      const std::string bytes = readFile(path, "frame");
      return pixelHash(decodeImage(std::as_bytes(std::span(bytes)), path.string()));
    } catch (const UserError&) {
      return {};
    }
  }

  void work(const FrameInfo& info, const Image& image) noexcept {
    const double begin = threadSeconds();
    try {
      {
        const std::lock_guard lock(mutex_);
        if (error_) {
          leave();
          return;
        }
      }
      const std::string hash = pixelHash(image);
      writeFileAtomically(output_.file(info.frame), encodePng(image, chunks(info)));
      encodeNanoseconds_ += static_cast<std::int64_t>((threadSeconds() - begin) * 1e9);
      record(info, hash);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    leave();
  }

  /// With the mutex held: the destructor may go on as soon as it is released.
  void leave() {
    --pending_;
    changed_.notify_all();
  }

  void record(const FrameInfo& info, const std::string& hash) {
    std::string text;
    {
      const std::lock_guard lock(mutex_);
      manifest_.frames[info.frame] = {output_.fileName(info.frame), hash, info.stateHash};
      if (writingManifest_ || Clock::now() - manifestTime_ < manifestEvery) return;
      writingManifest_ = true;
      text = manifestText(manifest_);
    }
    std::exception_ptr error;
    try {
      writeFileAtomically(output_.manifestFile(), text);
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
                      {"simreel:state", info.stateHash},
                      {"simreel:driver", manifest_.run.driver}};
    if (!manifest_.run.overrides.empty())
      text.emplace_back("simreel:overrides", scene::asArguments(manifest_.run.overrides));
    return text;
  }

  void waitForWorkers() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return pending_ == 0; });
  }

  void writeManifestQuietly() noexcept {
    try {
      if (!manifest_.frames.empty())
        return writeFileAtomically(output_.manifestFile(), manifestText(manifest_));
      room_.release();
      std::error_code notEmpty;
      if (madeFolder_) fs::remove(output_.folder, notEmpty);
    } catch (...) {  // NOLINT(bugprone-empty-catch): the error that ended the run is the one to report.
    }
  }

  [[noreturn]] void giveUp() {
    waitForWorkers();
    room_.release();
    writeManifestQuietly();
    finished_ = true;
    std::rethrow_exception(error_);
  }

  OutputName output_;
  std::vector<int> frames_;
  std::map<int, ManifestFrame> kept_;
  std::atomic<std::int64_t> encodeNanoseconds_ = 0;
  std::size_t mostPending_ = 2 * std::max<std::size_t>(1, std::thread::hardware_concurrency());
  bool finished_ = false;
  bool madeFolder_ = false;  ///< it was not there before

  ReservedRoom room_;         ///< on a full disk the manifest takes its place
  mutable std::mutex mutex_;  ///< guards all below
  std::condition_variable changed_;
  Manifest manifest_;
  std::size_t pending_ = 0;
  bool writingManifest_ = false;
  Clock::time_point manifestTime_ = Clock::now();
  std::exception_ptr error_;
  /// As many workers as processors: the caller mostly waits for the device, or for these. Without the
  /// control TBB would grant one less, and warn. The arena is last, so that it ends first.
  std::size_t workers_ = std::max<std::size_t>(1, std::thread::hardware_concurrency());
  tbb::global_control control_{tbb::global_control::max_allowed_parallelism, workers_ + 1};
  tbb::task_arena arena_{static_cast<int>(workers_), 0};
};

}  // namespace

std::unique_ptr<FrameSink> openSequenceSink(const OutputName& output, Existing existing, const RunInfo& run,
                                            std::span<const int> frames) {
  return std::make_unique<SequenceSink>(output, existing, run, frames);
}

}  // namespace simreel::frame
