#pragma once
#include "gl/buffer.hpp"
#include "scene/scene.hpp"
#include "sim/core/carry_over.hpp"
#include "sim/core/collider.hpp"
#include "sim/core/drawable.hpp"
#include "sim/core/port.hpp"
#include "sim/core/state_array.hpp"

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// What a simulation may know of the scene around it.
struct Setting {
  bool fast = false;  ///< numerics: built-ins and contraction allowed
  int seed = 1;
  double frameSeconds = 1.0 / 60.0;
  const std::vector<ColliderShape>* colliders = nullptr;
  bool timing = false;  ///< whether simulations measure their stages
  /// Outlets of the objects that are made before this one, and later of all; null: it stands alone.
  const Links* links = nullptr;
  double startTime = 0;  ///< s of scene time of the first state: minus what is simulated before frame 0
  /// Hears how many of its steps before the first frame an object has done; may throw to end them. Empty:
  /// nobody listens.
  std::function<void(long done, long total)> presteps = {};

  /// As Links::get; null without links.
  template <class T>
  [[nodiscard]] T* find(std::string_view object = {}) const {
    return links == nullptr ? nullptr : links->get<T>(object);
  }
  /// As Links::of; null where `object` is empty.
  template <class T>
  [[nodiscard]] T* wanted(std::string_view object) const {
    return object.empty() ? nullptr : &links->of<T>(object);
  }
  template <class T>
  [[nodiscard]] Together together() const {
    return links == nullptr ? Together{} : links->together(T::port);
  }
};

/// What a simulation counts in each step: for a table beside the frames.
struct CountTable {
  std::vector<const char*> columns;  ///< at most four for each element
  const gl::Buffer* steps =
      nullptr;   ///< `elements` uvec4 a row: of a step, or the frame; room for all rows of a frame
  int rows = 0;  ///< of them in use; before the first step one: the counts of the start
  int elements = 1;
  bool measured = false;  ///< floats, not counts
};

/// The state as a table for other programs: a row for each point, read back from the GPU.
struct PointTable {
  std::vector<const char*> columns;  ///< "x", "y", "z", "vx", ... as point files call them
  std::vector<float> values;         ///< row by row
};

/// A surface as a table for other programs, read back from the GPU where it is there: metres, the object's
/// own position, rotation and scale applied; uvs are empty where the mesh has none, and v
/// counts from a picture's first row.
struct MeshTable {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> uvs;
  std::vector<unsigned> indices;  ///< three a triangle
  bool doubleSided = false;       ///< whether its backs are to be seen
};

/// A room of a cave: open cells that are joined over edges, before corridors join it to others.
struct Room {
  glm::dvec2 centre{0};  ///< mean place of its cells, in cells as contours have them; may lie in rock
  long cells = 0;
  double area = 0;  ///< m^2
};

/// Closed lines between what is below a level of a field and what is not, in cells: cell (x, y) of the
/// field is at (x, y). Point i is followed by `next[i]`; y grows down the picture, and high ground lies to
/// the left of the way as the picture shows it.
struct ContourLines {
  std::vector<glm::vec2> points;
  std::vector<unsigned> next;
  std::vector<int> levels;      ///< of each point, from 1
  glm::ivec2 size{0, 0};        ///< of the field, cells
  std::vector<glm::vec2> path;  ///< a way through, where one was found
  std::vector<Room> rooms;      ///< by their lowest cell
};

/// The state as a file that programs for its kind of simulation exchange.
struct StateFile {
  const char* suffix = nullptr;  ///< "rle"; null: there is none
  /// Reads the state back and writes the file's text; `comment`: lines for it where the format has room.
  std::function<std::string(const std::string& comment)> text = {};
};

/// Called after each step of a frame, counted from 1, while state() holds what that step left. Empty:
/// nobody watches.
using StepWatch = std::function<void(int step)>;

/// Owns its state on the GPU and publishes drawables. It never draws.
class Simulation {
 public:
  virtual ~Simulation() = default;
  /// Provides the outlets of what its parameters offer (ObjectParameters::ports).
  virtual void connect(Outlets& /*outlets*/) {}
  /// Advances by one frame: from `time` to `time + frameSeconds` (s of scene time).
  virtual void step(double time, const StepWatch& watch) = 0;
  /// The same for a frame at which nobody looks: only what later frames depend on (carryOver) has to be
  /// right afterwards, until resumed() or a step makes the rest.
  virtual void pass(double time) { step(time, {}); }
  /// Names what the next frame depends on beyond scene and time, to be read or put back.
  virtual void carryOver(CarryOver& /*carry*/) {}
  /// After it was put back, or frames were passed: makes what else belongs to the state at `time`.
  virtual void resumed(double /*time*/) {}
  /// Steps that a frame takes: the calls of a watch.
  [[nodiscard]] virtual int stepsPerFrame() const { return 1; }
  /// What a user would call an element of a state array.
  [[nodiscard]] virtual std::string elementName(long element) const {
    return "element " + std::to_string(element);
  }
  /// The middle of it at `time`: here that of its points, or of its surface's vertices, which are read
  /// back, in double and in their order. Nothing for things that have none.
  [[nodiscard]] virtual std::optional<glm::vec3> middle(double time) const;
  /// When (s) it last jumped along its keyframes, at `time` or before (scene::Animated::jumpedBy): what is
  /// between two frames there does not go from one place to the other.
  [[nodiscard]] virtual double jumpedBy(double /*time*/) const {
    return -std::numeric_limits<double>::infinity();
  }
  /// Appends what is to be drawn of the state at `time`.
  virtual void publish(double time, Drawables& drawables) const = 0;
  /// After what was published was drawn, before the next step: whether that lacked memory, which is there
  /// now, so that it is to be published and drawn again. May wait for the GPU to have counted what there
  /// is.
  virtual bool grow() { return false; }
  /// State arrays in a fixed order; empty for things without state.
  [[nodiscard]] virtual std::vector<StateArray> state() const { return {}; }
  /// What `simreel bake` writes; empty for things that are no points.
  [[nodiscard]] virtual PointTable points() const { return {}; }
  /// What `simreel bake` writes of things that have a format of their own.
  [[nodiscard]] virtual StateFile stateFile() const { return {}; }
  /// What it counts per step; no columns for things that count nothing.
  [[nodiscard]] virtual CountTable counts() const { return {}; }
  /// What `simreel bake` writes of things that are a surface; nothing for others. Where they are points,
  /// too, these are its vertices, one by one.
  [[nodiscard]] virtual std::optional<MeshTable> mesh() const { return std::nullopt; }
  /// Contours that `simreel bake` writes; empty for objects without contours. Call after grow().
  [[nodiscard]] virtual std::optional<ContourLines> lines() const { return std::nullopt; }
  /// Four words as glsl/common/status.glsl writes them, or null.
  [[nodiscard]] virtual const gl::Buffer* status() const { return nullptr; }
  /// The quantities of its parameters, in that order, of the present state, which is read back: summed up
  /// on the CPU in double and in a fixed order, so equal states give equal numbers. Waits for the GPU.
  [[nodiscard]] virtual std::vector<double> measure() const { return {}; }
  /// How `step` splits, for `simreel bench`: names (the same in every frame) and ms, of the latest frame
  /// that is known, when Setting::timing is on. CPU stages by the clock, those of the GPU by timer queries.
  /// Never waits for the device.
  [[nodiscard]] virtual std::vector<std::pair<const char*, double>> stageTimes() const { return {}; }
  /// One line for a user, said once, where the third word of status() is not 0; `frame`: when that was
  /// seen.
  [[nodiscard]] virtual std::string remark(int /*frame*/) const { return {}; }
  /// One line for a user: where and why the state was lost, and what to change.
  [[nodiscard]] virtual std::string explainLoss(unsigned step, unsigned element) const {
    return "step " + std::to_string(step) + ", element " + std::to_string(element);
  }
};

/// One entry of the list of simulations.
struct SimulationKind {
  scene::Kind kind;
  /// Reads the files of the object and throws the UserError that `make` would throw on any device; empty
  /// where there is none. Needs no context; the links of the setting have the scene's own outlets only.
  std::function<void(const scene::Object&, const Setting&)> check;
  std::function<std::unique_ptr<Simulation>(const scene::Object&, const Setting&)> make;
};

}  // namespace simreel::sim
