#include "kernels/source/toy.hpp"

#include "kernels/source/derivatives.hpp"
#include "kernels/source/files.hpp"

#include <fmt/format.h>

namespace simreel::kernels {

bool isToy(std::string_view text) {
  return withoutComments(text).find("mainImage") != std::string::npos;
}

std::string textBefore(const std::string& pass, bool derivatives) {
  std::string text = fmt::format(R"(layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D {0}_Output;
uniform vec3 iResolution;
uniform float iTime, iTimeDelta, iFrameRate, iSampleRate;
uniform int iFrame;
uniform vec4 iMouse, iDate;
uniform float iChannelTime[4];
uniform vec3 {0}_ChannelResolution[4];
#define iChannelResolution {0}_ChannelResolution
#define iGlobalTime iTime
#define texture2D texture
#define texture2DLodEXT textureLod
#define HW_PERFORMANCE 1
)",
                                 pass);
  for (int i = 0; i < 4; ++i)
    text += fmt::format("uniform sampler2D {0}_Channel{1};\n#define iChannel{1} {0}_Channel{1}\n", pass, i);
  return text + (derivatives ? derivativeFunctions() : "");
}

std::string textBehind(const std::string& text, const std::string& pass, bool upsideDown) {
  return fmt::format(
      R"(
void main() {{
  ivec2 simreel_size = ivec2(iResolution.xy), simreel_at = ivec2(gl_GlobalInvocationID.xy);
  if (simreel_at.x >= simreel_size.x || simreel_at.y >= simreel_size.y) return;
  vec4 simreel_color = vec4(0.0, 0.0, 0.0, 1.0);
{2}  imageStore({0}_Output, ivec2(simreel_at.x, {1}), simreel_color);
}}
)",
      pass, upsideDown ? "simreel_size.y - 1 - simreel_at.y" : "simreel_at.y",
      usesDerivatives(text) ? threeRuns(text) : "  mainImage(simreel_color, vec2(simreel_at) + 0.5);\n");
}

}  // namespace simreel::kernels
