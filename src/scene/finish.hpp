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

/// Image that was embedded in another file. Rows run from top to bottom. Pixels are RGBA with 8 bits per
/// channel.
struct Image {
  std::string name;  ///< name of the image in messages
  glm::ivec2 size{0, 0};
  std::vector<std::uint8_t> rgba;
};

/// Behaviour of a texture outside uv 0 to 1, as in glTF. repeat: the texture repeats. clamp: its border
/// texels extend outwards. mirror: it repeats, and every other copy is mirrored. The numbers are those in
/// glsl/draw/surface/footprint.glsl.
enum class Wrap { repeat, clamp, mirror };

/// Texture map of a surface: an image file or an embedded image. The map is absent if both are empty.
struct Map {
  std::filesystem::path file;
  std::shared_ptr<const Image> image;
  Wrap wrapU = Wrap::repeat, wrapV = Wrap::repeat;
  [[nodiscard]] bool empty() const { return file.empty() && image == nullptr; }
};

/// Use of a surface's opacity. opaque: the opacity is ignored. cut: texels with an opacity below a
/// threshold are not drawn. blend: the surface is blended with the background.
enum class Alpha { opaque, cut, blend };

/// Material properties in addition to colour, roughness and metallic, as in glTF 2.0: maps, emission,
/// opacity, clear coat, sheen and transmission. A material that uses none of them costs nothing extra to
/// draw.
struct Finish {
  Map color;    ///< sRGB colour and opacity map; replaces the material's texture
  Map normals;  ///< normal map in tangent space; x points along +u, y along -v (up in the image)
  float normalStrength = 1.0F;
  Map metalRough;  ///< factors on roughness (green channel) and on metallic (blue channel)
  Map occlusion;   ///< occlusion map; its red channel is the fraction of ambient light that reaches the
                   ///< surface
  float occlusionStrength = 1.0F;
  glm::vec3 emission{0};  ///< emitted radiance, linear RGB, before multiplication by emissionStrength
  float emissionStrength = 1.0F;
  Map emissionMap;  ///< sRGB map of factors on the emission
  Alpha alpha = Alpha::opaque;
  float opacity = 1.0F;  ///< factor on the alpha channel of the color map
  float cutoff = 0.5F;   ///< opacity threshold of Alpha::cut
  bool doubleSided = false;
  float coat = 0.0F;  ///< strength of the clear coat, 0 to 1
  float coatRoughness = 0.03F;
  glm::vec3 sheen{0};  ///< linear RGB colour of light that a cloth's upright fibres scatter at grazing
                       ///< angles
  float sheenRoughness = 0.3F;
  float transmission = 0.0F;  ///< fraction of the unreflected light that passes through; 1 for glass
  float ior = 1.5F;           ///< index of refraction relative to air
  bool thin = false;          ///< true for a transparent thin sheet without refraction, false for the
                              ///< surface of a solid
  glm::vec3 attenuation{1};   ///< linear RGB transmittance of the solid over attenuationDistance
  /// Distance in metres over which light in the solid is multiplied by `attenuation`.
  float attenuationDistance = 1.0F;

  [[nodiscard]] bool emits() const { return emission != glm::vec3(0) && emissionStrength > 0; }
  [[nodiscard]] bool hasMaps() const {
    return !color.empty() || !normals.empty() || !metalRough.empty() || !occlusion.empty() ||
           !emissionMap.empty();
  }
  /// True if the material uses at least one property of this struct.
  [[nodiscard]] bool used() const {
    return !color.empty() || !normals.empty() || !metalRough.empty() || !occlusion.empty() || emits() ||
           alpha != Alpha::opaque || coat > 0 || sheen != glm::vec3(0) || transmission > 0;
  }
  /// Declares the keys of a scene's material that set these properties.
  void describe(Fields& fields);
};

}  // namespace simreel::scene
