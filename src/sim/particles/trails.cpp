#include "sim/particles/trails.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cstdint>

namespace simreel::sim {

void TrailParameters::describe(scene::Fields& f) {
  f.integer("frames", frames, {1, 1000}, "frames", "Length: the places of so many earlier frames.");
  f.number("width", width, {1e-6, 1e4}, "m", "Diameter at the particle; a trail narrows to its end.");
  f.integer("every", every, {1, 1 << 24}, "", "Draws the trail of every n-th particle.");
  f.number("fade", fade, scene::fraction, "", "Fraction by which the colour is darker at the end.");
}

ParticleTrails::ParticleTrails(const std::string& name, const TrailParameters& parameters, int particles,
                               const Instances& look, const scene::Material& material, bool fast)
    : parameters_(parameters),
      material_(material),
      colorBy_(look.colorBy),
      range_(look.colorRange),
      count_((particles + parameters.every - 1) / parameters.every),
      room_(parameters.frames + 1),
      record_(gl::kernelDefines(fast)),
      gather_(gl::kernelDefines(fast)) {
  if (const std::int64_t points = std::int64_t{count_} * room_; points > maxTrailPoints)
    fail(ExitCode::usage,
         "particles \"{}\": {} trails of {} points are {}, more than the {} that fit here; lower "
         "\"frames\", or "
         "draw fewer with \"every\": {}",
         name, count_, room_, points, maxTrailPoints,
         (std::int64_t{particles} * room_ + maxTrailPoints - 1) / maxTrailPoints);
  history_ = gl::Vec4Array(name + " history", count_ * room_);
  points_ = gl::Vec4Array(name + " points of trails", count_ * room_);
  spans_ = gl::Buffer(name + " spans of trails", std::size_t{16} * static_cast<std::size_t>(count_));
  const bool mapped = colorBy_ != Instances::ColorBy::material;
  tubes_ = Tubes(name + " trails", count_, room_,
                 mapped ? *look.colors : std::vector<glm::vec3>{glm::vec3(1)}, fast);
  if (mapped) material_.color = glm::vec3(1);
}

void ParticleTrails::record(const gl::Vec4Array& positions, const gl::Vec4Array& velocities) {
  slot_ = (slot_ + 1) % room_;
  recorded_ = std::min(recorded_ + 1, room_);
  made_ = false;
  record_.dispatch(count_, {.count = count_,
                            .every = parameters_.every,
                            .room = room_,
                            .slot = slot_,
                            .positions = positions,
                            .velocities = velocities,
                            .history = history_});
  gl::barrier();
}

Surface ParticleTrails::surface(const gl::Vec4Array& positions, const gl::Vec4Array& velocities) {
  if (!made_) {
    gl::barrier();
    gather_.dispatch(count_, {.count = count_,
                              .every = parameters_.every,
                              .room = room_,
                              .slot = slot_,
                              .recorded = recorded_,
                              .colorBy = static_cast<int>(colorBy_),
                              .low = range_.x,
                              .perRange = 1 / (range_.y - range_.x),
                              .positions = positions,
                              .velocities = velocities,
                              .history = history_,
                              .points = points_,
                              .spans = spans_});
    tubes_.make(points_, spans_,
                {.radius = 0.5F * parameters_.width,
                 .taperLast = static_cast<float>(parameters_.frames),
                 .fade = parameters_.fade});
    made_ = true;
  }
  return tubes_.surface(material_);
}

void ParticleTrails::visitCheckpointData(CarryOver& carry) {
  carry.number("slot of trails", slot_);
  carry.number("frames of trails", recorded_);
  carry.array("history", history_.buffer());
  made_ = false;
}

}  // namespace simreel::sim
