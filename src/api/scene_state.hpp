#pragma once
#include "api/device_state.hpp"
#include "api/simreel/scene.hpp"
#include "draw/screen/readback.hpp"
#include "draw/screen/renderer.hpp"
#include "frame/file/world_state.hpp"
#include "frame/summaries.hpp"
#include "scene/scene.hpp"
#include "scene/scene_input.hpp"
#include "sim/core/state_layout.hpp"
#include "sim/world/world.hpp"

#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel {

struct Snapshot::State {
  std::string simulation;  ///< hash of the scene values on which the state depends
  frame::WorldState world;
  bool changed = false;  ///< true if write() has changed the state
};

/// A scene on the device. The constructor, the destructor and begin() run on the thread of the caller that
/// owns the scene; all other functions run on the device's thread.
struct Scene::State {
  /// Stores the source of the scene.
  State(std::shared_ptr<Device::State> on, scene::SceneInput source, bool keepsMotion);
  ~State();
  /// Reads the scene and creates its world. Must be called on the calling thread of the library.
  void begin();
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void restart();
  void advanceTo(int frame);
  /// Completes the current frame and waits for its state hash. Throws if a simulation lost its state. Later
  /// calls throw the same error until restart() or restore().
  void complete();
  /// Throws the error that ended the state. Does nothing if the scene has a state.
  void requireState() const;
  [[nodiscard]] std::size_t indexOf(std::string_view object) const;
  [[nodiscard]] sim::StateArray arrayOf(std::string_view object, std::string_view array) const;
  /// A state array: its description, and its layout in its buffer.
  struct Described {
    ArrayInfo info;
    sim::StateLayout layout;
  };
  /// Describes all state arrays. They are the same in all frames, so they are described once.
  [[nodiscard]] const std::vector<Described>& arrays();
  [[nodiscard]] Array read(std::string_view object, std::string_view array);
  [[nodiscard]] std::optional<DeviceArray> readOnDevice(std::string_view object, std::string_view array,
                                                        std::string_view member);
  /// Replaces a state array. `type`: type of the values; nullopt: they are structures.
  void write(std::string_view object, std::string_view array, std::span<const std::byte> values,
             std::optional<NumberType> type);
  [[nodiscard]] Picture picture();
  [[nodiscard]] draw::PictureLayers layers(const std::vector<draw::Layer>& wanted);
  void restore(const Snapshot::State& from);
  [[nodiscard]] std::string simulationHash() const;

  std::shared_ptr<Device::State> device;
  scene::SceneInput input;  ///< source of the scene, from which it can be read again
  bool motion = false;      ///< as LoadOptions::motion
  std::unique_ptr<scene::Scene> scene;
  std::unique_ptr<sim::World> world;
  std::unique_ptr<frame::Summaries> summaries;
  std::string stateHash;
  bool seen = true;      ///< false if the current frame was stepped without being prepared for drawing
                         ///< (World::advanceUndrawn), so that complete() must finish it
  bool changed = false;  ///< true if write() has changed the state
  std::vector<std::string> layerObjects;

 private:
  void makeWorld();
  void buildWorld();
  void stepTo(int frame);
  /// Runs work that changes the state or waits for it. If the state is lost, stores the error.
  template <class Work>
  void keepLoss(const Work& work);
  [[nodiscard]] Described describe(std::size_t object, const sim::StateArray& array,
                                   const sim::StateLayout* own) const;
  [[nodiscard]] const Described& describedArray(std::string_view object, std::string_view array);
  void follow();
  void placeCamera();
  void makeRenderer();
  void makeLayerRenderer();
  void requireMotion(const draw::Renderer& renderer, const char* what) const;

  std::vector<Described> arrays_;  ///< empty: not described yet
  /// Error that ended the state, until restart() or restore(). Null: the scene has a state.
  std::exception_ptr loss_;
  bool placed_ = false;
  std::unique_ptr<draw::Renderer> renderer_, layerRenderer_;
  std::unique_ptr<draw::Readback> readback_;
  std::optional<int> movedTo_;  ///< frame for which the renderers have the preceding frame, for motion
};

}  // namespace simreel
