#pragma once
#include "draw/surface/skin_maps.hpp"
#include "frame/image.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace simreel::frame {

/// One texture file of a material.
struct MapPicture {
  std::string name;  ///< map name: "albedo", "normal", "height", "roughness", "occlusion" or "emission"
  std::vector<std::byte> png;
};

/// Returns the names of a material's pictures in order. "emission" is included only if `glow` is not black.
[[nodiscard]] std::vector<std::string> mapNames(const glm::vec3& glow);

/// Encodes a material's maps as PNG files with the given text chunks. Albedo is sRGB. Normals have
/// components from -1 to 1, mapped to 0 to 255, and green points up. Height is 16-bit linear grey.
/// Roughness and occlusion are linear grey values. Emission is sRGB, as fractions of the brightest channel
/// of `glow`, and is omitted if `glow` is black.
[[nodiscard]] std::vector<MapPicture> encodeMaps(const draw::SkinMaps& maps, const glm::vec3& glow,
                                                 const ImageText& text);

}  // namespace simreel::frame
