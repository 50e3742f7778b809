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

/// What may be known of a picture besides its colour, and what it is called.
enum class Layer { depth, position, object, normal, albedo, velocity, vector, primitive };
inline constexpr std::array<const char*, 8> layerNames = {"depth",  "position", "object", "normal",
                                                          "albedo", "velocity", "vector", "primitive"};
/// Of those that are shaded instead of light, as shaders know them (SHOWN of
/// glsl/draw/surface/lighting.glsl).
inline constexpr std::array<Layer, 2> shownLayers = {Layer::normal, Layer::albedo};

/// What is kept of pictures besides their bytes.
struct LightRequest {
  std::vector<Layer> layers = {};
  bool filmed = false;  ///< light as the film shows it, sRGB encoded, instead of before lens and film
  int bits = 16;        ///< of each of its numbers in a file: 16, or 32 of OpenEXR
  bool quiet = false;   ///< whether nobody is told what it leaves out
};

/// A picture before lens and film, linear light (Rec. 709 primaries), or after, and layers of those that
/// were asked for. Rows from the top. Shares of objects are of all that light is the mean of, moments of
/// the shutter and points of the lens; the other layers are of the first of these, the latest moment and
/// the point next to the middle, as values between things in focus would be of nothing that is there.
struct PictureLayers {
  /// How much of a pixel an object covers.
  struct Share {
    std::uint32_t object = 0;  ///< its number in `objects`
    float coverage = 0;        ///< 0 to 1
  };
  static constexpr int mostRanks = 6;
  static constexpr std::uint32_t noPrimitive = 0xffffffffU;

  glm::ivec2 size{0};
  bool filmed = false;  ///< as LightRequest has it, and the next
  int bits = 16;
  std::vector<float> light;     ///< RGBA; alpha is how much is covered, times which linear light already is
  bool alpha = false;           ///< whether it has one; else it is 1
  std::vector<float> depth;     ///< m along the line of sight, of the nearest; infinite where nothing is
  std::vector<float> position;  ///< three a pixel: where that is (m)
  std::vector<float>
      normal;  ///< three a pixel: unit, as shading sees it, the mean of what is opaque; else 0
  std::vector<float> albedo;  ///< three a pixel: linear RGB of what is opaque, the mean of what is there
  /// Three a pixel: how fast what is nearest moves in the world (m/s), whatever the camera does. Of
  /// surfaces the mean since the frame before, of instances their own; 0 where nothing moves, before the
  /// first step, and of surfaces that are made anew in each frame.
  std::vector<float> velocity;
  /// Two a pixel: pixels, to the right and up, from where what is nearest is seen to where it was seen in
  /// the frame before, by its velocity and by what the camera did. Of the sky, which is infinitely far
  /// away, by the camera's turning.
  std::vector<float> vector;
  /// Of what is nearest: its number among the triangles, balls and instances' triangles of its object, from
  /// 0 in the order in which they are drawn; 0 of the ground; noPrimitive where nothing is.
  std::vector<std::uint32_t> primitive;
  std::vector<std::string> objects;
  int ranks = 0;  ///< shares of a pixel in `shares`, the largest first; what is left over covers nothing
  std::vector<Share> shares;

  /// Takes normal or albedo from sums over a pixel's samples, RGBA, alpha being how much is there.
  void keepShown(Layer layer, std::span<const float> sums);
};

/// How the camera sees, without a lens, and saw a frame before.
struct CameraWay {
  shader::ExactView now, before;
  double seconds = 1;  ///< between the two
};

/// Makes layers of what is visible in one picture, band by band, on the CPU. Shares of objects:
/// ShareKeeper.
class LayerKeeper {
 public:
  LayerKeeper(PictureLayers& into, std::span<const Layer> wanted, glm::ivec2 size, int samples);
  /// Waits for the device. `things`: what has numbers, their first ones ascending.
  /// `velocities`: of all that moves, where they are wanted; `way`: where vectors are. `farther`: that the
  /// eye stands back (View::farther), which is no depth.
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
