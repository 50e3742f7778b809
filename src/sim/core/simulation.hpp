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

/// Information about the scene that a simulation gets when it is created.
struct Setting {
  bool fast = false;  ///< Fast numerics: GLSL built-ins and contraction (fused multiply-add) are allowed.
  int seed = 1;
  double frameSeconds = 1.0 / 60.0;
  const std::vector<ColliderShape>* colliders = nullptr;
  bool timing = false;  ///< True if simulations measure the times of their stages.
  /// Access to the outlets of other objects. In the constructor, only the outlets of objects created
  /// earlier are available; later, all are. Null if the simulation is not part of a scene.
  const Links* links = nullptr;
  double startTime = 0;  ///< Scene time of the initial state in seconds: 0, or minus the duration simulated
                         ///< before frame 0.
  /// Progress callback for the steps before the first frame; may be empty. The callback may throw to stop
  /// these steps.
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
  [[nodiscard]] GroupState together() const {
    return links == nullptr ? GroupState{} : links->together(T::port);
  }
};

/// Counts of a simulation per step, for the table written next to the frame images.
struct CountTable {
  std::vector<const char*> columns;   ///< Column names, at most four per element.
  const gl::Buffer* steps = nullptr;  ///< Rows of `elements` uvec4 values, one row per step or per frame.
                                      ///< The buffer holds all rows of one frame.
  int rows = 0;  ///< Number of rows in use; before the first step there is one row with the initial counts.
  int elements = 1;
  bool measured = false;  ///< True if the values are floats instead of counts.
};

/// State exported as a table for other programs: one row per point, read back from the GPU.
struct PointTable {
  std::vector<const char*> columns;  ///< Column names as in point files: "x", "y", "z", "vx", ...
  std::vector<float> values;         ///< Table values in row-major order.
};

/// Surface mesh exported for other programs, read back from the GPU if it is stored there. Positions are in
/// metres in world space. `uvs` is empty if the mesh has none; v = 0 is the top row of an image.
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

/// Closed contour lines around the regions of a field that are below a level. In cell coordinates, the
/// centre of cell (x, y) is at (x, y), and y points down. Point i is followed by point `next[i]`. In the
/// picture, the side above the level is to the left of the line's direction.
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
  /// Advances by one frame that is not drawn. Afterwards only the data that later frames depend on
  /// (visitCheckpointData) is valid; resumed() or the next step makes the remaining data valid.
  virtual void pass(double time) { step(time, {}); }
  /// Visits the data that the next frame depends on and that scene and time do not determine, to save or
  /// restore it.
  virtual void visitCheckpointData(CarryOver& /*carry*/) {}
  /// Rebuilds the derived state at `time` after visitCheckpointData() restored data or after pass().
  virtual void resumed(double /*time*/) {}
  /// Returns the number of steps per frame, which is also the number of StepWatch calls per frame.
  [[nodiscard]] virtual int stepsPerFrame() const { return 1; }
  /// Returns the name of one element of a state array, for messages.
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
  /// Appends the drawables that show the state at `time`.
  virtual void publish(double time, Drawables& drawables) const = 0;
  /// Called after the published drawables are drawn, before the next step. Returns true if the drawing
  /// needed more memory than was allocated. The memory is then enlarged, and the drawables must be
  /// published and drawn again. May wait for GPU counters.
  virtual bool grow() { return false; }
  /// Returns the state arrays in a fixed order; empty for objects without state.
  [[nodiscard]] virtual std::vector<StateArray> state() const { return {}; }
  /// Returns the points that `simreel bake` writes; empty for objects without points.
  [[nodiscard]] virtual PointTable points() const { return {}; }
  /// Returns the file that `simreel bake` writes for a kind of object with its own file format.
  [[nodiscard]] virtual StateFile stateFile() const { return {}; }
  /// Returns the counts per step. The table has no columns if the object counts nothing.
  [[nodiscard]] virtual CountTable counts() const { return {}; }
  /// Returns the mesh that `simreel bake` writes, or nothing if the object is not a surface. If points()
  /// has as many points as the mesh has vertices, they are the vertices in the same order; otherwise the
  /// points are a separate part of the object.
  [[nodiscard]] virtual std::optional<MeshTable> mesh() const { return std::nullopt; }
  /// Returns the contours that `simreel bake` writes; empty for objects without contours. Call after
  /// grow().
  [[nodiscard]] virtual std::optional<ContourLines> lines() const { return std::nullopt; }
  /// Returns the buffer with the four status words written by glsl/common/status.glsl, or null.
  [[nodiscard]] virtual const gl::Buffer* status() const { return nullptr; }
  /// Returns the values of the parameters' quantities() for the current state, in the order of
  /// quantities(). Reads back the state and sums on the CPU in double in a fixed order, so equal states
  /// give equal numbers. Waits for the GPU.
  [[nodiscard]] virtual std::vector<double> measure() const { return {}; }
  /// Returns the stage times of `step` for `simreel bench`: the stage names (the same in every frame) and
  /// the milliseconds in the latest measured frame. Empty unless Setting::timing is true. CPU stages are
  /// measured by the clock, GPU stages by timer queries. Never waits for the device.
  [[nodiscard]] virtual std::vector<std::pair<const char*, double>> stageTimes() const { return {}; }
  /// Returns a one-line remark that is printed once if the third word of status() is not 0. `frame` is the
  /// index of the frame in which a nonzero word was first read.
  [[nodiscard]] virtual std::string remark(int /*frame*/) const { return {}; }
  /// Returns one line for the user that says where and why the state was lost, and which parameters to
  /// change.
  [[nodiscard]] virtual std::string explainLoss(unsigned step, unsigned element) const {
    return "step " + std::to_string(step) + ", element " + std::to_string(element);
  }
};

/// Entry of the list of simulation kinds.
struct SimulationKind {
  scene::Kind kind;
  /// Reads the object's files and throws the UserError that `make` would throw on any device; may be empty.
  /// Needs no OpenGL context. The setting's links give access only to the outlets of the scene itself.
  std::function<void(const scene::Object&, const Setting&)> check;
  std::function<std::unique_ptr<Simulation>(const scene::Object&, const Setting&)> make;
};

}  // namespace simreel::sim
