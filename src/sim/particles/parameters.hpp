#pragma once
#include "glsl/common/cpp.hpp"
#include "scene/falling.hpp"
#include "scene/own_colors.hpp"
#include "scene/value/fields.hpp"
#include "scene/warm.hpp"
#include "sim/collide/mesh_colliders.hpp"
#include "sim/core/auto_range.hpp"
#include "sim/core/drawable.hpp"
#include "sim/core/kind.hpp"
#include "sim/particles/trails.hpp"
#include "sim/ports/color_scale.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::shader {
#include "glsl/particles/types.glsl"
}

namespace simreel::sim {

/// Cloud of particles that exists from the start of the run.
struct ParticleGroup {
  enum class Shape { ball, cube, plummer, disk, file };
  Shape shape = Shape::ball;
  int count = 1024;     ///< number of particles; ignored for a file
  float radius = 1.0F;  ///< radius of the ball, half the cube's side, Plummer scale radius a, or the disk's
                        ///< scale length, in metres
  float thickness = 0.05F;     ///< scale height of a disk as a fraction of `radius`
  float totalMass = 1.0F;      ///< total mass in kg; each particle gets an equal part of it
  float centralMass = 0.0F;    ///< mass in kg of an additional particle in the centre (a disk's bulge); 0
                               ///< for none
  float speed = 0.0F;          ///< magnitude in m/s of a random velocity in a ball or cube; a Plummer
                               ///< sphere or disk starts in equilibrium
  float spin = 0.0F;           ///< angular velocity in rad/s about the group's local y axis, for a ball or
                               ///< cube
  glm::vec3 position{0};       ///< centre in metres
  glm::vec3 velocity{0};       ///< velocity of the whole group in m/s
  glm::vec3 rotation{0};       ///< rotation in degrees about x, then y, then z; without rotation, disks are
                               ///< in the xz plane
  std::filesystem::path file;  ///< CSV file (first line names x,y,z[,vx,vy,vz][,mass]) or PLY file
  void describe(scene::Fields& fields);
};

/// Source of particles with a limited lifetime.
struct Emitter : shader::EmitterConstants {
  float rate = 1000.0F;                                      ///< number of particles per second
  scene::Animated<glm::vec3> position = glm::vec3(0);        ///< position in metres
  scene::Animated<glm::vec3> velocity = glm::vec3(0, 3, 0);  ///< mean initial velocity in m/s
  float spread = 20.0F;                                      ///< half the angle of the velocity cone in
                                                             ///< degrees
  float from = 0.0F, until = 1e9F;                           ///< times in seconds at which the emitter
                                                             ///< starts and stops
  void describe(scene::Fields& fields);
};

/// Curl noise: a divergence-free velocity field.
struct Turbulence : shader::TurbulenceConstants {
  float size = 1.0F;   ///< size of the swirls in metres
  float speed = 0.3F;  ///< speed in m/s at which the field drifts
};

/// Heavy body that moves along keyframes and attracts the particles.
struct Attractor {
  scene::Animated<glm::vec3> position = glm::vec3(0);  ///< position in metres
  scene::Animated<float> mass = 100.0F;                ///< mass in kg
};

/// Wind that carries the particles along.
struct ParticleWind {
  std::string fluid;  ///< name of the fluid whose flow is the wind
  float drag = 4;     ///< rate in 1/s at which the velocity approaches the wind's velocity
};

/// Contact of particles with each other, as balls.
struct BallParameters {
  float radius = 0.0F;  ///< radius in metres; if 0, half of the drawn size
  float friction = 0.4F;
  float restitution = 0.3F;
  bool rolls = false;  ///< true if balls turn
  void describe(scene::Fields& fields);
};

/// Radius in metres with which a particle is drawn, by its mass. Of a mesh, half of the factor on its
/// coordinates.
struct ShownRadius {
  float radius;     ///< radius of a particle of the reference mass
  float exponent;   ///< power of the mass with which the radius grows
  float reference;  ///< reference mass in kg
  [[nodiscard]] float of(float mass) const;
  /// Returns the difference to the radius of the reference mass, or 0 for smaller particles.
  [[nodiscard]] float beyond(float mass) const;
};

enum class GravityMethod { none, allPairs, tree };  ///< named "none", "all-pairs" and "tree" in scenes

struct ParticleParameters : ObjectParameters,
                            HasColorRange,
                            ShowsQuantity,
                            TouchesMeshes,
                            scene::HasWarmUp,
                            scene::HasOwnColors,
                            scene::Falling,
                            shader::ParticleConstants {
  std::vector<ParticleGroup> groups;
  std::vector<Emitter> emitters;
  GravityMethod method = GravityMethod::allPairs;
  float gravity = 0.01F;   ///< gravitational constant G in m^3/(kg s^2)
  float softening = 0.1F;  ///< softening length eps in metres
  float opening = 0.5F;    ///< for "tree": maximum angle (rad) under which a cell counts as one body
  std::optional<Attractor> attractor;
  scene::Animated<glm::vec3> acceleration = glm::vec3(0);  ///< uniform acceleration in m/s^2
  Turbulence turbulence;
  int substeps = 1;           ///< number of substeps per frame; ignored if `autoSubsteps` is true
  bool autoSubsteps = false;  ///< true if the number of substeps is the number that the contact of balls
                              ///< needs
  std::optional<BallParameters> contact;
  bool collides = false;
  std::optional<ParticleWind> wind;
  std::string walls;           ///< name of the solid whose walls the particles collide with; empty if none
  std::string cloths = "all";  ///< cloths in contact to collide with: "all", "none", or a name

  std::optional<TrailParameters> trails;

  // Appearance of the particles.
  Instances::Shape shape = Instances::Shape::sprite;
  std::filesystem::path mesh;
  bool alongVelocity = false;
  float size = 0.05F;
  float massExponent = 0.0F;
  Instances::ColorBy colorBy = Instances::ColorBy::material;
  glm::vec2 colorRange{0, 1};
  AutoEnds autoColors;            ///< states which ends of `colorRange` a first run measures
  std::vector<glm::vec3> colors;  ///< linear RGB stops of the colour map
  bool additive = false;
  float brightness = 1.0F;
  float fade = 0.1F;

  void describe(scene::Fields& fields) override;
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  /// Returns the height in metres of the lowest point of all emitters whose particles do not all fall. The
  /// result is infinity if the particles of all emitters fall, so that only other objects determine the
  /// ground. It is empty if there are no emitters.
  [[nodiscard]] std::optional<float> supportHeight() const override;
  [[nodiscard]] double fallsTo(double seconds, double ground) const override;
  [[nodiscard]] Looks looks() const override { return additive ? Looks::shining : Looks::solid; }
  [[nodiscard]] bool motionIsUnpredictable() const override { return true; }
  [[nodiscard]] const char* coloredBy() const override {
    return colorBy == Instances::ColorBy::material ? nullptr : "its \"colorBy\"";
  }
  [[nodiscard]] ShownQuantity shownQuantity() const override;
  /// Returns the longest life of a particle, at most 4 s, if all emitters start at once and there are no
  /// groups; else 0.
  [[nodiscard]] double warmUp() const override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::vector<MeasuredRange> measuredRanges() override;
  [[nodiscard]] std::int64_t minLargestBufferBytes() const override {
    std::int64_t bytes = 0;
    for (const ParticleGroup& group : groups)
      if (group.shape != ParticleGroup::Shape::file) bytes += std::int64_t{16} * group.count;
    return bytes;
  }
  [[nodiscard]] double touchMargin() const override { return collides ? margin : -1; }
  /// Returns the rate in 1/s at which particles lose velocity relative to their surroundings: damping plus
  /// drag of the wind.
  [[nodiscard]] float slowing() const { return damping + (wind ? wind->drag : 0.0F); }
  [[nodiscard]] bool meetsCloths() const { return collides && cloths != "none"; }
  /// Returns the radius in metres of a ball of the reference mass.
  [[nodiscard]] float ballRadius() const {
    return contact && contact->radius > 0 ? contact->radius : 0.5F * size;
  }
  /// Returns the radius with which particles are drawn. May read the file of the first group.
  [[nodiscard]] ShownRadius shownRadius() const;
  /// Returns the number of substeps per frame: `substeps`, or for `autoSubsteps` the number that balls in
  /// contact need.
  [[nodiscard]] int substepsPerFrame(double frameSeconds) const;
  /// Returns a copy with `contactSubsteps` substeps per frame if the particles collide with cloths; 0 keeps
  /// the number of the parameters.
  [[nodiscard]] ParticleParameters withContactSubsteps(int contactSubsteps) const;

 private:
  void describeContact(scene::Fields& fields);
  void remarkForces(scene::Fields& fields) const;
  /// `stars`: true if keys that the scene leaves out get the look of a galaxy.
  void describeLook(scene::Fields& fields, bool stars);
};

}  // namespace simreel::sim
