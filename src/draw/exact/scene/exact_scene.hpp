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
struct BandRoom {
  std::size_t samples;     ///< max number of visibility samples
  std::int64_t glowBytes;  ///< max bytes of the glow sums, which are in one buffer
};
/// Returns the number of rows per band that fit into the memory: a multiple of the tile size, at least one
/// tile.
[[nodiscard]] int rowsOfBands(glm::ivec2 size, int samples, const BandRoom& room);

/// Draws a scene with compute kernels in exact arithmetic, except the overlays on the finished picture. The
/// bytes are the same on every device.
class ExactScene {
 public:
  /// Pictures are drawn in bands of at least 8 rows if their visibility exceeds `visibilityBytes` or if one
  /// buffer cannot hold the glow sums. Throws UserError(usage) for unsupported scenes, UserError(device)
  /// for device limits. The scene and the environment must outlive this object.
  ExactScene(const scene::Scene& scene, const Environment* environment, glm::ivec2 size, int samples,
             std::size_t visibilityBytes);
  ~ExactScene();
  ExactScene(ExactScene&&) = delete;
  ExactScene& operator=(ExactScene&&) = delete;
  ExactScene(const ExactScene&) = delete;
  ExactScene& operator=(const ExactScene&) = delete;

  /// Simulated fields of the frame: as textures for skins, and as pictures behind the scene.
  struct Overlays {
    const FieldTextures& textures;
    FieldPass& fields;
  };
  using Watch = std::function<void(const char* stage)>;
  /// Content of the scene at one time.
  struct Moment {
    double seconds = 0;  ///< scene time (s)
    const sim::Drawables* drawables = nullptr;
  };
  /// Moments of the open shutter. The picture is the mean over them.
  struct Exposure {
    int moments = 1;
    /// Returns moment i, valid until the next call. Also sets the frame's uniform block to that moment.
    std::function<Moment(int i)> at;
    std::function<void()> close = {};  ///< called after the last moment: restores the frame's uniform block
    Motion* motion = nullptr;          ///< motion since the previous frame, already begun; null: not needed
    double frameSeconds = 1;           ///< time between the previous and the current frame (s)
    float part = 1;  ///< interpolation parameter of the first moment: 0 at the previous frame, 1
                     ///< at the current frame
  };
  /// Draws into an RGBA8 picture, with row 0 at the top. `frame`: time and content for fields, bloom and
  /// film. The frame's uniform block must be bound.
  void draw(const Exposure& exposure, const Moment& frame, const Overlays& overlays,
            const gl::Texture& picture, const Watch& watch);
  /// Sets where the passes of later pictures are kept, replacing earlier contents; null: passes are not
  /// kept.
  void keepPasses(PassPicture* passes);
  /// Keeps light and layers of all later pictures. The CPU waits for them. For cameras with a lens or a
  /// shutter the layers show the first lens point at the first moment.
  void keepLayers(const LightRequest& wanted);
  /// Returns the light and layers of the last picture.
  [[nodiscard]] PictureLayers takeLayers();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel::draw
