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

/// Moments between two frames: vertices and instances go straight from where they were to where they are,
/// as of two motion steps of a path tracer. What jumped along its keyframes meanwhile stays where it was
/// until then, and stands where it is from then on. Surfaces whose triangles the GPU makes anew (those with
/// `arguments`), fields and charts stay as they are.
class Motion {
 public:
  /// `fast`: built-in arithmetic.
  explicit Motion(bool fast);

  /// What was drawn, or would have been, of the frame before.
  void keep(const sim::Drawables& before);
  /// What is drawn of the frame at time `at` (s), `seconds` after that one. Its pointers have to live as
  /// long as between() is asked.
  void begin(const sim::Drawables& now, double seconds, double at = 0);
  /// At a part of the way, 0 at the frame before and 1 at this one; lives until the next call. Things that
  /// were not there before are as they are.
  [[nodiscard]] const sim::Drawables& between(float part);

  /// Where the vertices of a surface were and are, in the world (m): xyz. Empty for what does not move, and
  /// for what jumped.
  struct Way {
    std::vector<glm::vec4> before, now;
  };
  /// Of surface i of the frame; after begin(). Waits for the device, as the next one does.
  [[nodiscard]] Way wayOf(std::size_t surface) const;
  /// Velocities of instances i of the frame: xyz in m/s.
  [[nodiscard]] std::vector<glm::vec4> velocitiesOf(std::size_t instances);
  /// What a camera asks of drawables (draw::viewAt), at another part of the way between the frames: -0.5 is
  /// as long before the frame before.
  [[nodiscard]] sim::Drawables cameraAt(float part) const;

 private:
  /// Two vec4 an element: places and normals, or places and velocities.
  struct Elements {
    gl::Buffer first, second;
    gl::Texture firstView, secondView;
    void makeRoom(int count);
  };
  struct Moving {
    std::string object;
    int count = 0;  ///< of elements; 0: it does not move
    int indices = 0;
    unsigned still = 0;
    glm::mat4 model{1.0F};
    bool moves = false;              ///< between the two frames, as far as the CPU knows
    double jumped = 0;               ///< s: when its object did last
    std::optional<float> jump = {};  ///< the part of the way at which it jumps in between
    Elements before, now, shown;
  };

  /// The part of the way at which what jumped last at these times (s) does so between the frames.
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
  std::vector<sim::Place> places_;  ///< of the frame before, and the next
  std::vector<glm::vec3> lagging_;
  Elements copied_;                            ///< instances whose velocities are asked for
  const sim::Drawables* drawables_ = nullptr;  ///< of the frame
  sim::Drawables shown_;
};

}  // namespace simreel::draw
