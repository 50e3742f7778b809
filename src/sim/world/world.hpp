#pragma once
#include "base/error.hpp"
#include "scene/scene.hpp"
#include "sim/core/simulation.hpp"
#include "sim/world/summary_queue.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace simreel::sim {

/// What making the scene's world and drawing it would be refused for on any device, one mistake an object
/// and one a picture at most: reads every file the scene names. Needs no context.
[[nodiscard]] std::vector<UserError> findProblems(const scene::Scene& scene);

/// One sentence for each object that needs more memory at a time than software drivers and small cards
/// allow.
[[nodiscard]] std::vector<std::string> tooLargeForMany(const scene::Scene& scene);

/// All objects of a scene, stepped together: a mesh that collides, bodies and fluids first, then the others
/// in the scene's order, but what is made of another's field after them, and last who collides with a
/// solid, and cloths in contact, a substep of each in turn. Frame 0 is at time 0; the pre-roll runs before
/// it.
class World {
 public:
  /// Makes every simulation on the current context. `timing`: they measure their stages (Setting::timing).
  /// `presteps`: Setting::presteps.
  explicit World(const scene::Scene& scene, bool timing = false,
                 const std::function<void(long done, long total)>& presteps = {});
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Called after each step, counted from 1, of each object in turn.
  using Watch = std::function<void(std::size_t object, int step)>;
  /// Called when an object has issued all of its steps of a frame; for those in contact one after the other
  /// when all of them have.
  using Stepped = std::function<void(std::size_t object)>;
  /// Simulates up to `frame` (0: the pre-roll only). Never goes back.
  void advanceTo(int frame, const Watch& watch = {}, const Stepped& stepped = {});
  /// Hears what is to be drawn of the frame before each that advanceTo() goes to, where that takes a step.
  void onFrameBefore(std::function<void(const Drawables& before)> hear);
  /// The same, but nobody may look at the state there: neither draw, nor read, nor believe its hash, until
  /// advanceTo() goes further or show() is called.
  void passTo(int frame);
  /// Makes the state of a frame that was passed what advanceTo() would have left.
  void show();
  /// What the next frame depends on, object by object: `begin` hears the name of each before its parts.
  void carryOver(CarryOver& carry, const std::function<void(const std::string& object)>& begin);
  /// After it was put back: the present frame is `frame`, which must not be before the first.
  void resumeAt(int frame);
  /// Gives an object other values on the way (Retunable). Whether it could.
  [[nodiscard]] bool retune(std::size_t index, const scene::Parameters& now);
  /// The frame in which it starts: 0, or below it by the pre-roll.
  [[nodiscard]] int firstFrame() const;
  [[nodiscard]] std::size_t objectCount() const;
  [[nodiscard]] const std::string& objectName(std::size_t index) const;
  /// Whose step it is that Stepped tells of: the object, or all that are in contact, since these go a
  /// substep of each in turn: "a and 9 more in contact".
  [[nodiscard]] std::string stepName(std::size_t index) const;
  [[nodiscard]] int frame() const;
  [[nodiscard]] double time() const;  ///< s, of the current frame
  [[nodiscard]] Drawables drawables() const;
  /// After the drawables were drawn, before the next frame: whether one lacked memory, which is there now,
  /// so that they are to be drawn again (Simulation::grow).
  bool grow();
  [[nodiscard]] const Simulation& object(std::size_t index) const;
  /// Searches the dispatches of the next frame's steps for races (RaceChecked), a line for each place.
  [[nodiscard]] std::vector<std::string> races();

  using ArrayName = sim::ArrayName;
  using CountNames = sim::CountNames;
  using Summary = sim::Summary;
  /// Every state array of every object, in the order in which they are hashed.
  [[nodiscard]] std::vector<ArrayName> arrays() const;
  /// Every object that counts something, in the order of objects.
  [[nodiscard]] std::vector<CountNames> countNames() const;

  /// Starts hashing the state of the current frame on the GPU, and copying its counts; at most that many
  /// may be under way.
  static constexpr int maxSummaries = SummaryQueue::capacity;
  void startSummary();
  /// A finished summary, oldest first. With `wait` blocks for the oldest. Throws UserError(device) when a
  /// simulation lost its state.
  [[nodiscard]] std::optional<Summary> takeSummary(bool wait);

 private:
  struct State;
  void tellBefore();

  std::unique_ptr<State> state_;
};

/// Finds out which kernels the scene's World needs up to frame 0, and has a software driver compile them on
/// the processors that are idle meanwhile. Changes no state; does nothing where there is nothing to gain.
void compileWorldAhead(const scene::Scene& scene);

}  // namespace simreel::sim
