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

/// Information about the scene that a simulation is given.
struct Setting {
  bool fast = false;  ///< Fast numerics: GLSL built-ins and contraction (fused multiply-add) are allowed.
  int seed = 1;
  double frameSeconds = 1.0 / 60.0;
  const std::vector<ColliderShape>* colliders = nullptr;
  bool timing = false;  ///< True if simulations measure the times of their stages.
  /// Access to the outlets of the objects created before this one, and later of all objects. Null for a
  /// simulation without a scene.
  const Links* links = nullptr;
  double startTime =
      0;  ///< Scene time of the initial state in seconds: minus the duration simulated before frame 0.
  /// Progress callback for the steps before the first frame; may throw to stop them. May be empty.
  std::function<void(long done, long total)> presteps = {};
  float aspect = 16.0F / 9;  ///< Width of the picture divided by its height.

  /// Returns the result of Links::get; null if the setting has no links.
  template <class T>
  [[nodiscard]] T* find(std::string_view object = {}) const {
    return links == nullptr ? nullptr : links->get<T>(object);
  }
  /// Returns the result of Links::of; null if `object` is empty.
  template <class T>
  [[nodiscard]] T* wanted(std::string_view object) const {
    return object.empty() ? nullptr : &links->of<T>(object);
  }
  template <class T>
  [[nodiscard]] Together together() const {
    return links == nullptr ? Together{} : links->together(T::port);
  }
};

/// Counts per step of a simulation, for the table written beside the frames.
struct CountTable {
  std::vector<const char*> columns;   ///< Column names, at most four per element.
  const gl::Buffer* steps = nullptr;  ///< `elements` uvec4 values per row, one row per step or per frame;
                                      ///< the capacity is all rows of a frame.
  int rows = 0;  ///< Number of rows in use; before the first step one row, the initial counts.
  int elements = 1;
  bool measured = false;  ///< True if the values are floats instead of counts.
};

/// State exported as a table for other programs: one row per point, read back from the GPU.
struct PointTable {
  std::vector<const char*> columns;  ///< Column names as in point files: "x", "y", "z", "vx", ...
  std::vector<float> values;         ///< Table values in row-major order.
};

/// Surface mesh exported for other programs, read back from the GPU if it is there. Positions are in metres
/// with the object's position, rotation and scale applied; `uvs` is empty if the mesh has none, and v = 0
/// is the top row of a picture.
struct MeshTable {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> uvs;
  std::vector<unsigned> indices;  ///< Triangle indices, three per triangle.
  bool doubleSided = false;       ///< True if back faces are visible.
};

/// Room of a cave: open cells connected over their edges, before corridors connect it to other rooms.
struct Room {
  glm::dvec2 centre{
      0};  ///< Mean position of the room's cells, in the cell coordinates of ContourLines; may lie in rock.
  long cells = 0;
  double area = 0;  ///< Floor area of the room in m^2.
};

/// Closed contour lines that separate cells below a level of a field from the rest. In cell coordinates,
/// cell (x, y) is at (x, y) and y points down. Point i is followed by point `next[i]`; as the picture shows
/// it, high ground lies to the left of the line's direction.
struct ContourLines {
  std::vector<glm::vec2> points;
  std::vector<unsigned> next;
  std::vector<int> levels;      ///< Level index of each point, starting at 1.
  glm::ivec2 size{0, 0};        ///< Size of the field in cells.
  std::vector<glm::vec2> path;  ///< Path through the field, if one was found.
  std::vector<Room> rooms;      ///< Rooms, ordered by their lowest cell index.
};

/// State exported in a file format specific to this kind of simulation.
struct StateFile {
  const char* suffix = nullptr;  ///< File name suffix, such as "rle"; null if there is no such format.
  /// Reads back the state and returns the file's text. `comment`: lines to include if the format supports
  /// comments.
  std::function<std::string(const std::string& comment)> text = {};
};

/// Callback after each step of a frame, counted from 1, while state() holds the result of that step. May be
/// empty.
using StepWatch = std::function<void(int step)>;

/// Base class of simulations: owns its state on the GPU and publishes drawables, but does not draw.
class Simulation {
 public:
  virtual ~Simulation() = default;
  /// Provides the outlets offered by the object's parameters (ObjectParameters::ports).
  virtual void connect(Outlets& /*outlets*/) {}
  /// Advances by one frame: from `time` to `time + frameSeconds` (seconds of scene time).
  virtual void step(double time, const StepWatch& watch) = 0;
  /// Advances by one frame that is not shown. Afterwards only the data that later frames depend on
  /// (carryOver) is valid; resumed() or the next step makes the rest valid.
  virtual void pass(double time) { step(time, {}); }
  /// Visits the data that the next frame depends on beyond scene and time, for saving or restoring.
  virtual void carryOver(CarryOver& /*carry*/) {}
  /// Rebuilds the derived state at `time` after carryOver() restored data or after pass().
  virtual void resumed(double /*time*/) {}
  /// Returns the number of steps per frame, and so of StepWatch calls.
  [[nodiscard]] virtual int stepsPerFrame() const { return 1; }
  /// Returns the name of an element of a state array in messages to the user.
  [[nodiscard]] virtual std::string elementName(long element) const {
    return "element " + std::to_string(element);
  }
  /// Returns the object's centre at `time`, or nothing if it has none. The default is the mean of its
  /// points or of its surface's vertices, read back and summed in double in a fixed order.
  [[nodiscard]] virtual std::optional<glm::vec3> middle(double time) const;
  /// Returns the time (seconds) of the last jump along the keyframes, at or before `time`
  /// (scene::Animated::jumpedBy). Motion must not be interpolated across a jump.
  [[nodiscard]] virtual double jumpedBy(double /*time*/) const {
    return -std::numeric_limits<double>::infinity();
  }
  /// Appends the drawables of the state at `time`.
  virtual void publish(double time, Drawables& drawables) const = 0;
  /// Called after the published drawables are drawn, before the next step. Returns true if they ran out of
  /// memory; the memory is then enlarged, and the drawables must be published and drawn again. May wait for
  /// GPU counters.
  virtual bool grow() { return false; }
  /// Returns the state arrays in a fixed order; empty for objects without state.
  [[nodiscard]] virtual std::vector<StateArray> state() const { return {}; }
  /// Returns the points that `simreel bake` writes; empty for objects without points.
  [[nodiscard]] virtual PointTable points() const { return {}; }
  /// Returns the file that `simreel bake` writes for objects with a format of their own.
  [[nodiscard]] virtual StateFile stateFile() const { return {}; }
  /// Returns the counts per step; no columns if the object counts nothing.
  [[nodiscard]] virtual CountTable counts() const { return {}; }
  /// Returns the mesh that `simreel bake` writes, or nothing if the object is no surface. If the object
  /// also has as many points() as the mesh has vertices, they are these vertices in the same order; else
  /// they are something else that it draws.
  [[nodiscard]] virtual std::optional<MeshTable> mesh() const { return std::nullopt; }
  /// Returns the contours that `simreel bake` writes; empty for objects without contours. Call after
  /// grow().
  [[nodiscard]] virtual std::optional<ContourLines> lines() const { return std::nullopt; }
  /// Returns the buffer with the four status words written by glsl/common/status.glsl, or null.
  [[nodiscard]] virtual const gl::Buffer* status() const { return nullptr; }
  /// Returns the values of the parameters' quantities() for the current state, in that order. Reads back
  /// the state and sums on the CPU in double in a fixed order, so equal states give equal numbers. Waits
  /// for the GPU.
  [[nodiscard]] virtual std::vector<double> measure() const { return {}; }
  /// Returns the stage times of `step` for `simreel bench`: names (the same in every frame) and
  /// milliseconds of the latest measured frame. Empty unless Setting::timing is on. Measures CPU stages by
  /// the clock and GPU stages by timer queries. Never waits for the device.
  [[nodiscard]] virtual std::vector<std::pair<const char*, double>> stageTimes() const { return {}; }
  /// Returns a one-line remark to print once if the third word of status() is not 0. `frame`: index of the
  /// frame in which the word was first seen.
  [[nodiscard]] virtual std::string remark(int /*frame*/) const { return {}; }
  /// Returns one line for the user: where and why the state was lost, and what to change.
  [[nodiscard]] virtual std::string explainLoss(unsigned step, unsigned element) const {
    return "step " + std::to_string(step) + ", element " + std::to_string(element);
  }
};

/// Entry of the list of simulation kinds.
struct SimulationKind {
  scene::Kind kind;
  /// Reads the object's files and throws the UserError that `make` would throw on any device; may be empty.
  /// Needs no OpenGL context. The setting's links provide only the outlets of the scene itself.
  std::function<void(const scene::Object&, const Setting&)> check;
  std::function<std::unique_ptr<Simulation>(const scene::Object&, const Setting&)> make;
};

}  // namespace simreel::sim
