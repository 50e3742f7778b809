#pragma once
#include "draw/exact/scene/picture_layers.hpp"
#include "frame/image.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace simreel::frame {

/// Encodes a picture as an OpenEXR file. The channels R, G, B and optionally A are half or float. Layers
/// that exist become further channels: depth as Z, position as P.X, P.Y, P.Z, normal as N.X ..., albedo as
/// albedo.R ..., velocity as velocity.X ..., and objects as Cryptomatte "CryptoObject" (Friedman and Jones,
/// specification 1.2) in floats. `text` becomes header attributes. Thread-safe.
[[nodiscard]] std::vector<std::byte> encodeExr(const draw::PictureLayers& picture, const ImageText& text);
/// Encodes a filmed (display-referred) picture as a PNG with 16 bits per channel: RGBA if the picture has
/// alpha, otherwise RGB.
[[nodiscard]] std::vector<std::byte> encodeDeepPng(const draw::PictureLayers& picture,
                                                   const ImageText& text);
/// Returns a hash of the whole content of the picture, independent of the encoder, as 32 hexadecimal
/// digits.
[[nodiscard]] std::string pixelHash(const draw::PictureLayers& picture);
/// Returns the Cryptomatte id of an object name: MurmurHash3 (32 bits, seed 0), with one exponent bit
/// flipped if the bits would otherwise be a zero, denormal, infinite or NaN float.
[[nodiscard]] std::uint32_t cryptomatteId(const std::string& name);

}  // namespace simreel::frame
