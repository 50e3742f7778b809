#pragma once
#include "sim/body/bones.hpp"
#include "sim/collide/distance_fields.hpp"
#include "sim/contact/lock_step.hpp"
#include "sim/core/field_reader.hpp"
#include "sim/core/frame_observer.hpp"
#include "sim/world/lag.hpp"
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
  std::vector<std::unique_ptr<Simulation>> objects;
  std::vector<std::size_t> touching;  ///< objects that are in contact, in their order
  std::unique_ptr<ContactGroup> contact;
  std::vector<std::size_t> order;  ///< in which objects are made and stepped
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> quantities;  ///< that each object measures
  std::optional<std::size_t> tracked;                ///< the object that the camera looks at
  std::vector<FieldReader*> readers;  ///< objects that take in fields of others before each frame
  std::vector<bool> isRead;           ///< whether an object is one of these others
  scene::Camera camera;
  std::vector<Lag> lags;  ///< of the camera behind what it looks at, and behind where it would stand
  std::vector<FrameObserver*> observers;  ///< among the objects
  std::vector<std::size_t> observed;      ///< objects that these, or the lag, look at
  std::unique_ptr<SummaryQueue> summaries;
  std::function<void(const Drawables& before)> hearBefore;
  bool passed = false;  ///< whether nobody may look at the present frame

  State(const scene::Scene& scene, bool timing, const std::function<void(long, long)>& presteps);
  void makeLags(double frameSeconds);
  /// Who notes something of every frame, and of which objects.
  void findObservers();
  [[nodiscard]] double now() const { return (done - preroll) / fps; }
  /// What the camera looks at, which may lag behind its object.
  [[nodiscard]] std::optional<glm::vec3> trackedPlace() const;
  /// What the lags go after in this frame, as sim::Drawables::lagging has it; empty while it is not there.
  [[nodiscard]] std::vector<glm::vec3> ahead() const;
  /// Tells those who note something of every frame. What they look at is as it is drawn, and what is made
  /// only to be drawn is made here, so that it does not matter which frames are.
  void observe();
  [[nodiscard]] static bool isOf(const std::string& field, const std::string& object);
  void findRead(const scene::Scene& scene);
  void readOthers() const;
  void makeFields(const scene::Scene& scene);
  /// All that are in contact take as many substeps as the one that needs most.
  void keepInStep(const scene::Scene& scene, Setting& setting);
  [[nodiscard]] bool isTouching(std::size_t object) const;
  /// As its object publishes it.
  [[nodiscard]] Field fieldNamed(const std::string& name) const;
  [[nodiscard]] double quantityNamed(const std::string& name, const std::string& quantity) const;
  [[nodiscard]] const Walls& wallsNamed(const std::string& name) const;
  [[nodiscard]] const FluidWind& windNamed(const std::string& name) const;
  [[nodiscard]] SkinnedSurface& skinNamed(const std::string& name) const;
};

}  // namespace simreel::sim
