#include "reference/picture_twin.hpp"

#include "draw/picture_code.hpp"

namespace {

using namespace simreel::shader;  // NOLINT: the model uses GLSL's names

#define FUNCTION inline
#define IF_ANY(condition) if (condition)
#define precise
#define EXACT_PICTURE
#define REFLECTIVE
#define GROUND_REFLECTIVE
#define HAZE 1
#define SAMPLES samples
/// Provides the inputs of the kernels, and includes the model files.
struct Kernel {
  const Frame& frame;
  const ExactView& view;
  int samples;
  const TwinTexture& texture;
#include "glsl/draw/exact/fixed.glsl"
#include "glsl/draw/exact/ground_plane.glsl"
#include "glsl/draw/exact/haze.glsl"
#include "glsl/draw/exact/screen/edge_light.glsl"
#include "glsl/draw/exact/unit_vector.glsl"
#include "glsl/draw/exact/weights.glsl"
#include "glsl/draw/screen/lens.glsl"
#include "glsl/draw/sky.glsl"
#include "glsl/draw/surface/footprint.glsl"
#include "glsl/draw/surface/ground_light.glsl"
#include "glsl/draw/surface/lighting.glsl"

  [[nodiscard]] vec3 onPicture(vec3 p) const {
    const vec3 from = p - vec3(view.eye);
    return {exactDot(from, vec3(view.across)), exactDot(from, vec3(view.down)),
            exactDot(from, vec3(view.forward))};
  }
  [[nodiscard]] vec3 albedoTexel(int x, int y, int level) const {
    const ivec2 size = max(texture.size >> level, ivec2(1));
    return vec3(texture.levels[static_cast<std::size_t>(level)][static_cast<std::size_t>(y * size.x + x)]) *
           1.5259022e-5F;
  }
  FILTERED(vec3, albedoAt, albedoTexel)
  /// Returns light from p as the eye sees it; unchanged if the scene has no haze.
  [[nodiscard]] vec4 hazed(vec4 light, vec3 p) {
    return frame.haze.x > 0 ? vec4(throughHaze(vec3(light), light.w, p), light.w) : light;
  }
  [[nodiscard]] vec2 placeOf(ivec2 pixel, int s) {
    return vec2(pixel * 16 + (s < 0 ? ivec2(8) : samplePlace(s))) * 0.0625F;
  }
};
#undef SAMPLES
#undef REFLECTIVE
#undef GROUND_REFLECTIVE
#undef HAZE
#undef EXACT_PICTURE
#undef precise
#undef FUNCTION

constexpr std::uint32_t groundId = 0xfffffffeU;
constexpr std::uint32_t nothing = 0xffffffffU;

std::uint32_t keyOf(float near) {
  return 0x7fffffffU - static_cast<std::uint32_t>(floatBitsToInt(near));
}

/// Adds the ground to those samples where it is nearer than the visible primitive.
void layGround(Kernel& kernel, RasterTwinResult& seen) {
  for (int y = 0; y < kernel.view.size.y; ++y)
    for (int x = 0; x < kernel.view.size.x; ++x)
      for (int s = 0; s < kernel.samples; ++s) {
        const float depth = kernel.groundDepth(kernel.rayThrough(kernel.placeOf({x, y}, s)));
        const float near = kernel.view.near * exactReciprocal(max(depth, 1e-6F));
        const auto at = static_cast<std::size_t>((y * kernel.view.size.x + x) * kernel.samples + s);
        if (depth >= kernel.view.near && near >= kernel.view.nearOverFar && keyOf(near) < seen.keys[at])
          seen.ids[at] = groundId;
      }
}

/// CPU version of glsl/draw/exact/surface/surface_uv.glsl.
vec3 textureOn(Kernel& kernel, const TwinTexture& texture, const unsigned* corners, const vec3* places,
               vec3 weight, vec2 at) {
  const vec2 a = texture.uvs[corners[0]];
  const vec2 b = texture.uvs[corners[1]];
  const vec2 c = texture.uvs[corners[2]];
  const auto uv = [&](vec3 w) { return (w.x * a + w.y * b + w.z * c) * texture.scale; };
  const auto beside = [&](vec2 aside) {
    return uv(kernel.ofSumOne(kernel.weightsAround(places[0], places[1], places[2], at + aside)));
  };
  const vec2 here = uv(weight);
  const Kernel::Seen seen = {here, beside({1, 0}) - here, beside({0, -1}) - here};
  const Kernel::TextureShape shape = {texture.size, static_cast<int>(texture.levels.size()),
                                      glm::ivec2(WRAP_REPEAT)};
  return kernel.albedoAt(here, kernel.footprintOf(seen, shape), shape);
}

vec4 surfaceAt(Kernel& kernel, const PictureTwinScene& scene, ivec2 pixel, std::uint32_t id, int sample) {
  vec3 corner[3];
  vec3 normal[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const unsigned i = scene.indices[3 * id + k];
    corner[k] = kernel.onPicture(scene.places[i]);
    normal[k] = kernel.unpackedUnit(kernel.packedUnit(scene.normals[i]));
  }
  vec2 place = kernel.placeOf(pixel, -1);
  auto weights = kernel.weightsAt(corner[0], corner[1], corner[2], place);
  if (!weights.within) {
    place = kernel.placeOf(pixel, sample);
    weights = kernel.weightsAt(corner[0], corner[1], corner[2], place);
  }
  const vec3 w = weights.of;
  const float depth = w.x * corner[0].z + w.y * corner[1].z + w.z * corner[2].z;
  const vec3 ray = kernel.rayThrough(place);
  const vec3 mean = w.x * normal[0] + w.y * normal[1] + w.z * normal[2];
  vec3 up = unitOf(mean);
  if (scene.doubleSided && weights.turned) up = -up;
  Kernel::Look look{};
  look.base = scene.color;
  if (!scene.texture.levels.empty())
    look.base = look.base * textureOn(kernel, scene.texture, &scene.indices[3 * id], corner, w, place);
  look.roughness = scene.roughness;
  look.metallic = scene.metallic;
  look.openness = 1;
  const vec3 p = kernel.placeOnRay(ray, depth);
  return kernel.hazed(vec4(vec3(0) + kernel.allLight(look, p, up, unitOf(-ray), 1.0F), 1.0F), p);
}

vec4 groundAt(Kernel& kernel, ivec2 pixel, int sample) {
  vec3 ray = kernel.rayThrough(kernel.placeOf(pixel, -1));
  float depth = kernel.groundDepth(ray);
  if (depth < kernel.view.near) {
    ray = kernel.rayThrough(kernel.placeOf(pixel, sample));
    depth = kernel.groundDepth(ray);
  }
  const vec3 p = kernel.placeOnRay(ray, depth);
  return kernel.hazed(kernel.groundLight(p, unitOf(-ray), 1.0F, 1.0F), p);
}

/// Returns the light of a pixel's samples, with evened edges. Shades each visible primitive once, and the
/// ground last.
vec4 lightOf(Kernel& kernel, const PictureTwinScene& scene, const std::uint32_t* ids, ivec2 pixel) {
  vec4 sum(0);
  const auto add = [&](std::uint32_t id, int first) {
    int same = 0;
    for (int s = 0; s < kernel.samples; ++s) same += ids[s] == id ? 1 : 0;
    const vec4 light =
        id == groundId ? groundAt(kernel, pixel, first) : surfaceAt(kernel, scene, pixel, id, first);
    const float share = static_cast<float>(same) * kernel.perSamples();
    float brightness = kernel.brightnessOf(vec3(light), kernel.frame.exposure);
    if (id == groundId) brightness = brightness * exactReciprocal(max(light.w, 1e-6F));
    sum = sum + light * kernel.edgeWeights(sum, share, brightness, same == kernel.samples);
  };
  for (const bool ground : {false, true})
    for (int s = 0; s < kernel.samples; ++s) {
      bool again = false;
      for (int before = 0; before < s; ++before) again = again || ids[before] == ids[s];
      if (!again && ids[s] != nothing && (ids[s] == groundId) == ground) add(ids[s], s);
    }
  return kernel.evenedLight(sum, kernel.frame.exposure);
}

std::uint8_t byteOf(float x) {
  return static_cast<std::uint8_t>(floor(clamp(x, 0.0F, 1.0F) * 255.0F + 0.5F));
}

}  // namespace

std::vector<std::uint8_t> pictureTwin(const PictureTwinScene& scene) {
  Kernel kernel{scene.frame, scene.view, scene.samples, scene.texture};
  RasterTwinResult seen =
      rasterTwin(scene.view, scene.samples, scene.doubleSided, scene.places, scene.indices);
  if (scene.ground) layGround(kernel, seen);
  const vec2 perSize = 2.0F / vec2(scene.view.size);
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < scene.view.size.y; ++y)
    for (int x = 0; x < scene.view.size.x; ++x) {
      const auto at = static_cast<std::size_t>((y * scene.view.size.x + x) * scene.samples);
      const vec4 drawn = min(lightOf(kernel, scene, &seen.ids[at], {x, y}), 6e4F);
      const vec2 place = vec2(x, y) + 0.5F;
      const vec3 direction = unitOf(kernel.rayThrough(place));
      const vec3 light = vec3(drawn) + (1.0F - drawn.w) * kernel.skyInDirection(direction);
      const vec3 color =
          encoded(filmed(kernel.throughLens(light, place * perSize - 1.0F))) + dither(ivec2(x, y));
      for (const float channel : {color.x, color.y, color.z}) bytes.push_back(byteOf(channel));
      bytes.push_back(255);
    }
  return bytes;
}
