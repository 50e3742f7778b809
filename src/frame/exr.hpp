#pragma once
#include "draw/exact/scene/picture_layers.hpp"
#include "frame/image.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace simreel::frame {

/// -> OpenEXR file: R, G, B and, where there is one, A as halves or floats; of layers that it has depth as
/// Z, position as P.X, P.Y, P.Z, normal, albedo and velocity as N.X ..., albedo.R ... and velocity.X ...,
/// and objects as Cryptomatte "CryptoObject" (Friedman and Jones, specification 1.2), in floats. Texts are
/// attributes of the header. Safe to call from several threads.
[[nodiscard]] std::vector<std::byte> encodeExr(const draw::PictureLayers& picture, const ImageText& text);
/// -> PNG file of 16 bits a number, RGBA where alpha is part of it, else RGB, of a picture that is filmed.
[[nodiscard]] std::vector<std::byte> encodeDeepPng(const draw::PictureLayers& picture,
                                                   const ImageText& text);
/// Hash of all that it holds, independent of the encoder. 32 hexadecimal digits.
[[nodiscard]] std::string pixelHash(const draw::PictureLayers& picture);
/// The number of a name in Cryptomatte: MurmurHash3 (32 bits, seed 0), with one bit of the exponent turned
/// where a float of these bits would be no ordinary number.
[[nodiscard]] std::uint32_t cryptomatteId(const std::string& name);

}  // namespace simreel::frame
