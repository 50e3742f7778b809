#include "reference/garment_twin.hpp"

#include "reference/held_twin.hpp"
#include "sim/core/shader_code.hpp"

#include <utility>

namespace {

using namespace simreel::shader;
#include "glsl/cloth/thin_rounds.glsl"

#define FUNCTION inline
#define precise
/// Provides the globals that the model reads in a kernel, and includes the model files.
struct GarmentKernel : WindKernel {
  const ClothStep& stepData;
  const simreel::sim::GarmentArrays& arrays;
  const vec4* source;
  const vec4* forces;
  bool keeps = false;
  MeshColliders meshData{};
  const uvec4* fieldCells = nullptr;
  HeightGrid heightGrid{};
  const vec4* heights = nullptr;
  WallGrid wallGrid{};
  const WallsTwin* walls = nullptr;
  [[nodiscard]] vec3 loadPoint(int i) const { return vec3(source[i]); }
  [[nodiscard]] vec4 loadElement(int i) const { return arrays.elements[static_cast<std::size_t>(i)]; }
  [[nodiscard]] vec3 loadFaceForce(int i) const { return vec3(forces[i]); }
  const simreel::sim::GarmentBending* bending = nullptr;
  [[nodiscard]] uvec4 loadEntry(int i) const { return bending->entries[static_cast<std::size_t>(i)]; }
  [[nodiscard]] uvec4 loadRing(int i) const { return arrays.rings[static_cast<std::size_t>(i)]; }
  [[nodiscard]] vec4 loadHeights(int i) const { return heights[i]; }
  [[nodiscard]] uvec4 loadFieldCell(int i) const { return fieldCells[i]; }
  [[nodiscard]] int loadWallClass(int x, int y) const { return walls->classAt(x, y); }
  [[nodiscard]] float loadWallValue(int x, int y) const { return walls->valueAt(x, y); }
#include "glsl/cloth/thin.glsl"
#include "glsl/collide/closest.glsl"
#include "glsl/contour/model.glsl"
#include "glsl/contour/wall_model.glsl"
#include "glsl/fluid/wind_model.glsl"
#include "glsl/garment/model.glsl"
#include "glsl/mesh/height_model.glsl"
};
#undef precise
#undef FUNCTION

}  // namespace

GarmentTwin::GarmentTwin(simreel::sim::GarmentPlan plan)
    : positions(plan.firstPositions()),
      velocities(plan.firstVelocities()),
      trends(plan.firstTrends()),
      plan_(std::move(plan)),
      next_(positions),
      forces_(plan_.arrays().corners.size()) {}

void GarmentTwin::step(double time) {
  int index = 0;
  const auto steps = plan_.frame(time);
  if (meshes) meshes->beginFrame(time, plan_.substeps(), plan_.substepSeconds());
  pinDisplacements_ = plan_.skinPins().frame(time, time + plan_.substeps() * plan_.substepSeconds());
  for (const ClothStep& data : steps) substep(data, index++);
}

void GarmentTwin::substep(const ClothStep& data, int index) {
  const bool lands = heightPlan.has_value();
  HeightGrid grid{};
  if (lands) grid = heightPlan->at(index, plan_.substeps(), plan_.parameters().margin, 0.0F);
  WallGrid wallGrid{};
  if (walls) wallGrid = walls->grid({plan_.parameters().margin, 0.0F, plan_.substepSeconds()});
  const simreel::sim::GarmentArrays& arrays = plan_.arrays();
  const bool keeps = plan_.parameters().keepsEnergy();
  GarmentKernel kernel{{}, data, arrays, positions.data(), forces_.data(), keeps};
  kernel.blow(wind);
  kernel.heightGrid = grid;
  kernel.heights = heights.data();
  kernel.wallGrid = wallGrid;
  kernel.walls = walls ? &*walls : nullptr;
  kernel.bending = &arrays.bendings[plan_.bendingAt(static_cast<int>(data.substep))];
  if (meshes) {
    kernel.meshData = meshes->steps[static_cast<std::size_t>(index)];
    kernel.fieldCells = meshes->cells.data();
  }
  const bool air = plan_.parameters().air.has_value();
  for (std::size_t f = 0; air && f < arrays.corners.size(); ++f) {
    const uvec4 face = arrays.corners[f];
    const vec3 velocity =
        (vec3(velocities[face.x]) + vec3(velocities[face.y]) + vec3(velocities[face.z])) * 0.33333333F;
    forces_[f] = vec4(kernel.airOnCorner(vec3(positions[face.x]), vec3(positions[face.y]),
                                         vec3(positions[face.z]), velocity),
                      0);
  }
  holdBySkin(pinDisplacements_, index, plan_.substeps(), velocities);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto m =
        kernel.predicted(kernel.bending->fans[i], positions[i], velocities[i], vec3(trends[i]), air);
    velocities[i] = vec4(m.velocity, velocities[i].w);
    next_[i] = vec4(m.position, positions[i].w);
  }
  const std::size_t faces = arrays.corners.size();
  for (std::size_t k = 0; !keeps && k < 2 * faces; ++k) {
    const std::size_t f = k < faces ? k : 2 * faces - 1 - k;  // The order is forwards, then backwards.
    const uvec4 face = arrays.corners[f];
    const vec3 compliance = vec3(arrays.elements[2 * f + 1]) * data.complianceScale;
    const vec4 shape = arrays.elements[2 * f];
    const vec3 kept = plan_.parameters().damped()
                          ? kernel.keptStrain(vec3(positions[face.x]), vec3(positions[face.y]),
                                              vec3(positions[face.z]), shape)
                          : vec3(0);
    const auto shift =
        kernel.faceShift(next_[face.x], next_[face.y], next_[face.z], shape, compliance, kept);
    next_[face.x] = kernel.shifted(next_[face.x], shift.a);
    next_[face.y] = kernel.shifted(next_[face.y], shift.b);
    next_[face.z] = kernel.shifted(next_[face.z], shift.c);
  }
  const auto push = [&](unsigned i, vec4 to) {
    velocities[i] = kernel.pushed(velocities[i], next_[i], to);
    next_[i] = to;
  };
  for (const uvec4 a : arrays.attachments) {
    if (keeps) {
      const vec3 shift =
          kernel.attachedShift(positions[a.x], vec3(positions[a.y]), intBitsToFloat(static_cast<int>(a.z)),
                               intBitsToFloat(static_cast<int>(a.w)), true);
      velocities[a.x] = vec4(vec3(velocities[a.x]) + shift * data.perDt, velocities[a.x].w);
      continue;
    }
    const bool held = trends[a.x].w > 0;
    const vec4 here = next_[a.x];
    const vec4 moved = kernel.attached(here, vec3(next_[a.y]), intBitsToFloat(static_cast<int>(a.z)),
                                       intBitsToFloat(static_cast<int>(a.w)), held);
    trends[a.x].w = vec3(moved) != vec3(here) ? 1.0F : 0.0F;
    if (held)
      next_[a.x] = moved;
    else
      push(a.x, moved);
  }
  for (const uvec4 stitch : arrays.stitches) {
    const vec3 shift =
        kernel.stitchShift(next_[stitch.x], next_[stitch.y], intBitsToFloat(static_cast<int>(stitch.z)),
                           intBitsToFloat(static_cast<int>(stitch.w)));
    push(stitch.x, kernel.shifted(next_[stitch.x], shift));
    push(stitch.y, kernel.shifted(next_[stitch.y], -shift));
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    GarmentKernel::Motion m;
    if (keeps) {
      m = kernel.forced(positions[i], next_[i], vec3(velocities[i]), lands, walls.has_value());
    } else {
      const auto s = kernel.settled(positions[i], next_[i], vec3(velocities[i]), vec3(trends[i]), lands,
                                    walls.has_value());
      m = s.motion;
      trends[i] = vec4(s.trend, trends[i].w);
    }
    next_[i] = vec4(m.position, next_[i].w);
    velocities[i] = vec4(m.velocity, velocities[i].w);
  }
  for (int round = 0; round < thinRounds; ++round) resolveThin(data);
  std::swap(positions, next_);
}

void GarmentTwin::resolveThin(const ClothStep& data) {
  if (data.thinCount == 0) return;
  const simreel::sim::GarmentArrays& arrays = plan_.arrays();
  GarmentKernel kernel{{}, data, arrays, positions.data(), forces_.data()};
  kernel.blow(wind);
  const auto cornerAt = [&](std::size_t i) {
    return kernel.cornerOf(positions[i], next_[i], velocities[i]);
  };
  std::vector<GarmentKernel::ThinPush> all;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const GarmentKernel::Corner here = cornerAt(i);
    GarmentKernel::ThinPush sum = kernel.notPushed();
    for (int c = data.colliderCount; c < data.colliderCount + data.thinCount; ++c) {
      if (here.inverseMass == 0 || !kernel.mayMeet(c, here)) continue;
      GarmentKernel::ThinPush maximum = kernel.notPushed();
      for (unsigned k = 0; k < arrays.bendings[0].fans[i].y; ++k) {
        const uvec4 ring = arrays.rings[arrays.bendings[0].fans[i].x + k];
        maximum = kernel.pushedByEdge(maximum, c, here, cornerAt(ring.x));
        maximum = kernel.pushedByEdge(maximum, c, here, cornerAt(ring.y));
        maximum = kernel.pushedByFace(maximum, c, here, cornerAt(ring.x), cornerAt(ring.y));
      }
      sum = kernel.together(sum, maximum);
    }
    all.push_back(sum);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    next_[i] = vec4(vec3(next_[i]) + all[i].shift, next_[i].w);
    velocities[i] = vec4(vec3(velocities[i]) + all[i].change, velocities[i].w);
  }
}

std::vector<glm::vec3> GarmentTwin::normals() const {
  const ClothStep nothing{};
  GarmentKernel kernel{{}, nothing, plan_.arrays(), positions.data(), forces_.data()};
  std::vector<glm::vec3> normals;
  for (std::size_t i = 0; i < positions.size(); ++i)
    normals.push_back(kernel.normalAt(plan_.arrays().bendings[0].fans[i], vec3(positions[i])));
  return normals;
}
