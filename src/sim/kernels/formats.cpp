#include "sim/kernels/formats.hpp"

#include "gl/texture.hpp"

#include <algorithm>
#include <iterator>

namespace simreel::sim {

namespace {

struct Format {
  const char* name;
  GLenum format;
};
constexpr Format formats[] = {
    {"rgba32f", GL_RGBA32F},
    {"rgba16f", GL_RGBA16F},
    {"rg32f", GL_RG32F},
    {"rg16f", GL_RG16F},
    {"r11f_g11f_b10f", GL_R11F_G11F_B10F},
    {"r32f", GL_R32F},
    {"r16f", GL_R16F},
    {"rgba16", GL_RGBA16},
    {"rgb10_a2", GL_RGB10_A2},
    {"rgba8", GL_RGBA8},
    {"rg16", GL_RG16},
    {"rg8", GL_RG8},
    {"r16", GL_R16},
    {"r8", GL_R8},
    {"rgba16_snorm", GL_RGBA16_SNORM},
    {"rgba8_snorm", GL_RGBA8_SNORM},
    {"rg16_snorm", GL_RG16_SNORM},
    {"rg8_snorm", GL_RG8_SNORM},
    {"r16_snorm", GL_R16_SNORM},
    {"r8_snorm", GL_R8_SNORM},
    {"rgba32i", GL_RGBA32I},
    {"rgba16i", GL_RGBA16I},
    {"rgba8i", GL_RGBA8I},
    {"rg32i", GL_RG32I},
    {"rg16i", GL_RG16I},
    {"rg8i", GL_RG8I},
    {"r32i", GL_R32I},
    {"r16i", GL_R16I},
    {"r8i", GL_R8I},
    {"rgba32ui", GL_RGBA32UI},
    {"rgba16ui", GL_RGBA16UI},
    {"rgb10_a2ui", GL_RGB10_A2UI},
    {"rgba8ui", GL_RGBA8UI},
    {"rg32ui", GL_RG32UI},
    {"rg16ui", GL_RG16UI},
    {"rg8ui", GL_RG8UI},
    {"r32ui", GL_R32UI},
    {"r16ui", GL_R16UI},
    {"r8ui", GL_R8UI},
};

}  // namespace

unsigned texelFormat(const std::string& name) {
  const auto* found =
      std::find_if(std::begin(formats), std::end(formats), [&](const Format& f) { return name == f.name; });
  return found == std::end(formats) ? 0 : found->format;
}

std::vector<std::string> texelFormatNames() {
  std::vector<std::string> names;
  for (const Format& one : formats) names.emplace_back(one.name);
  return names;
}

std::string texelNumbers(const std::string& format) {
  return format.ends_with("ui") ? "uint" : format.ends_with("i") ? "int" : "float";
}

}  // namespace simreel::sim
