#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

namespace simreel::draw {

struct WorldVertexKernel;
struct CopyElements;
struct BetweenVertices;
struct BetweenElements;

/// Interpolates between two frames. Vertices and instances move linearly from their previous to their
/// current positions, like the two motion steps of a path tracer. An object that jumps between keyframes
/// keeps its previous position until the jump and has its current position after it. Surfaces whose
/// triangles the GPU rebuilds (with `arguments`), fields and charts do not move.
class Motion {
 public:
  /// `fast`: uses built-in arithmetic instead of exact arithmetic.
  explicit Motion(bool fast);

  /// Stores the objects of the previous frame, from which motion starts.
  void keep(const sim::Drawables& before);
  /// Sets the objects of the current frame at time `at` (s), `seconds` after the previous frame. Pointers
  /// in `now` must stay valid while between() is used.
  void begin(const sim::Drawables& now, double seconds, double at = 0);
  /// Returns the objects at an interpolation parameter: 0 at the previous frame, 1 at the current one. The
  /// result is valid until the next call. Objects that are new in the current frame do not move.
  [[nodiscard]] const sim::Drawables& between(float part);

  /// Previous and current world positions (m) of a surface's vertices, in xyz. Empty if the surface does
  /// not move or has jumped.
  struct Displacement {
    std::vector<glm::vec4> before, now;
  };
  /// Returns the positions of surface i of the frame. Call after begin(). Waits for the GPU, as
  /// velocitiesOf() does.
  [[nodiscard]] Displacement displacementOf(std::size_t surface) const;
  /// Returns the velocities (xyz, m/s) of instances i of the frame.
  [[nodiscard]] std::vector<glm::vec4> velocitiesOf(std::size_t instances);
  /// Returns the drawables that draw::viewAt() needs for the camera, at any interpolation parameter; -0.5
  /// is half a frame time before the previous frame.
  [[nodiscard]] sim::Drawables cameraAt(float part) const;

 private:
  /// Two vec4 per element: positions and normals, or positions and velocities.
  struct Elements {
    gl::Buffer first, second;
    gl::Texture firstView, secondView;
    void makeRoom(int count);
  };
  struct Moving {
    std::string object;
    int count = 0;  ///< number of elements; 0 if the object does not move
    int indices = 0;
    unsigned still = 0;
    glm::mat4 model{1.0F};
    bool moves = false;              ///< true if the object moves between the two frames, as far as the CPU
                                     ///< can tell
    double lastJumpSeconds = 0;      ///< time (s) at which the object last jumped
    std::optional<float> jump = {};  ///< interpolation parameter of a jump between the two frames, if there
                                     ///< is one
    Elements before, now, shown;
  };

  /// Returns the interpolation parameter at which an object jumps between the two frames, or nothing.
  /// `before` and `now`: times (s) of the object's last jump as known in the previous and in the current
  /// frame.
  [[nodiscard]] std::optional<float> jumpAt(double before, double now) const;
  void toWorld(const sim::Surface& surface, const Elements& into);
  void copy(const sim::Instances& instances, const Elements& into);
  void place(sim::Surface& surface, Moving& moving, float part);
  void place(sim::Instances& instances, Moving& moving, float part);

  double seconds_ = 0, at_ = 0;
  gl::Kernels<WorldVertexKernel> worldVertices_;
  gl::Kernel<CopyElements> copy_;
  gl::Kernel<BetweenVertices> betweenVertices_;
  gl::Kernel<BetweenElements> betweenElements_;
  std::vector<Moving> surfaces_, instances_;
  std::vector<sim::Place> places_;  ///< camera targets in the previous frame; lagging_ holds the targets
                                    ///< that follow with a delay
  std::vector<glm::vec3> dampedCamera_;
  Elements copied_;                            ///< copy of the velocities that velocitiesOf() reads back
  const sim::Drawables* drawables_ = nullptr;  ///< objects of the current frame
  sim::Drawables shown_;
};

}  // namespace simreel::draw
