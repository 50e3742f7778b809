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
  float width = 0.02F;  ///< diameter of the trail at the particle, in metres
  int every = 1;        ///< step between particles that have a trail: 1 for every particle, n for every
                        ///< n-th particle
  float fade = 0.8F;    ///< fraction by which the colour is darkened at the end of the trail

  void describe(scene::Fields& fields);
};

/// Maximum number of points in all trails of one object.
inline constexpr int maxTrailPoints = 1 << 18;

/// Interface of glsl/particles/trails/record.comp.
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

/// Interface of glsl/particles/trails/gather.comp.
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

/// Trails of particles: tubes through the particles' positions in the latest frames.
class ParticleTrails {
 public:
  /// `look` gives the colours of the particles. Throws UserError(usage) for too many points.
  ParticleTrails(const std::string& name, const TrailParameters& parameters, int particles,
                 const Instances& look, const scene::Material& material, bool fast);

  /// Adds the positions of a finished frame.
  void record(const gl::Vec4Array& positions, const gl::Vec4Array& velocities);
  /// Computes the tubes of the current frame and returns them as a surface, whose pointers are valid while
  /// this object exists.
  [[nodiscard]] Surface surface(const gl::Vec4Array& positions, const gl::Vec4Array& velocities);
  void visitCheckpointData(CarryOver& carry);
  /// Reads back the tubes of the last call of surface().
  [[nodiscard]] MeshTable table() const { return tubes_.table(); }

 private:
  TrailParameters parameters_;
  scene::Material material_;
  Instances::ColorBy colorBy_;
  glm::vec2 range_;
  int count_ = 0, room_ = 0;
  int slot_ = -1;          ///< slot of the latest frame in history_
  int recorded_ = 0;       ///< number of frames in history_
  bool made_ = false;      ///< true if the tubes belong to the latest frame
  gl::Vec4Array history_;  ///< for each trail a ring buffer of frames: xyz position in metres; w age
  gl::Vec4Array points_;
  gl::Buffer spans_;
  Tubes tubes_;
  gl::Kernel<RecordTrail> record_;
  gl::Kernel<GatherTrail> gather_;
};

}  // namespace simreel::sim
