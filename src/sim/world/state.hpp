#pragma once
#include "sim/body/bones.hpp"
#include "sim/collide/distance_fields.hpp"
#include "sim/core/frame_observer.hpp"
#include "sim/world/lag.hpp"
#include "sim/world/object_links.hpp"
#include "sim/world/world.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace simreel::sim {

/// The objects of a World, how they are made, and how they find each other.
struct World::State {
  double fps;
  int preroll;
  int done = 0;  ///< frames simulated, the pre-roll's included
  Bones bones;
  std::vector<ColliderShape> colliders;
  std::unique_ptr<DistanceFields> meshes;  ///< of the rigid meshes that collide, where something may touch
  ObjectLinks links;
  const std::vector<std::unique_ptr<Simulation>>& objects;  ///< owned by `links`
  std::vector<std::unique_ptr<StepGroup>> groups;           ///< of each node of the step order; null: none
  std::vector<std::string> names;
  std::optional<std::size_t> tracked;   ///< the object that the camera looks at
  std::vector<FrameStarter*> starters;  ///< objects that take in others before each frame
  std::vector<bool> isRead;             ///< true for an object that others take in
  scene::Camera camera;
  std::vector<Lag> lags;  ///< of the camera behind what it looks at, and behind where it would stand
  std::vector<FrameObserver*> observers;  ///< among the objects
  std::vector<std::size_t> observed;      ///< objects that these, or the lag, look at
  std::unique_ptr<SummaryQueue> summaries;
  std::function<void(const Drawables& before)> hearBefore;
  bool passed = false;  ///< whether nobody may look at the present frame

  State(const scene::Scene& scene, bool timing, const std::function<void(long, long)>& presteps);
  void makeLags(double frameSeconds);
  /// Finds the objects that note something of every frame, and the objects that they look at.
  void findObservers(const scene::Scene& scene);
  [[nodiscard]] double now() const { return (done - preroll) / fps; }
  /// What the camera looks at, which may lag behind its object.
  [[nodiscard]] std::optional<glm::vec3> trackedPlace() const;
  /// What the lags go after in this frame, as sim::Drawables::lagging has it; empty while it is not there.
  [[nodiscard]] std::vector<glm::vec3> ahead() const;
  /// Tells those who note something of every frame. What they look at is as it is drawn, and what is made
  /// only to be drawn is made here, so that it does not matter which frames are.
  void observe();
  /// Finds the objects that take in others before each frame, and those others.
  void findRead(const scene::Scene& scene);
  void startFrame() const;
  void makeMeshes(const scene::Scene& scene);
  void makeObjects(const scene::Scene& scene, Setting& setting);
  /// Makes a group: all of it take as many steps as the one that needs most.
  [[nodiscard]] std::unique_ptr<StepGroup> makeGroup(const scene::Scene& scene, const StepNode& node,
                                                     const Setting& setting);
};

}  // namespace simreel::sim
