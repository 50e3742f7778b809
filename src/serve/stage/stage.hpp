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

/// How much a picture is allowed to cost: 0 is what `simreel render` writes.
struct DetailLevel {
  float scale;  ///< of the picture's sides
  int samples;  ///< per pixel; 0: the scene's
};
inline constexpr std::array<DetailLevel, 6> detailLevels = {
    {{1.0F, 0}, {1.0F, 1}, {0.75F, 1}, {0.5F, 1}, {0.35F, 1}, {0.25F, 1}}};

/// What the last step and picture took, ms by the clock, the device's work included.
struct StageMilliseconds {
  double simulate = 0, draw = 0, readBack = 0;
};

/// A named series of numbers, one a frame.
struct Series {
  std::string object, name, unit;
  std::map<int, double> values;  ///< by frame
};

/// A scene on the device: its world, stepped forward and taken back, and what draws it. Everything here
/// throws UserError as World and Renderer do.
class Stage {
 public:
  /// `memory`: for states that are kept (bytes).
  Stage(std::shared_ptr<Script> script, std::size_t memory);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  [[nodiscard]] const Script& script() const { return *script_; }
  [[nodiscard]] sim::World& world() { return *world_; }
  [[nodiscard]] int frame() const { return world_->frame(); }
  [[nodiscard]] const KeptStates& kept() const { return kept_; }
  /// Frames that were simulated since there is the stage.
  [[nodiscard]] long stepped() const { return stepped_; }
  /// Whether its state came out of other values (become): not what `simreel render` comes to.
  [[nodiscard]] bool carried() const { return carried_; }
  [[nodiscard]] const std::string& stateHash() const { return stateHash_; }
  [[nodiscard]] const StageMilliseconds& took() const { return took_; }
  [[nodiscard]] const std::vector<Series>& series() const { return series_; }

  /// Goes one frame towards `frame`: forward by a step, or back to the nearest state that is kept, or to
  /// the start. Whether it is there.
  bool approach(int frame);
  /// The present frame, at that level.
  [[nodiscard]] frame::Image draw(std::size_t level);
  /// The scene as `simreel test` draws it, its size and samples the test's: for pictures beside baselines.
  /// To be given anew after each change of the script.
  [[nodiscard]] const scene::Scene* testScene() const { return testScene_.get(); }
  void setTestScene(std::unique_ptr<scene::Scene> scene);
  /// The present frame of it, as golden::runScene makes it. There has to be a testScene().
  [[nodiscard]] golden::RunFrame drawTested();
  /// Keeps what the objects measure at the present frame. Waits for the device.
  void measure();
  /// What is at a place of the present picture (askPixel).
  [[nodiscard]] PixelAnswer ask(glm::dvec2 place);

  /// Shows another script, and makes no more anew than it has to (changeBetween). Of a simulation that is
  /// another one from some time on, the states before that stay; then approach() goes on from there.
  /// `moving`: it changes again at once, so the present state may go on with its values, though
  /// `simreel render` comes to another one. Whether it does.
  bool become(std::shared_ptr<Script> script, bool moving);
  /// What came out of other values is forgotten: approach() begins anew.
  void makeGood();
  /// Bytes for states that are kept.
  void allow(std::size_t memory);
  /// Of a stage that shows the same up to some time: takes over its nearest state at or before `frame`, so
  /// that a new stage need not begin at the start.
  void startLike(const Stage& other, int frame);

 private:
  struct Drawer {
    std::unique_ptr<draw::Renderer> renderer;
    std::unique_ptr<draw::Readback> readback;
    glm::ivec2 size{0};
    std::shared_ptr<Script> script;  ///< that it reads
    std::optional<int> toldBefore;   ///< frame whose frame before it knows
  };

  /// States of a simulation that may come back.
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
  void keepWhatIsAlike(const std::shared_ptr<Script>& script);
  [[nodiscard]] bool isNear(const Script& script) const;
  [[nodiscard]] const frame::WorldState* keptBefore(int frame) const;
  bool putBack(const frame::WorldState& state);
  void makeWorld();
  void begin();
  void take(std::unique_ptr<sim::World> world, std::shared_ptr<Script> script);
  void step(bool seen);
  void hear(const sim::World::Summary& summary);
  void lookAt();
  void follow();
  Drawer& drawerOf(std::size_t level);
  void prepareMotion(Drawer& drawer);
  void forgetBefore();

  std::shared_ptr<Script> script_;
  std::shared_ptr<Script> made_;  ///< that the world was made of
  std::size_t memory_;            ///< bytes, of kept_ and past_
  KeptStates kept_;
  Simulated keptOf_;  ///< whose states they are
  std::optional<Past> past_;
  std::unique_ptr<sim::World> world_;
  std::unique_ptr<frame::Summaries> summaries_;
  std::array<Drawer, detailLevels.size()> drawers_;
  std::unique_ptr<scene::Scene> testScene_;
  Drawer tester_;  ///< of testScene_
  long stepped_ = 0;
  bool started_ = false;
  bool carried_ = false;
  bool seen_ = false;  ///< whether the present frame may be looked at
  std::string stateHash_;
  std::vector<std::string> arrayHashes_;  ///< of each state array
  StageMilliseconds took_;
  double making_ = 0;  ///< ms, of the world that goes on with other values
  std::vector<Series> series_;
  std::size_t measured_ = 0;  ///< where measured quantities begin in series_
};

}  // namespace simreel::serve
