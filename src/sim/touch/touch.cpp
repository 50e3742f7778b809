#include "sim/touch/touch.hpp"

#include "gl/element_array.hpp"
#include "sim/core/kind.hpp"

#include <cstddef>

namespace simreel::sim {

Touch::Touch(const std::string& name, const Setting& setting, const Wanted& wanted) : wanted_(wanted) {
  if (wanted.solids) {
    fields_ = setting.find<DistanceFields>();
    heights_ = setting.find<HeightField>();
  }
  if (!wanted.walls.empty()) {
    walls_ = setting.wanted<Walls>(wanted.walls);
    walls_->checkReach(name, wanted.margin);
  }
  wind_ = setting.wanted<FluidWind>(wanted.wind);
  if (fields_ != nullptr) steps_ = StepBlocks<shader::MeshColliders>(name + " meshes", wanted.substeps);
}

void Touch::beginFrame(double time) {
  if (fields_ != nullptr)
    steps_.upload(fields_->plan().frame(time, wanted_.substeps, wanted_.substepSeconds));
}

TouchVariant Touch::variant() const {
  TouchVariant variant{.meshes = meshCount(), .heights = heights_ != nullptr, .wind = wind_ != nullptr};
  if (walls_ != nullptr) variant.walls = walls_->variant();
  if (gl::memoryPath() == gl::MemoryPath::texel) variant.colliders = wanted_.colliders;
  return variant;
}

TouchPart Touch::at(int substep) const {
  TouchPart part{.wind = wind()};
  if (fields_ != nullptr) {
    part.meshes = steps_.at(static_cast<std::size_t>(substep));
    part.fieldCells = fields_->cells();
  }
  if (heights_ != nullptr)
    part.heights = heights_->part(substep, wanted_.substeps, wanted_.margin, wanted_.bounce);
  if (walls_ != nullptr)
    part.walls = walls_->part({wanted_.margin, wanted_.bounce, wanted_.substepSeconds});
  return part;
}

}  // namespace simreel::sim
