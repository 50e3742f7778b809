#pragma once
#include "base/clock.hpp"
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
  std::vector<std::string> arguments;  ///< the scene and what the command line changes of it, as words
  std::size_t memory = 0;              ///< for states that are kept, bytes
  bool edit = false;                   ///< whether the scene file may be written
  std::filesystem::path output;        ///< folder for what is rendered from the page; empty: nothing is
  CounterpartOptions other;            ///< what stands beside the scene
};

/// Makes the pictures: does what viewers ask for, watches the scene's files, steps, draws. On the thread of
/// the context.
class Player {
 public:
  /// Throws UserError(usage) where the scene file cannot be read at all. What is wrong in it is shown.
  Player(PlayerOptions options, const gl::Context& context, Hub& hub);
  ~Player();
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  /// Until the hub stops, or a signal has come.
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

  /// The file as it is now.
  void readFile();
  void showFiles();
  void tryAgain();
  /// Shows the text with these edits, or says what is wrong with it. Whether it does.
  bool show(const std::string& text, std::vector<scene::Override> edits, bool moving);
  /// The other side, beside what is shown; where that went on with other values, `carries`.
  void showOther(bool moving, bool carries);
  void keepPace(bool carries);
  void makeGood();
  /// `edit`: the path of the edit that is in the file then.
  void writeFile(const scene::Override& change, const std::string& edit);
  /// The same of the other side's own file.
  void writeOther(const scene::Override& change, const std::string& edit);
  void report(const std::string& text);
  void watch();

  void work();
  void goOn();
  void drawPicture(bool draft);
  void lookBeside();
  [[nodiscard]] Stage& compared();
  void adaptDetail(double milliseconds);
  void hearOfMoving();
  void letGo();
  [[nodiscard]] bool isMoving() const;
  [[nodiscard]] double secondsToWait() const;
  [[nodiscard]] int lastFrame() const;
  [[nodiscard]] bool isThere() const;
  [[nodiscard]] bool isCarried() const;
  bool approach();
  [[nodiscard]] StageMilliseconds took() const;
  [[nodiscard]] std::size_t memoryOfEach() const;

  /// What goes out at once: the picture, that of the other side, and how they differ.
  struct Drawn {
    std::uint64_t number = 0;
    bool draft = false;
    frame::Image image;
    std::optional<frame::Image> other;
    std::optional<std::size_t> different;  ///< pixels, of whole pictures of one size
    std::vector<std::string> files;
  };
  [[nodiscard]] std::string describe(const Drawn& drawn) const;
  void tellAbout();
  void tellScene();
  void tellStatus();
  void tellSeries();
  [[nodiscard]] std::vector<std::string> wordsOf(bool other) const;

  PlayerOptions options_;
  const gl::Context& context_;
  Hub& hub_;
  sim::Numerics numerics_;  ///< of the device
  std::string text_;        ///< of the file
  std::vector<scene::Override> edits_;
  std::unique_ptr<Stage> stage_;
  WatchedFiles files_;
  std::string mistakes_;
  bool unread_ = false;       ///< whether they are of the text, or of files that are not there
  Clock::time_point reread_;  ///< when it was tried again
  bool failed_ = false;       ///< what there is to do would fail again

  bool playing_ = false;
  bool loop_ = true;
  int target_ = 0;
  std::optional<int> held_;   ///< where to go back to after states that came out of other values
  Clock::time_point due_;     ///< when the next frame is to be shown
  Clock::time_point moved_;   ///< when somebody has last dragged something
  double toRest_ = 0;         ///< s after that, before the whole picture is drawn
  Clock::time_point looked_;  ///< at the files
  Clock::time_point told_;    ///< the series
  bool rest_ = false;         ///< whether the picture is whole and of what there is
  bool shown_ = false;        ///< whether it is of what there is
  std::size_t level_ = 3;
  std::size_t fresh_ = 0;  ///< level whose first picture, which compiles, is no measure
  std::array<double, detailLevels.size()> costs_{};  ///< of a picture at each level, ms; 0: not known
  int quick_ = 0;                                    ///< pictures in a row that may have been finer
  std::uint64_t pictures_ = 0;
  double encodeMs_ = 0, measureMs_ = 0;
  Beside beside_;
  Counterpart other_;
  bool difference_ = false;  ///< whether that of both sides is shown
  RenderChild child_;
  RenderChild::Progress rendered_;       ///< as it was told
  std::deque<Clock::time_point> times_;  ///< of the latest pictures
};

}  // namespace simreel::serve
