#pragma once
#include "base/clock.hpp"
#include "frame/file/checkpoint.hpp"
#include "frame/image.hpp"
#include "gl/context.hpp"
#include "serve/beside/beside.hpp"
#include "serve/beside/counterpart.hpp"
#include "serve/child/render_child.hpp"
#include "serve/net/hub.hpp"
#include "serve/script/script.hpp"
#include "serve/script/watched_files.hpp"
#include "serve/stage/stage.hpp"
#include "sim/core/numerics.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace simreel::serve {

struct PlayerOptions {
  SceneSource source;
  std::vector<std::string> arguments;  ///< scene and overrides as command-line arguments
  std::size_t memory = 0;              ///< max memory (bytes) for kept states
  bool edit = false;                   ///< true if the scene file may be written
  std::filesystem::path output;        ///< folder for renders started on the page; empty if renders are not
                                       ///< allowed
  CounterpartOptions other;            ///< settings of the right side
  std::filesystem::path from;          ///< checkpoint at which the run begins; empty: the scene's start
};

/// Makes the pictures. Handles requests of viewers, watches the scene's files, simulates and draws. Runs on
/// the thread of the GL context.
class Player {
 public:
  /// Reads the scene file. Throws UserError(usage) if it cannot be read. Errors in the scene are shown to
  /// the viewers instead.
  Player(PlayerOptions options, const gl::Context& context, Hub& hub);
  ~Player();
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  /// Runs until the hub stops or a signal has arrived.
  void run();

 private:
  using Json = nlohmann::json;

  void turn();
  void handle(const Request& request);
  void obey(const Json& request);
  void seek(const Json& request);
  void moveCamera(const Json& request);
  void setValue(const Json& request);
  void forget(const Json& request);
  void paint(const Json& request);
  void setBeside(const Json& request);
  void setOther(std::vector<scene::Override> edits, bool moving);
  void renderIt(const Json& request);
  void compare(const Json& request);
  void testThisFrame();
  void lookAtRender();
  void pick(std::uint64_t viewer, const Json& request);

  /// Reads the scene file again.
  void readFile();
  /// Reads the checkpoint again, and begins at its state if it has changed.
  void readOrigin();
  /// Returns the first stage, which begins at the checkpoint if there is one. Throws UserError(usage) if
  /// the checkpoint belongs to another simulation.
  [[nodiscard]] std::unique_ptr<Stage> firstStage(std::shared_ptr<Script> script) const;
  [[nodiscard]] int firstFrame() const { return stage_ == nullptr ? 0 : stage_->firstFrame(); }
  void showFiles();
  void tryAgain();
  /// Shows the scene `text` with these edits, or reports the errors in it. Returns true on success.
  bool load(const std::string& text, std::vector<scene::Override> edits, bool moving);
  /// Updates the right side after a change. `carries`: true if the left side continues with a state of a
  /// simulation with other values.
  void warnOfOther();
  void showOther(bool moving, bool carries);
  void adjustTarget(bool carries);
  void resimulate();
  /// Writes a value into the scene file. `edit`: path of the edit that is then part of the file.
  void writeFile(const scene::Override& change, const std::string& edit);
  /// Does the same as writeFile() for the scene file of the right side.
  void writeOther(const scene::Override& change, const std::string& edit);
  void report(const std::string& text);
  void watch();

  void work();
  void nextFrame();
  void drawPicture(bool draft);
  void compareWithBaseline();
  [[nodiscard]] Stage& compared();
  void adaptDetail(double milliseconds);
  void recordDrag();
  void letGo();
  [[nodiscard]] bool isMoving() const;
  [[nodiscard]] double secondsToWait() const;
  [[nodiscard]] int lastFrame() const;
  [[nodiscard]] bool isAtTarget() const;
  [[nodiscard]] bool isCarried() const;
  bool approach();
  [[nodiscard]] StageMilliseconds took() const;
  [[nodiscard]] std::size_t memoryOfEach() const;

  /// Pictures that are sent in one message. They are the left side, the right side, and their difference.
  struct Drawn {
    std::uint64_t number = 0;
    bool draft = false;
    frame::Image image;
    std::optional<frame::Image> other;
    /// Number of differing pixels. Only for full pictures of the same size.
    std::optional<std::size_t> different;
    std::vector<std::string> files;
  };
  [[nodiscard]] std::string describe(const Drawn& drawn) const;
  void tellAbout();
  void tellScene();
  void sendStatus();
  void sendSeries();
  [[nodiscard]] std::vector<std::string> wordsOf(bool other) const;

  PlayerOptions options_;
  const gl::Context& context_;
  Hub& hub_;
  sim::Numerics numerics_;  ///< numerics of the device
  std::string text_;        ///< text of the scene file
  /// Checkpoint at which the run begins; nullopt: the scene's start.
  std::optional<frame::Checkpoint> from_;
  std::vector<scene::Override> edits_;
  std::unique_ptr<Stage> stage_;
  WatchedFiles files_;
  std::string mistakes_;
  bool unread_ = false;       ///< true if mistakes_ contains errors in the text or missing files
  Clock::time_point reread_;  ///< time of the latest attempt to read missing files
  bool failed_ = false;       ///< true if drawing or simulating has failed and would fail again

  bool playing_ = false;
  bool loop_ = true;
  int target_ = 0;
  std::optional<int> frameBeforeDrag_;  ///< frame to which to return after a drag, during which states were
                                        ///< carried over from a simulation with other values
  Clock::time_point due_;               ///< time at which the next frame must be shown
  Clock::time_point moved_;             ///< time of the last drag request
  double restSeconds_ = 0;  ///< time (s) without a drag request after which the full picture is drawn
  Clock::time_point filesCheckedAt_;  ///< time of the last check of the files
  Clock::time_point statusSentAt_;    ///< time at which the series of the charts were last sent
  bool fullPictureShown_ = false;     ///< true if the shown picture is a full one and up to date
  bool pictureUpToDate_ = false;      ///< true if the shown picture is up to date
  std::size_t level_ = 3;
  /// Latest detail level whose first picture was not measured, because that picture includes shader
  /// compilation.
  std::size_t fresh_ = 0;
  /// Time (ms) that a picture takes at each detail level; 0 if unknown.
  std::array<double, detailLevels.size()> costs_{};
  int quick_ = 0;  ///< number of successive pictures that could have been drawn at a finer detail level
  std::uint64_t pictures_ = 0;
  double encodeMs_ = 0, measureMs_ = 0;
  Beside beside_;
  Counterpart other_;
  bool difference_ = false;  ///< true if the difference of the two sides is shown
  RenderChild child_;
  RenderChild::Progress rendered_;       ///< progress as last sent to the viewers
  std::deque<Clock::time_point> times_;  ///< times of the latest pictures
};

}  // namespace simreel::serve
