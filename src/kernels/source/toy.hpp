#pragma once
#include <string>
#include <string_view>

namespace simreel::kernels {

/// Returns true if a text defines mainImage(), as ShaderToy shaders do.
[[nodiscard]] bool isToy(std::string_view text);
/// Returns declarations of ShaderToy's inputs: iResolution, iTime, iTimeDelta, iFrame, iFrameRate, iMouse,
/// iDate, iSampleRate, iChannelTime, iChannelResolution and iChannel0 to iChannel3. If `derivatives` is
/// true, adds dFdx(), dFdy() and fwidth().
[[nodiscard]] std::string textBefore(const std::string& pass, bool derivatives);
/// Returns a kernel to append to the text. The kernel calls the text's mainImage() for each pixel.
[[nodiscard]] std::string textBehind(const std::string& text, const std::string& pass, bool upsideDown);

}  // namespace simreel::kernels
