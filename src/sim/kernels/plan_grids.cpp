// The part of KernelPlan that plans grids in the world: terrain, wind and volumes.
#include "scene/json/words.hpp"
#include "sim/kernels/plan.hpp"

#include <fmt/format.h>

namespace simreel::sim {

glm::ivec3 KernelPlan::sizeOf(const std::string& memory) const {
  const int buffer = bufferNamed(memory);
  return buffer >= 0 ? buffers_[static_cast<std::size_t>(buffer)].size
                     : textures_[static_cast<std::size_t>(textureNamed(memory))].size;
}

bool KernelPlan::checkGridSize(const char* group, const char* key, const std::string& of,
                               const std::string& member, std::size_t numbers, int axes) {
  std::vector<std::string> all;
  for (const PlannedBuffer& buffer : buffers_)
    if (buffer.counterOf.empty() && buffer.previousOf.empty()) all.push_back(buffer.name);
  for (const PlannedTexture& texture : textures_) all.push_back(texture.name);
  if (of.empty()) {
    mistake({group},
            fmt::format("\"{}\" needs \"of\", a texture or buffer: {}", group, scene::suggestion("", all)));
    return false;
  }
  if (bufferNamed(of) < 0 && textureNamed(of) < 0) {
    unknown({group, "of"}, of, all, "texture or buffer");
    return false;
  }
  const glm::ivec3 size = sizeOf(of);
  const bool flat = axes == 2;
  if (size.x < 2 || size.y < 2 || (flat ? size.z != 1 : size.z < 2)) {
    mistake({group, "of"}, fmt::format("{} has the size {} x {} x {}; \"{}\" needs {}", scene::inQuotes(of),
                                       size.x, size.y, size.z, group,
                                       flat ? "a grid of two axes with at least 2 x 2 elements"
                                            : "a grid of three axes with at least 2 x 2 x 2 elements"));
    return false;
  }
  const std::vector<KernelSlot> own = slots(of);
  if (member.empty() && bufferNamed(of) >= 0 && own.size() > 1) {
    mistake({group}, fmt::format("\"{}\" needs \"{}\", a member of {}: {}", group, key, scene::inQuotes(of),
                                 scene::suggestion("", pathsOf(own))));
    return false;
  }
  if (!member.empty() && member != "r" && textureNamed(of) >= 0 &&
      textures_[static_cast<std::size_t>(textureNamed(of))].singleChannel()) {
    mistake({group, key}, fmt::format("a texel of {} is one number, \"r\"", scene::inQuotes(of)));
    return false;
  }
  if (!member.empty() || bufferNamed(of) >= 0) return holdMember(group, key, of, member, true, numbers);
  if (numbers == 1 || !textures_[static_cast<std::size_t>(textureNamed(of))].singleChannel()) return true;
  mistake({group, "of"}, fmt::format("a texel of {} is one number; a velocity needs two: give the texture "
                                     "the \"format\" \"rg32f\" or \"rgba32f\"",
                                     scene::inQuotes(of)));
  return false;
}

scene::Box KernelPlan::boxOfTerrain() const {
  const KernelTerrain& terrain = *drawn_.terrain;
  const glm::ivec3 size = sizeOf(terrain.of);
  const float deep = terrain.cell(size.x) * static_cast<float>(size.y - 1);
  const glm::vec3 half(0.5F * terrain.width, 0.05F * terrain.width, 0.5F * deep);
  return {terrain.position - half, terrain.position + half};
}

scene::Box KernelPlan::boxOfVolume() const {
  const KernelVolume& volume = *drawn_.volume;
  const glm::vec3 size(sizeOf(volume.of));
  const glm::vec3 half = 0.5F * volume.width / size.x * size;
  return {volume.position - half, volume.position + half};
}

void KernelPlan::planGrids() {
  if (drawn_.terrain) checkGridSize("terrain", "height", drawn_.terrain->of, drawn_.terrain->height, 1, 2);
  if (drawn_.wind) checkGridSize("wind", "velocity", drawn_.wind->of, drawn_.wind->velocity, 2, 2);
  if (drawn_.volume && checkGridSize("volume", "show", drawn_.volume->of, drawn_.volume->show, 1, 3))
    holdMember("volume", "color", drawn_.volume->of, drawn_.volume->color, false, 1);
}

}  // namespace simreel::sim
