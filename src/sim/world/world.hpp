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

/// Returns the errors that constructing and drawing the scene's world would cause on any device, at most
/// one per object and one per image. Reads every file that the scene refers to; needs no OpenGL context.
[[nodiscard]] std::vector<UserError> findProblems(const scene::Scene& scene);

/// Returns one sentence for each object that needs a larger buffer than software drivers and small GPUs
/// allow.
[[nodiscard]] std::vector<std::string> tooLargeForMany(const scene::Scene& scene);

/// All objects of a scene, stepped in the order of stepOrder(): an object steps after those whose
/// end-of-frame state it reads. Cloths in contact form a group that steps as late as possible; in each
/// substep, all members step one after another. Frame 0 is at time 0; the pre-roll precedes it.
class World {
 public:
  /// Creates every simulation on the current context. If `timing` is true, simulations measure their stages
  /// (Setting::timing). For `presteps`, see Setting::presteps.
  explicit World(const scene::Scene& scene, bool timing = false,
                 const std::function<void(long done, long total)>& presteps = {});
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Callback after each step of each object; steps are counted from 1.
  using Watch = std::function<void(std::size_t object, int step)>;
  /// Callback after an object has issued all of its steps of a frame; for a group, called for each member
  /// after the whole group.
  using Stepped = std::function<void(std::size_t object)>;
  /// Simulates up to `frame`; frame 0 needs the pre-roll only. Cannot go backwards.
  void advanceTo(int frame, const Watch& watch = {}, const Stepped& stepped = {});
  /// Sets a callback for the frame before the target frame of advanceTo(). It receives the drawables of
  /// that frame whenever advanceTo() takes a step.
  void onFrameBefore(std::function<void(const Drawables& before)> callback);
  /// Simulates up to `frame` as advanceTo() does but skips work needed only for display. The state must not
  /// be drawn, read or hashed until advanceTo() goes further or complete() is called.
  void advanceUndrawn(int frame);
  /// Returns false if an exception ended a frame before all objects had stepped. The world must then not be
  /// used further.
  [[nodiscard]] bool isWhole() const;
  /// Completes the state of a frame simulated by advanceUndrawn() to what advanceTo() would have computed.
  void complete();
  /// Saves or restores the state that the next frame depends on, object by object. Calls `begin` with an
  /// object's name before the data of that object.
  void visitCheckpointData(CarryOver& carry, const std::function<void(const std::string& object)>& begin);
  /// Sets the current frame to `frame` (at least firstFrame()) after visitCheckpointData() has restored the
  /// state.
  void resumeAt(int frame);
  /// Changes an object's parameters during the run (see Retunable). Returns false if the object does not
  /// support it.
  [[nodiscard]] bool retune(std::size_t index, const scene::Parameters& now);
  /// Returns the first simulated frame: 0, or minus the number of pre-roll frames.
  [[nodiscard]] int firstFrame() const;
  [[nodiscard]] std::size_t objectCount() const;
  [[nodiscard]] const std::string& objectName(std::size_t index) const;
  /// Returns the name of the object or group whose step `Stepped` reports; for a group in contact, for
  /// example "a and 9 more in contact".
  [[nodiscard]] std::string stepName(std::size_t index) const;
  [[nodiscard]] int frame() const;
  [[nodiscard]] double time() const;  ///< time of the current frame in seconds
  [[nodiscard]] Drawables drawables() const;
  /// Grows buffers that were too small while drawing; call after drawing and before the next frame. Returns
  /// true if the drawables must be drawn again (Simulation::grow).
  bool grow();
  [[nodiscard]] const Simulation& object(std::size_t index) const;
  /// Checks the dispatches of the next frame's steps for data races (RaceChecked). Returns one line per
  /// race.
  [[nodiscard]] std::vector<std::string> races();

  using ArrayName = sim::ArrayName;
  using CountNames = sim::CountNames;
  using Summary = sim::Summary;
  /// Returns every state array of every object in the order of hashing.
  [[nodiscard]] std::vector<ArrayName> arrays() const;
  /// Returns the names of the counts of every object that counts, in the order of objects.
  [[nodiscard]] std::vector<CountNames> countNames() const;

  /// Maximum number of summaries that startSummary() may have pending.
  static constexpr int maxSummaries = SummaryQueue::capacity;
  void startSummary();
  /// Returns the oldest summary if it is finished. If `wait` is true, waits for it. Throws
  /// UserError(device) if a simulation lost its state.
  [[nodiscard]] std::optional<Summary> takeSummary(bool wait);

 private:
  struct State;
  void tellBefore();

  std::unique_ptr<State> state_;
};

/// Determines which kernels the scene's World needs up to frame 0 and lets a software driver compile them
/// on idle processors. Changes no state. Does nothing if it would save no time.
void compileWorldAhead(const scene::Scene& scene);

}  // namespace simreel::sim
