#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/carry_over.hpp"
#include "sim/core/drawable.hpp"
#include "sim/tubes/tubes.hpp"

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Parameters of the trails that particles draw.
struct TrailParameters {
  int frames = 30;      ///< number of earlier frames in a trail
  float width = 0.02F;  ///< diameter in metres at the particle
  int every = 1;        ///< draws the trail of every n-th particle
  float fade = 0.8F;    ///< fraction by which the colour is darker at the end

  void describe(scene::Fields& fields);
};

/// Largest number of points of all trails of one object.
inline constexpr int mostTrailPoints = 1 << 18;

/// Inputs of glsl/particles/trails/record.comp.
struct RecordTrail {
  static constexpr auto file = "particles/trails/record.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"every", int> every;
  gl::Uniform<"room", int> room;
  gl::Uniform<"slot", int> slot;
  gl::In<"positions"> positions;
  gl::In<"velocities"> velocities;
  gl::Out<"history"> history;
};

/// Inputs of glsl/particles/trails/gather.comp.
struct GatherTrail {
  static constexpr auto file = "particles/trails/gather.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"every", int> every;
  gl::Uniform<"room", int> room;
  gl::Uniform<"slot", int> slot;
  gl::Uniform<"recorded", int> recorded;
  gl::Uniform<"colorBy", int> colorBy;
  gl::Uniform<"low", float> low;
  gl::Uniform<"perRange", float> perRange;
  gl::In<"positions"> positions;
  gl::In<"velocities"> velocities;
  gl::In<"history"> history;
  gl::Out<"points"> points;
  gl::Out<"SpanBlock"> spans;
};

/// Trails of particles: tubes through the places of the latest frames.
class ParticleTrails {
 public:
  /// `look`: colours of the particles. Throws UserError(usage) for too many points.
  ParticleTrails(const std::string& name, const TrailParameters& parameters, int particles,
                 const Instances& look, const scene::Material& material, bool fast);

  /// Adds the places of a finished frame.
  void record(const gl::Vec4Array& positions, const gl::Vec4Array& velocities);
  /// Makes the tubes of the present frame and returns them; the pointers are valid as long as this object.
  [[nodiscard]] Surface surface(const gl::Vec4Array& positions, const gl::Vec4Array& velocities);
  void carryOver(CarryOver& carry);
  /// Reads the tubes back, as surface() made them last.
  [[nodiscard]] MeshTable table() const { return tubes_.table(); }

 private:
  TrailParameters parameters_;
  scene::Material material_;
  Instances::ColorBy colorBy_;
  glm::vec2 range_;
  int count_ = 0, room_ = 0;
  int slot_ = -1;          ///< slot of the latest frame in history_
  int recorded_ = 0;       ///< number of frames in history_
  bool made_ = false;      ///< true if the tubes show the latest frame
  gl::Vec4Array history_;  ///< per trail a ring of frames: x, y, z: place in metres; w: age
  gl::Vec4Array points_;
  gl::Buffer spans_;
  Tubes tubes_;
  gl::Kernel<RecordTrail> record_;
  gl::Kernel<GatherTrail> gather_;
};

}  // namespace simreel::sim
