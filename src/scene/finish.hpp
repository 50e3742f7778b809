#pragma once
#include "scene/value/fields.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::scene {

/// A picture that came inside another file. Rows from the top, RGBA, 8 bits each.
struct Image {
  std::string name;  ///< what messages call it
  glm::ivec2 size{0, 0};
  std::vector<std::uint8_t> rgba;
};

/// A picture that is laid over a surface: of a file, or one that came inside another; none where both are
/// empty.
struct Map {
  std::filesystem::path file;
  std::shared_ptr<const Image> image;
  bool repeats = true;  ///< beyond uv 0 to 1; else its border goes on
  [[nodiscard]] bool empty() const { return file.empty() && image == nullptr; }
};

/// What becomes of a surface's opacity: nothing; where it is below a limit there is none of it; what lies
/// behind shines through.
enum class Alpha { opaque, cut, blend };

/// What a material has beyond colour, roughness and metal, as glTF 2.0 has it: maps, light of its own,
/// holes, and what lies over it. What has none of it is drawn without its costs.
struct Finish {
  Map color;    ///< sRGB and opacity, instead of the material's texture
  Map normals;  ///< tangent space, x along u, y against v (the picture's up)
  float normalStrength = 1.0F;
  Map metalRough;  ///< factors: green of roughness, blue of metallic
  Map occlusion;   ///< red: fraction of the surroundings' light that gets there
  float occlusionStrength = 1.0F;
  glm::vec3 emission{0};  ///< linear RGB: radiance, times the strength
  float emissionStrength = 1.0F;
  Map emissionMap;  ///< sRGB, a factor
  Alpha alpha = Alpha::opaque;
  float opacity = 1.0F;  ///< times that of the colour's map
  float cutoff = 0.5F;   ///< of Alpha::cut
  bool doubleSided = false;
  float coat = 0.0F;  ///< strength of a clear coat
  float coatRoughness = 0.03F;
  glm::vec3 sheen{0};  ///< linear RGB, of fibres that stand up
  float sheenRoughness = 0.3F;
  float transmission = 0.0F;  ///< fraction of what is not mirrored that goes through, as through glass
  float ior = 1.5F;           ///< index of refraction, beside that of air
  bool thin = false;          ///< a sheet that light goes straight through; else the surface of a solid
  glm::vec3 attenuation{1};   ///< linear RGB: what is left of white light after the distance
  float attenuationDistance = 1.0F;  ///< m within the solid

  [[nodiscard]] bool emits() const { return emission != glm::vec3(0) && emissionStrength > 0; }
  [[nodiscard]] bool hasMaps() const {
    return !color.empty() || !normals.empty() || !metalRough.empty() || !occlusion.empty() ||
           !emissionMap.empty();
  }
  /// Whether there is any of it.
  [[nodiscard]] bool used() const {
    return !color.empty() || !normals.empty() || !metalRough.empty() || !occlusion.empty() || emits() ||
           alpha != Alpha::opaque || coat > 0 || sheen != glm::vec3(0) || transmission > 0;
  }
  /// The keys of a scene's material.
  void describe(Fields& fields);
};

}  // namespace simreel::scene
