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
  const std::vector<std::unique_ptr<Simulation>>& objects;  ///< simulations of all objects; owned by
                                                            ///< `links`
  std::vector<std::unique_ptr<StepGroup>> groups;           ///< step group of each node of the step order;
                                                            ///< null if the node is a single object
  std::vector<std::string> names;
  std::optional<std::size_t> tracked;   ///< index of the object at which the camera aims
  std::vector<FrameStarter*> starters;  ///< objects that read other objects before each frame
  std::vector<bool> isRead;             ///< for each object: true if another object reads it before each
                                        ///< frame
  scene::Camera camera;
  ShownPicture picture;   ///< outlet that `links` provides for the scene
  std::vector<Lag> lags;  ///< lag of the camera's target, then, if the camera follows a path, lag of its
                          ///< eye
  std::vector<FrameObserver*> observers;  ///< objects that implement FrameObserver
  std::vector<std::size_t> observed;      ///< indices of the objects that the observers or the lags read
  std::unique_ptr<SummaryQueue> summaries;
  std::function<void(const Drawables& before)> onFrameBefore_;
  bool stepping = false;  ///< true while a frame is simulated, and after an exception ended the frame
  bool passed = false;  ///< true if the current frame was simulated by advanceUndrawn(), so that its state
                        ///< must not be read

  State(const scene::Scene& scene, bool timing, const std::function<void(long, long)>& presteps);
  void makeLags(double frameSeconds);
  /// Finds the frame observers and the objects that they read.
  void findObservers(const scene::Scene& scene);
  [[nodiscard]] double now() const { return (done - preroll) / fps; }
  /// Returns the position at which the camera aims; it may lag behind the object.
  [[nodiscard]] std::optional<glm::vec3> trackedPlace() const;
  /// Returns the positions that the lags follow in this frame, in the order of sim::Drawables::lagging;
  /// empty while the followed object has no position.
  [[nodiscard]] std::vector<glm::vec3> ahead() const;
  /// Calls the frame observers. First updates the objects that they read to the state in which they are
  /// drawn, so that the result does not depend on which frames are drawn.
  void observe();
  /// Finds the objects that read others before each frame, and the objects that are read.
  void findRead(const scene::Scene& scene);
  void startFrame() const;
  void makeMeshes(const scene::Scene& scene);
  void makeObjects(const scene::Scene& scene, Setting& setting);
  /// Creates a group whose members all take the same number of steps per frame: the maximum that any member
  /// needs.
  [[nodiscard]] std::unique_ptr<StepGroup> makeGroup(const scene::Scene& scene, const StepNode& node,
                                                     const Setting& setting);
};

}  // namespace simreel::sim
