#pragma once
#include "draw/exact/exact_view.hpp"
#include "draw/exact/passes.hpp"
#include "draw/exact/visibility.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {
class Velocities;
}  // namespace simreel::draw

namespace simreel::draw {

/// Layers of a picture: data per pixel in addition to its colour. layerNames holds their names.
enum class Layer { depth, position, object, normal, albedo, velocity, vector, primitive, uv };
inline constexpr std::array<const char*, 9> layerNames = {
    "depth", "position", "object", "normal", "albedo", "velocity", "vector", "primitive", "uv"};
/// Layers that shading kernels compute instead of light, in the order of SHOWN in
/// glsl/draw/surface/overlay.glsl.
inline constexpr std::array<Layer, 3> shownLayers = {Layer::normal, Layer::albedo, Layer::uv};

/// Selects what is stored for each picture in addition to its 8-bit colours: the light as floats, and
/// layers.
struct LightRequest {
  std::vector<Layer> layers = {};
  bool filmed = false;  ///< true: light as the film shows it, sRGB encoded; false: light before lens and
                        ///< film
  int bits = 16;        ///< bits per number in OpenEXR files: 16 or 32
  bool quiet = false;   ///< true: no warnings about information that the layers lack
};

/// Light and requested layers of a picture. The light is linear (Rec. 709 primaries) before lens and film,
/// or encoded after them. Row 0 is at the top. Light and object coverage are means over all views (moments
/// of the shutter and lens points). The other layers show only the first view, with the latest moment and
/// the lens point nearest to the centre, because the mean over several objects would describe none of them.
struct PictureLayers {
  /// Fraction of a pixel that an object covers.
  struct ObjectCoverage {
    std::uint32_t object = 0;  ///< index of the object in `objects`
    float coverage = 0;        ///< covered fraction of the pixel, 0 to 1
  };
  static constexpr int maxCoveragesPerPixel = 6;
  static constexpr std::uint32_t noPrimitive = 0xffffffffU;

  glm::ivec2 size{0};
  bool filmed = false;  ///< copy of LightRequest::filmed; `bits` is the copy of LightRequest::bits
  int bits = 16;
  std::vector<float> light;     ///< RGBA light; alpha is the coverage. Linear light is premultiplied by
                                ///< alpha
  bool alpha = false;           ///< true if alpha holds the coverage; otherwise alpha is 1
  std::vector<float> depth;     ///< depth of the nearest surface along the view direction (m); infinite if
                                ///< the pixel is empty
  std::vector<float> position;  ///< three per pixel: world position of the nearest surface (m)
  std::vector<float> normal;    ///< three per pixel: unit shading normal, mean over opaque surfaces; 0
                                ///< elsewhere
  std::vector<float> albedo;    ///< three per pixel: linear RGB albedo, mean over opaque surfaces; 0
                                ///< elsewhere
  std::vector<float> uv;  ///< two per pixel: texture coordinates, mean over opaque surfaces; 0 elsewhere
  /// Three per pixel: world velocity (m/s) of the nearest surface, independent of the camera. Surfaces have
  /// the mean velocity since the previous frame; instances have their current velocity. The velocity is 0
  /// for static surfaces, before the first step, and for surfaces whose mesh is rebuilt in each frame.
  std::vector<float> velocity;
  /// Two per pixel: motion vector (pixels, to the right and up) from the current picture position of the
  /// nearest surface to its picture position in the previous frame. It is computed from the surface's
  /// velocity and the camera's motion. The sky is infinitely far away, so for empty pixels only the
  /// camera's rotation counts.
  std::vector<float> vector;
  /// Index of the nearest primitive within its object (triangle, ball or instance triangle), counted from 0
  /// in drawing order. 0 for the ground, noPrimitive for empty pixels.
  std::vector<std::uint32_t> primitive;
  std::vector<std::string> objects;
  int ranks = 0;  ///< number of entries per pixel in `shares`; the entries are sorted by coverage, largest
                  ///< first, and any area that they do not cover is empty
  std::vector<ObjectCoverage> shares;

  /// Sets the layer `normal`, `albedo` or `uv` from sums over the samples of a pixel: RGBA, where alpha is
  /// the coverage.
  void keepShown(Layer layer, std::span<const float> sums);
};

/// Views of the camera in the current and in the previous frame, without a lens.
struct CameraWay {
  shader::ExactView now, before;
  double seconds = 1;  ///< time between the two frames (s)
};

/// Computes the layers that need only visibility, for one view, on the CPU, band by band. CoverageCounter
/// computes object coverage.
class LayerKeeper {
 public:
  LayerKeeper(PictureLayers& into, std::span<const Layer> wanted, glm::ivec2 size, int samples);
  /// Adds a band. Waits for the GPU. `things`: objects with primitive ids, sorted by firstId. `velocities`:
  /// motion of all moving objects; required for velocities and vectors. `way`: camera motion; required for
  /// vectors. `farther`: distance by which the eye has been moved back (View::farther), which is subtracted
  /// from depths.
  void add(const Visibility& visibility, const shader::ExactView& view, std::span<const DrawnThing> things,
           const Velocities* velocities, const CameraWay* way, float farther = 0);

 private:
  [[nodiscard]] bool wants(Layer layer) const;
  void keepVector(std::size_t pixel, const std::optional<glm::dvec2>& now,
                  const std::optional<glm::dvec2>& before);
  void keepPrimitive(std::size_t pixel, unsigned number, std::span<const DrawnThing> things);

  PictureLayers& layers_;
  std::vector<Layer> wanted_;
  int samples_;
};

}  // namespace simreel::draw
