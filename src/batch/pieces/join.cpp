#include "batch/pieces/join.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/log.hpp"
#include "frame/file/manifest.hpp"
#include "frame/file/run_log.hpp"
#include "frame/file/shared_manifest.hpp"
#include "frame/image.hpp"
#include "frame/interrupt.hpp"
#include "frame/sink/open_sink.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tbb/parallel_for.h>

namespace simreel::batch {

namespace {

namespace fs = std::filesystem;
using frame::Manifest;
using frame::ManifestFrame;

/// Output of a piece that has been drawn.
struct Drawn {
  frame::OutputName output;
  Manifest manifest;
  frame::RunLog log;
};

class Join {
 public:
  explicit Join(const PiecePlan& plan) : plan_(plan), whole_(plan.wholeOutput()) {
    for (std::size_t i = 0; i < plan.pieces.size(); ++i) drawn_.push_back(read(i));
    // All pieces must belong to the same run as the first piece.
    for (std::size_t i = 1; i < drawn_.size(); ++i) {
      compareRuns(i);
      compareOverlap(i);
    }
    collectFrames();
    compareMachines();
  }

  void run() {
    const bool video = whole_.kind == frame::OutputName::Kind::video;
    makeFolders(whole_.folder);
    checkFiles(!video);
    std::optional<frame::SharedManifest> claim;
    if (video) {
      makeVideo();
      writeFileAtomically(whole_.runFile(), runLogText(mergedLog({})));
    } else {
      moveFrames(claim);
    }
    std::error_code error;
    fs::remove_all(plan_.folder, error);
    if (error)
      warn("cannot remove {}, which is no longer needed: {}", plan_.folder.string(), error.message());
  }

 private:
  [[nodiscard]] Drawn read(std::size_t piece) const {
    Drawn drawn{plan_.pieceOutput(piece), {}, {}};
    const fs::path file = drawn.output.manifestFile();
    auto manifest = frame::readManifest(file);
    if (!manifest)
      fail(ExitCode::baselineMissing, "piece {} is not drawn: there is no {}", piece, file.string());
    for (const int number : plan_.pieces[piece].frames)
      if (!manifest->frames.contains(number))
        fail(ExitCode::baselineMissing, "piece {} is incomplete: {} has no frame {}", piece, file.string(),
             number);
    drawn.manifest = std::move(*manifest);
    drawn.log = frame::readRunLog(drawn.output.runFile());
    return drawn;
  }

  void compareRuns(std::size_t piece) const {
    if (const auto difference = frame::runDifference(drawn_[piece].manifest.run, drawn_[0].manifest.run))
      fail(ExitCode::usage, "piece {} does not match piece 0: {}", piece, *difference);
  }

  void compareOverlap(std::size_t piece) const {
    const int number = plan_.pieces[piece].first();
    const ManifestFrame& before = drawn_[piece - 1].manifest.frames.at(number);
    const ManifestFrame& after = drawn_[piece].manifest.frames.at(number);
    const char* what = before.state != after.state     ? "state"
                       : before.pixels != after.pixels ? "pixels"
                       : before.bytes != after.bytes   ? "bytes"
                       : before.files != after.files   ? "files beside it"
                                                       : nullptr;
    if (what == nullptr) return;
    fail(ExitCode::different,
         "frame {} was drawn by pieces {} and {}, but its {} differ{}; draw both pieces again", number,
         piece - 1, piece, what, std::string_view(what) == "state" ? "s" : "");
  }

  /// Assigns every frame to a piece. A frame drawn by two pieces is assigned to the piece that begins with
  /// it.
  void collectFrames() {
    for (std::size_t i = 0; i < drawn_.size(); ++i)
      for (const int number : plan_.pieces[i].frames) {
        manifest_.frames[number] = drawn_[i].manifest.frames.at(number);
        owner_[number] = i;
      }
    manifest_.run = drawn_[0].manifest.run;
    manifest_.counts = drawn_.back().manifest.counts;
  }

  /// Rejects pieces from different machines if the result depends on the machine. This holds for pictures
  /// of a driver's rasterizer and for states of fast numerics.
  void compareMachines() const {
    if (manifest_.run.exact()) return;
    const std::string first = drawn_[0].log.machineOf(plan_.pieces[0].first());
    for (const auto& [number, piece] : owner_)
      if (const std::string other = drawn_[piece].log.machineOf(number); other != first)
        fail(ExitCode::usage,
             "piece {} was drawn by {} and piece 0 by {}, and {} depend on the machine; draw all pieces on "
             "machines of one kind, or use exact numerics and the exact rasterizer",
             piece, other, first,
             manifest_.run.numerics == "exact" ? "pictures that a driver draws" : "fast numerics");
  }

  /// File of a frame in its piece's folder, its destination, and its hash.
  struct Move {
    fs::path from, to;
    std::string hash;
  };

  [[nodiscard]] std::vector<Move> moves(bool toWhole) const {
    std::vector<Move> all;
    for (const auto& [number, frame] : manifest_.frames) {
      const fs::path& folder = drawn_[owner_.at(number)].output.folder;
      std::map<std::string, std::string> files = frame.files;
      files[frame.file] = frame.bytes;
      for (const auto& [name, hash] : files) {
        if (name.find('/') != std::string::npos)
          fail(ExitCode::different, "frame {} names {}, which is not a file in its folder", number, name);
        all.push_back({folder / name, toWhole ? whole_.folder / name : fs::path(), hash});
      }
    }
    return all;
  }

  static bool isWhole(const fs::path& file, const std::string& hash) {
    return pathExists(file) && hashHex(readFile(file, "frame")) == hash;
  }

  /// Checks every file at its current location: in its piece's folder or, after an interrupted join, at its
  /// destination.
  void checkFiles(bool toWhole) const {
    const auto all = moves(toWhole);
    tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
      const Move& move = all[i];
      const bool moved = !pathExists(move.from) && !move.to.empty();
      if (!isWhole(moved ? move.to : move.from, move.hash))
        fail(ExitCode::different, "{} is missing, or does not match its manifest; draw its piece again",
             move.from.string());
    });
    if (!manifest_.counts.empty() && !isWhole(countFile(), manifest_.counts))
      fail(ExitCode::different, "{} is missing, or does not match its manifest; draw its piece again",
           countFile().string());
  }

  [[nodiscard]] fs::path countFile() const { return drawn_.back().output.countFile(); }

  /// Moves all files to the output. Existing frames of the same run in the output remain in the manifest.
  void moveFrames(std::optional<frame::SharedManifest>& claim) const {
    frame::RunInfo run = manifest_.run;
    if (const fs::path scene = drawn_[0].output.sceneFile(); pathExists(scene))
      run.asRun = readFile(scene, "scene");
    const std::vector<int> frames = plan_.allFrames();
    claim.emplace(whole_, run, frames);
    const auto before = frame::readRunLog(whole_.runFile());
    static_cast<void>(claim->inherit(frame::Existing::overwrite));
    for (const Move& move : moves(true)) {
      frame::throwIfInterrupted();
      if (!pathExists(move.from)) continue;  // An earlier attempt has moved the file.
      if (::rename(move.from.c_str(), move.to.c_str()) == 0) continue;
      if (errno != EXDEV)
        fail(ExitCode::inputOutput, "cannot rename {} into {}: {}", move.from.string(), move.to.string(),
             std::strerror(errno));
      writeFileAtomically(move.to, readFile(move.from, "frame"), NameSync::later);
      removeFile(move.from);
    }
    writeFileAtomically(whole_.runFile(), runLogText(mergedLog(before)), NameSync::later);
    Manifest manifest = manifest_;
    // Other processes have drawn the frames, and run.json must not record this process.
    for (auto& [number, frame] : manifest.frames) frame.drawn = false;
    claim->write(std::move(manifest),
                 manifest_.counts.empty() ? std::string() : readFile(countFile(), "table of counts"));
  }

  void makeVideo() const {
    frame::RunInfo run = manifest_.run;
    if (const fs::path scene = drawn_[0].output.sceneFile(); pathExists(scene))
      run.asRun = readFile(scene, "scene");
    const std::vector<int> frames = plan_.allFrames();
    const auto sink = frame::openSink(whole_, frame::Existing::overwrite, run, frames, "rgba");
    for (const auto& [number, frame] : manifest_.frames) {
      frame::throwIfInterrupted();
      const fs::path file = drawn_[owner_.at(number)].output.folder / frame.file;
      const std::string bytes = readFile(file, "frame");
      sink->add({number, frame.state}, frame::decodeImage(std::as_bytes(std::span(bytes)), file.string()));
    }
    if (!manifest_.counts.empty()) sink->addCounts(readFile(countFile(), "table of counts"));
    sink->finish();
  }

  [[nodiscard]] frame::RunLog mergedLog(frame::RunLog merged) const {
    for (std::size_t i = 0; i < drawn_.size(); ++i)
      for (frame::RunRecord record : drawn_[i].log.runs) {
        std::erase_if(record.frames, [&](int number) {
          const auto owner = owner_.find(number);
          return owner == owner_.end() || owner->second != i;
        });
        merged.put(record);
      }
    return merged;
  }

  const PiecePlan& plan_;
  frame::OutputName whole_;
  std::vector<Drawn> drawn_;
  Manifest manifest_;
  std::map<int, std::size_t> owner_;  ///< index of the piece that provides each frame, by frame number
};

}  // namespace

void joinPieces(const PiecePlan& plan) {
  Join(plan).run();
}

}  // namespace simreel::batch
