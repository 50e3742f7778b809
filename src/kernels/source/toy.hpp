#pragma once
#include <string>
#include <string_view>

namespace simreel::kernels {

/// Returns true if a text defines mainImage(), as ShaderToy's do.
[[nodiscard]] bool isToy(std::string_view text);
/// Declarations of what ShaderToy gives a pass: iResolution, iTime, iTimeDelta, iFrame, iFrameRate, iMouse,
/// iDate, iSampleRate, iChannelTime, iChannelResolution and iChannel0 to iChannel3.
[[nodiscard]] std::string textBefore(const std::string& pass);
/// The kernel that calls mainImage() for each pixel.
[[nodiscard]] std::string textBehind(const std::string& pass, bool upsideDown);

}  // namespace simreel::kernels
