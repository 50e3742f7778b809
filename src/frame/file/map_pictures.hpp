#pragma once
#include "draw/surface/skin_maps.hpp"
#include "frame/image.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace simreel::frame {

/// One file of a material.
struct MapPicture {
  std::string name;  ///< "albedo", "normal", "height", "roughness", "occlusion", "emission"
  std::vector<std::byte> png;
};

/// The names of the pictures of a material, in order; "emission" only where `glow` is not
/// black.
[[nodiscard]] std::vector<std::string> mapNames(const glm::vec3& glow);

/// A material's maps as PNG files with the given text chunks: albedo sRGB; normal with 0 to 255 for -1 to
/// 1, green up; height 16-bit grey; roughness and occlusion linear grey; emission sRGB, as fractions of the
/// brightest channel of `glow` (none when that is 0).
[[nodiscard]] std::vector<MapPicture> encodeMaps(const draw::SkinMaps& maps, const glm::vec3& glow,
                                                 const ImageText& text);

}  // namespace simreel::frame
