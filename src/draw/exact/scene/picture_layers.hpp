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

/// Layers: information per pixel besides colour. layerNames holds their names.
enum class Layer { depth, position, object, normal, albedo, velocity, vector, primitive };
inline constexpr std::array<const char*, 8> layerNames = {"depth",  "position", "object", "normal",
                                                          "albedo", "velocity", "vector", "primitive"};
/// Layers that shading kernels compute instead of light, in the order of SHOWN in
/// glsl/draw/surface/lighting.glsl.
inline constexpr std::array<Layer, 2> shownLayers = {Layer::normal, Layer::albedo};

/// Selection of the data that is kept of pictures besides their bytes.
struct LightRequest {
  std::vector<Layer> layers = {};
  bool filmed = false;  ///< light as the film shows it, sRGB encoded, instead of before lens and film
  int bits = 16;        ///< bits per number in OpenEXR files: 16 or 32
  bool quiet = false;   ///< true: no warnings about information that the layers lack
};

/// Light of a picture, before lens and film (linear, Rec. 709 primaries) or after, and the requested
/// layers. Rows start at the top. Light and object coverage are means over all views (moments of the
/// shutter and lens points). The other layers show only the first view, with the latest moment and the lens
/// point next to the centre, because a mean of values of different objects would describe no object.
struct PictureLayers {
  /// Fraction of a pixel that an object covers.
  struct Share {
    std::uint32_t object = 0;  ///< index of the object in `objects`
    float coverage = 0;        ///< covered fraction of the pixel, 0 to 1
  };
  static constexpr int mostRanks = 6;
  static constexpr std::uint32_t noPrimitive = 0xffffffffU;

  glm::ivec2 size{0};
  bool filmed = false;  ///< copy of LightRequest::filmed; `bits` is the copy of LightRequest::bits
  int bits = 16;
  std::vector<float> light;     ///< RGBA light; alpha is coverage. Linear light is premultiplied by alpha
  bool alpha = false;           ///< true if alpha is valid; else alpha is 1
  std::vector<float> depth;     ///< depth of the nearest surface along the view direction (m); infinite if
                                ///< the pixel is empty
  std::vector<float> position;  ///< three per pixel: world position of that surface (m)
  std::vector<float> normal;    ///< three per pixel: unit shading normal, mean over opaque surfaces; else 0
  std::vector<float> albedo;    ///< three per pixel: linear RGB albedo, mean over opaque surfaces
  /// Three per pixel: world velocity (m/s) of the nearest surface, independent of the camera. For surfaces
  /// the mean since the previous frame, for instances their own velocity. 0 for static surfaces, before the
  /// first step, and for surfaces whose mesh is rebuilt in each frame.
  std::vector<float> velocity;
  /// Two per pixel: vector in the picture (pixels, to the right and up) from the present position of the
  /// nearest surface to its position in the previous frame, by its velocity and the camera's motion. For
  /// the sky, which is infinitely far away, only the camera's rotation counts.
  std::vector<float> vector;
  /// Index of the nearest primitive among the triangles, balls or instance triangles of its object, counted
  /// from 0 in drawing order; 0 for the ground, noPrimitive if the pixel is empty.
  std::vector<std::uint32_t> primitive;
  std::vector<std::string> objects;
  int ranks = 0;  ///< number of shares per pixel in `shares`, largest first; the rest of the pixel is empty
  std::vector<Share> shares;

  /// Sets normal or albedo from sums over the samples of a pixel: RGBA, where alpha is the coverage.
  void keepShown(Layer layer, std::span<const float> sums);
};

/// Views of the camera, without a lens, in the current and in the previous frame.
struct CameraWay {
  shader::ExactView now, before;
  double seconds = 1;  ///< time between the two frames (s)
};

/// Computes the visibility-based layers of one view on the CPU, band by band. ShareKeeper computes object
/// coverage.
class LayerKeeper {
 public:
  LayerKeeper(PictureLayers& into, std::span<const Layer> wanted, glm::ivec2 size, int samples);
  /// Adds a band; waits for the GPU. `things`: objects with primitive ids, sorted by firstId. `velocities`:
  /// motion of all moving objects, if velocities or vectors are requested. `way`: camera motion, if vectors
  /// are requested. `farther`: distance by which the eye has been moved back (View::farther), to be
  /// subtracted from depths.
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
