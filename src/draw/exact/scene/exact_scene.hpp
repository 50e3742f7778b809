#pragma once
#include "draw/environment.hpp"
#include "draw/exact/passes.hpp"
#include "draw/exact/scene/picture_layers.hpp"
#include "draw/overlay/field_pass.hpp"
#include "draw/overlay/field_textures.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include <glm/vec2.hpp>

namespace simreel::draw {

class Motion;

/// Memory limits of one band of a picture.
struct BandLimits {
  std::size_t samples;     ///< max number of visibility samples
  std::int64_t glowBytes;  ///< max bytes of the glow sums, which must fit into one buffer
};
/// Returns the number of pixel rows per band that fit into the memory. The number is a multiple of the tile
/// size and at least one tile.
[[nodiscard]] int rowsOfBands(glm::ivec2 size, int samples, const BandLimits& room);

/// Draws a scene with compute kernels in exact arithmetic, except for the overlays on the finished picture.
/// The bytes are the same on every device.
class ExactScene {
 public:
  /// Pictures are drawn in bands of at least 8 rows if their visibility exceeds `visibilityBytes` or if the
  /// glow sums exceed the size of one buffer. Throws UserError(usage) for unsupported scenes and
  /// UserError(device) if a device limit is exceeded. The scene and the environment must outlive this
  /// object.
  ExactScene(const scene::Scene& scene, const Environment* environment, glm::ivec2 size, int samples,
             std::size_t visibilityBytes);
  ~ExactScene();
  ExactScene(ExactScene&&) = delete;
  ExactScene& operator=(ExactScene&&) = delete;
  ExactScene(const ExactScene&) = delete;
  ExactScene& operator=(const ExactScene&) = delete;

  /// Simulated fields of the frame, as textures for skins and as pictures behind the scene.
  struct Overlays {
    const FieldTextures& textures;
    FieldPass& fields;
  };
  using StageCallback = std::function<void(const char* stage)>;
  /// Content of the scene at one time.
  struct Moment {
    double seconds = 0;  ///< scene time (s)
    const sim::Drawables* drawables = nullptr;
  };
  /// Moments while the shutter is open. The picture is the mean over all moments.
  struct Exposure {
    int moments = 1;
    /// Returns the content at the moment with index i, and sets the frame's uniform block to that moment.
    /// The content is valid until the next call.
    std::function<Moment(int i)> at;
    std::function<void()> close = {};  ///< function that is called after the last moment to restore the
                                       ///< frame's uniform block
    Motion* motion = nullptr;          ///< motion since the previous frame, after Motion::begin(); null if
                                       ///< it is not needed
    double frameSeconds = 1;           ///< time between the previous and the current frame (s)
    float part = 1;  ///< interpolation parameter of the first moment: 0 at the previous frame, 1 at the
                     ///< current frame
  };
  /// Draws into an RGBA8 picture, with row 0 at the top. `frame`: time and content for fields, bloom and
  /// film. The frame's uniform block must be bound.
  void draw(const Exposure& exposure, const Moment& frame, const Overlays& overlays,
            const gl::Texture& picture, const StageCallback& watch);
  /// Sets the object that receives the pass outputs of later pictures, replacing earlier contents. Null:
  /// pass outputs are not stored.
  void keepPasses(PassPicture* passes);
  /// Requests the light and layers of all later pictures. The CPU then waits for the GPU. For cameras with
  /// a lens or a shutter, the layers show the first lens point at the first moment.
  void keepLayers(const LightRequest& wanted);
  /// Returns the light and layers of the last picture.
  [[nodiscard]] PictureLayers takeLayers();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel::draw
