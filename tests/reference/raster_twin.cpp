#include "reference/raster_twin.hpp"

#include "sim/core/shader_code.hpp"

namespace {

using namespace simreel::shader;  // NOLINT: the model uses GLSL's names

void imulExtended(int a, int b, int& high, int& low) {
  const std::int64_t product = static_cast<std::int64_t>(a) * b;
  high = static_cast<int>(product >> 32);
  low = static_cast<int>(product & 0xffffffff);
}
#define FUNCTION inline
#define precise
#define SAMPLES samples
/// Provides the inputs of the kernels, and includes the model files.
struct Raster {
  ExactView view;
  int samples;
#include "glsl/common/exact.glsl"
#include "glsl/draw/exact/fixed.glsl"
#include "glsl/draw/exact/triangles/clip.glsl"
#include "glsl/draw/exact/triangles/triangle.glsl"
  [[nodiscard]] vec3 onPicture(vec3 p) const;
  void fill(const Triangle& t, uint id, RasterTwinResult& result);
};
#undef SAMPLES
#undef precise
#undef FUNCTION

vec3 Raster::onPicture(vec3 p) const {
  const vec3 from = p - vec3(view.eye);
  const auto dot = [&](const vec4& row) { return from.x * row.x + from.y * row.y + from.z * row.z; };
  return {dot(view.across), dot(view.down), dot(view.forward)};
}

void Raster::fill(const Triangle& t, uint id, RasterTwinResult& result) {
  const ivec2 first = max(t.low >> 8, ivec2(0));
  const ivec2 last = min(t.high >> 8, view.size - 1);
  for (int y = first.y; y <= last.y; ++y)
    for (int x = first.x; x <= last.x; ++x)
      for (int s = 0; s < samples; ++s) {
        const ivec2 pixel(x, y);
        const ivec2 place = pixel * subpixels + samplePlace(s) * (subpixels / 16);
        bool inside = true;
        for (const Edge& edge : t.edges)
          inside = inside && edge.step_.y * std::int64_t{place.x - edge.from.x} -
                                     edge.step_.x * std::int64_t{place.y - edge.from.y} + edge.bias >=
                                 0;
        if (!inside) continue;
        const float near = nearAt(t, place);
        if (near < view.nearOverFar) continue;
        const auto at = static_cast<std::size_t>((y * view.size.x + x) * samples + s);
        const uint key = nearKey(near);
        if (key < result.keys[at] || (key == result.keys[at] && id < result.ids[at])) {
          result.keys[at] = key;
          result.ids[at] = id;
        }
      }
}

}  // namespace

RasterTwinResult rasterTwin(const ExactView& view, int samples, bool doubleSided,
                            const std::vector<glm::vec3>& places, const std::vector<unsigned>& indices) {
  Raster raster{view, samples};
  const auto count = static_cast<std::size_t>(view.size.x * view.size.y * samples);
  RasterTwinResult result{std::vector<std::uint32_t>(count, 0xffffffffU),
                          std::vector<std::uint32_t>(count, 0xffffffffU)};
  const vec2 size(view.size);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    vec3 corner[3];
    for (std::size_t k = 0; k < 3; ++k) corner[k] = raster.onPicture(places[indices[i + k]]);
    if (raster.beside(corner[0], corner[1], corner[2], size, view.near)) continue;
    const auto polygon = raster.clippedToPicture(corner[0], corner[1], corner[2], size, view.near);
    for (int k = 1; k + 1 < polygon.count; ++k) {
      const auto t = raster.triangleOf(raster.cornerOf(polygon.corners[0], view.near),
                                       raster.cornerOf(polygon.corners[k], view.near),
                                       raster.cornerOf(polygon.corners[k + 1], view.near));
      if (!t.empty && (doubleSided || !t.turned)) raster.fill(t, static_cast<uint>(i / 3), result);
    }
  }
  return result;
}
