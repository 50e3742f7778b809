#pragma once
#include "draw/screen/readback.hpp"
#include "draw/screen/renderer.hpp"
#include "frame/image.hpp"
#include "frame/summaries.hpp"
#include "golden/suite/scene_run.hpp"
#include "serve/script/script.hpp"
#include "serve/stage/ask.hpp"
#include "serve/stage/kept_states.hpp"
#include "sim/world/world.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::serve {

/// Quality of a picture. Level 0 is the quality of `simreel render`.
struct DetailLevel {
  float scale;  ///< factor on the picture's width and height
  int samples;  ///< samples per pixel; 0 to use the scene's value
};
inline constexpr std::array<DetailLevel, 6> detailLevels = {
    {{1.0F, 0}, {1.0F, 1}, {0.75F, 1}, {0.5F, 1}, {0.35F, 1}, {0.25F, 1}}};

/// Wall-clock time in milliseconds of the latest step and picture, including the device's work.
struct StageMilliseconds {
  double simulate = 0, draw = 0, readBack = 0;
};

/// Named series of numbers, one per frame.
struct Series {
  std::string object, name, unit;
  std::map<int, double> values;  ///< values by frame number
};

/// Scene on the device. It consists of a world, which can step forward and go back, and of renderers. All
/// functions throw the UserErrors of World and Renderer.
class Stage {
 public:
  using Origin = std::shared_ptr<const frame::WorldState>;
  /// `memory`: max bytes of stored states. `origin`: state at which the run begins; null for the scene's
  /// start.
  Stage(std::shared_ptr<Script> script, std::size_t memory, Origin origin = nullptr);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  [[nodiscard]] const Script& script() const { return *script_; }
  [[nodiscard]] sim::World& world() { return *world_; }
  [[nodiscard]] int frame() const { return world_->frame(); }
  [[nodiscard]] const KeptStates& kept() const { return kept_; }
  /// Returns the number of frames simulated since the stage was created.
  [[nodiscard]] long stepped() const { return stepped_; }
  /// True if the state was carried over from a simulation with other values (become()). `simreel render`
  /// would then give another state.
  [[nodiscard]] bool carried() const { return carried_; }
  [[nodiscard]] const std::string& stateHash() const { return stateHash_; }
  [[nodiscard]] const StageMilliseconds& took() const { return took_; }
  [[nodiscard]] const std::vector<Series>& series() const { return series_; }

  /// Returns the state at which the run begins; null if it begins at the scene's start, also after a change
  /// that the given state does not fit.
  [[nodiscard]] const Origin& origin() const { return origin_; }
  /// Returns the first frame that can be shown.
  [[nodiscard]] int firstFrame() const { return origin_ ? origin_->frame : 0; }
  /// Begins the run at another state.
  void beginAt(Origin origin);

  /// Moves towards `frame`, at least firstFrame(): one step forward, or back to the nearest kept state or
  /// to the start. Returns true if the stage is at `frame`.
  bool approach(int frame);
  /// Draws the current frame at a detail level.
  [[nodiscard]] frame::Image draw(std::size_t level);
  /// Returns the scene with the size and samples of its test, for pictures that are compared with
  /// baselines. It must be set again after each change of the script.
  [[nodiscard]] const scene::Scene* testScene() const { return testScene_.get(); }
  void setTestScene(std::unique_ptr<scene::Scene> scene);
  /// Draws the current frame of testScene() in the same way as golden::runScene. testScene() must not be
  /// null.
  [[nodiscard]] golden::RunFrame drawTested();
  /// Records the quantities that the objects measure at the current frame. Waits for the device.
  void measure();
  /// Returns information about a position in the current picture (pixelInfo).
  [[nodiscard]] PixelInfo ask(glm::dvec2 place);

  /// Shows another script and rebuilds only the parts that need it (changeBetween). If the simulations
  /// differ only after some time, earlier states remain and approach() continues from them. `moving`: true
  /// if a value is being dragged. In this case the current state may continue with the new values, although
  /// `simreel render` would give another state. Returns true if it does.
  bool become(std::shared_ptr<Script> script, bool moving);
  /// Discards a state that was carried over from a simulation with other values. approach() then simulates
  /// again.
  void resimulate();
  /// Sets the max bytes of stored states.
  void allow(std::size_t memory);
  /// Copies the nearest state at or before `frame` from a stage whose states are equal up to some time, so
  /// that a new stage need not begin at the start.
  void startLike(const Stage& other, int frame);

 private:
  struct Drawer {
    std::unique_ptr<draw::Renderer> renderer;
    std::unique_ptr<draw::Readback> readback;
    glm::ivec2 size{0};
    std::shared_ptr<Script> script;      ///< script that the renderer reads
    std::optional<int> previousFrameOf;  ///< frame for which the renderer has stored the preceding frame,
                                         ///< for motion blur
  };

  /// States of an earlier simulation. They are used again if a change is undone.
  struct Past {
    Simulated of;
    KeptStates kept;
    std::vector<Series> series;
  };

  void takeLookOf(Script& from);
  void drawAs(std::shared_ptr<Script> script);
  void dressAs(std::shared_ptr<Script> script);
  [[nodiscard]] bool retuneTo(const std::shared_ptr<Script>& script);
  [[nodiscard]] bool carryOverTo(std::shared_ptr<Script> script);
  void simulateAs(std::shared_ptr<Script> script);
  void keepEqualStates(const std::shared_ptr<Script>& script);
  [[nodiscard]] bool isNear(const Script& script) const;
  [[nodiscard]] const frame::WorldState* keptBefore(int frame) const;
  bool putBack(const frame::WorldState& state);
  void makeWorld();
  void begin();
  void startAtOrigin();
  void adopt(std::unique_ptr<sim::World> world, std::shared_ptr<Script> script);
  void step(bool seen);
  void keepSummary(const sim::World::Summary& summary);
  void lookAt();
  void follow();
  Drawer& drawerOf(std::size_t level);
  void prepareMotion(Drawer& drawer);
  void forgetBefore();

  std::shared_ptr<Script> script_;
  std::shared_ptr<Script> worldScript_;  ///< script that the world was built from
  Origin origin_;
  std::size_t memory_;  ///< memory limit of kept_ and past_ together, in bytes
  KeptStates kept_;
  Simulated storedSimulation_;  ///< simulation that computed the states in kept_
  std::optional<Past> past_;
  std::unique_ptr<sim::World> world_;
  std::unique_ptr<frame::Summaries> summaries_;
  std::array<Drawer, detailLevels.size()> drawers_;
  std::unique_ptr<scene::Scene> testScene_;
  Drawer tester_;  ///< renderer for testScene_
  long stepped_ = 0;
  bool started_ = false;
  bool carried_ = false;
  bool ready_ = false;  ///< true if the current frame is ready to be drawn
  std::string stateHash_;
  std::vector<std::string> arrayHashes_;  ///< hash of each state array
  StageMilliseconds took_;
  double making_ = 0;  ///< time (ms) that it took to build the world that continues with other values
  std::vector<Series> series_;
  std::size_t measured_ = 0;  ///< index of the first measured quantity in series_
};

}  // namespace simreel::serve
