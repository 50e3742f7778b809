#pragma once
#include "sim/body/bones.hpp"
#include "sim/collide/distance_fields.hpp"
#include "sim/core/frame_observer.hpp"
#include "sim/ports/shown_picture.hpp"
#include "sim/world/lag.hpp"
#include "sim/world/object_links.hpp"
#include "sim/world/world.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace simreel::sim {

/// Objects of a World, their construction, and the links between them.
struct World::State {
  double fps;
  int preroll;
  int done = 0;  ///< number of frames simulated, including the pre-roll
  Bones bones;
  std::vector<ColliderShape> colliders;
  std::unique_ptr<DistanceFields> meshes;  ///< distance fields of rigid meshes that collide; null if no
                                           ///< object can touch them
  ObjectLinks links;
  const std::vector<std::unique_ptr<Simulation>>& objects;  ///< owned by `links`
  std::vector<std::unique_ptr<StepGroup>> groups;           ///< one group per node of the step order; null:
                                                            ///< a single object
  std::vector<std::string> names;
  std::optional<std::size_t> tracked;   ///< index of the object that the camera looks at
  std::vector<FrameStarter*> starters;  ///< objects that read others before each frame
  std::vector<bool> isRead;             ///< true if another object reads this one before each frame
  scene::Camera camera;
  ShownPicture picture;   ///< provided by `links`
  std::vector<Lag> lags;  ///< lags of the camera's target, and of its eye if the camera follows a path
  std::vector<FrameObserver*> observers;  ///< the objects that implement FrameObserver
  std::vector<std::size_t> observed;      ///< indices of the objects that the observers or the lags read
  std::unique_ptr<SummaryQueue> summaries;
  std::function<void(const Drawables& before)> hearBefore;
  bool stepping = false;  ///< true within a frame, and after an exception ended it
  bool passed = false;    ///< true if the current frame is passed and its state must not be read

  State(const scene::Scene& scene, bool timing, const std::function<void(long, long)>& presteps);
  void makeLags(double frameSeconds);
  /// Finds the frame observers and the objects that they read.
  void findObservers(const scene::Scene& scene);
  [[nodiscard]] double now() const { return (done - preroll) / fps; }
  /// Returns the position that the camera looks at, which may lag behind its object.
  [[nodiscard]] std::optional<glm::vec3> trackedPlace() const;
  /// Returns the positions that the lags follow in this frame, in the order of sim::Drawables::lagging;
  /// empty while the followed object has no position.
  [[nodiscard]] std::vector<glm::vec3> ahead() const;
  /// Calls the frame observers. Updates the objects that they read to their drawn state, including data
  /// computed only for drawing, so that the result does not depend on which frames are drawn.
  void observe();
  /// Finds the objects that read others before each frame, and the objects that they read.
  void findRead(const scene::Scene& scene);
  void startFrame() const;
  void makeMeshes(const scene::Scene& scene);
  void makeObjects(const scene::Scene& scene, Setting& setting);
  /// Creates a group whose members all take as many steps per frame as the one that needs most.
  [[nodiscard]] std::unique_ptr<StepGroup> makeGroup(const scene::Scene& scene, const StepNode& node,
                                                     const Setting& setting);
};

}  // namespace simreel::sim
