#include "scene/stage_presets.hpp"

#include <array>

namespace simreel::scene {

namespace {

constexpr glm::vec3 fromLeft(0.7F, -0.65F, 1.0F);

constexpr StageLook studio{.floor = {0.62F, 0.55F, 0.47F},
                           .horizon = {0.33F, 0.32F, 0.33F},
                           .zenith = {0.28F, 0.32F, 0.40F},
                           .ambient = 0.62F,
                           .keyColor = {1.0F, 0.93F, 0.84F},
                           .key = 3.3F,
                           .keyFrom = fromLeft,
                           .keyDiameter = 9.0F,
                           .rimColor = {1.0F, 0.96F, 0.92F},
                           .rim = 2.2F,
                           .maximum = 0.8F};
constexpr StageLook daylight{.floor = {0.56F, 0.47F, 0.36F},
                             .horizon = {0.55F, 0.68F, 0.84F},
                             .zenith = {0.09F, 0.24F, 0.58F},
                             .ambient = 0.75F,
                             .keyColor = {1.0F, 0.91F, 0.76F},
                             .key = 4.2F,
                             .keyFrom = {0.6F, -0.8F, 1.05F},
                             .keyDiameter = 1.2F,
                             .rimColor = {0.8F, 0.9F, 1.0F},
                             .rim = 0.8F,
                             .maximum = 0.6F,
                             .reach = 14.0F};
constexpr StageLook overcast{.floor = {0.36F, 0.38F, 0.40F},
                             .horizon = {0.60F, 0.64F, 0.69F},
                             .zenith = {0.52F, 0.57F, 0.64F},
                             .ambient = 1.0F,
                             .keyColor = {0.95F, 0.98F, 1.0F},
                             .key = 1.1F,
                             .keyFrom = {0.3F, -0.3F, 1.0F},
                             .keyDiameter = 40.0F,
                             .rimColor = {0.9F, 0.95F, 1.0F},
                             .rim = 0.5F,
                             .maximum = 0.6F,
                             .reach = 14.0F};
constexpr StageLook sunset{.floor = {0.34F, 0.17F, 0.12F},
                           .horizon = {0.95F, 0.42F, 0.16F},
                           .zenith = {0.16F, 0.14F, 0.33F},
                           .ambient = 0.55F,
                           .keyColor = {1.0F, 0.55F, 0.24F},
                           .key = 4.5F,
                           .keyFrom = {0.25F, -1.0F, 0.42F},
                           .keyDiameter = 2.0F,
                           .rimColor = {0.75F, 0.55F, 1.0F},
                           .rim = 2.4F,
                           .maximum = 0.5F,
                           .reach = 14.0F};
// A preset that is dark enough to show objects that glow.
constexpr StageLook glow{.floor = {0.012F, 0.013F, 0.018F},
                         .horizon = {0.030F, 0.036F, 0.062F},
                         .zenith = {0.010F, 0.012F, 0.022F},
                         .ambient = 1.0F,
                         .keyColor = {0.75F, 0.85F, 1.0F},
                         .key = 0.8F,
                         .keyFrom = fromLeft,
                         .keyDiameter = 9.0F,
                         .rimColor = {0.6F, 0.75F, 1.0F},
                         .rim = 0.4F,
                         .maximum = 0.1F};
constexpr StageLook night{.floor = {0.016F, 0.024F, 0.050F},
                          .horizon = {0.040F, 0.060F, 0.13F},
                          .zenith = {0.010F, 0.016F, 0.045F},
                          .ambient = 2.0F,
                          .keyColor = {0.62F, 0.78F, 1.0F},
                          .key = 2.0F,
                          .keyFrom = fromLeft,
                          .keyDiameter = 9.0F,
                          .rimColor = {1.0F, 0.72F, 0.45F},
                          .rim = 1.6F,
                          .maximum = 0.1F};
constexpr StageLook hollow{.floor = {0.002F, 0.002F, 0.002F},
                           .horizon = {0.002F, 0.002F, 0.002F},
                           .zenith = {0.002F, 0.002F, 0.002F},
                           .ambient = 30.0F,
                           .keyColor = {1.0F, 0.96F, 0.90F},
                           .key = 3.0F,
                           .keyFrom = {0.5F, -1.0F, 0.8F},
                           .keyDiameter = 9.0F,
                           .rimColor = {0.70F, 0.82F, 1.0F},
                           .rim = 3.5F,
                           .maximum = 0.0F,
                           .hasFloor = false};
constexpr StageLook paper{.floor = {1.5F, 1.5F, 1.48F},
                          .horizon = {1.5F, 1.5F, 1.48F},
                          .zenith = {1.5F, 1.5F, 1.48F},
                          .ambient = 0.43F,
                          .keyColor = {1.0F, 0.98F, 0.95F},
                          .key = 3.2F,
                          .keyFrom = {0.5F, -0.5F, 1.2F},
                          .keyDiameter = 20.0F,
                          .rimColor = {1.0F, 1.0F, 1.0F},
                          .rim = 0.5F,
                          .maximum = 1.0F,
                          .reach = 6.0F};
constexpr StageLook blueprint{.floor = {0.012F, 0.062F, 0.20F},
                              .horizon = {0.012F, 0.062F, 0.20F},
                              .zenith = {0.012F, 0.062F, 0.20F},
                              .ambient = 2.2F,
                              .keyColor = {0.85F, 0.94F, 1.0F},
                              .key = 2.4F,
                              .keyFrom = fromLeft,
                              .keyDiameter = 6.0F,
                              .rimColor = {0.7F, 0.9F, 1.0F},
                              .rim = 2.0F,
                              .maximum = 0.6F,
                              .palette = Stage::Palette::ocean};

// Adjacent colours of each palette differ in hue or in brightness.
constexpr std::array vivid = {glm::vec3(0.70F, 0.105F, 0.045F),    // vermilion
                              glm::vec3(0.014F, 0.17F, 0.19F),     // petrol
                              glm::vec3(0.76F, 0.37F, 0.025F),     // saffron
                              glm::vec3(0.045F, 0.085F, 0.30F),    // ultramarine
                              glm::vec3(0.82F, 0.74F, 0.63F),      // ivory
                              glm::vec3(0.20F, 0.030F, 0.085F),    // plum
                              glm::vec3(0.20F, 0.36F, 0.17F),      // sage
                              glm::vec3(0.035F, 0.039F, 0.048F)};  // graphite
constexpr std::array earth = {glm::vec3(0.36F, 0.12F, 0.055F),  glm::vec3(0.62F, 0.45F, 0.24F),
                              glm::vec3(0.10F, 0.085F, 0.045F), glm::vec3(0.48F, 0.26F, 0.085F),
                              glm::vec3(0.78F, 0.68F, 0.50F),   glm::vec3(0.16F, 0.19F, 0.085F)};
constexpr std::array pastel = {glm::vec3(0.80F, 0.38F, 0.36F), glm::vec3(0.36F, 0.60F, 0.66F),
                               glm::vec3(0.86F, 0.72F, 0.40F), glm::vec3(0.50F, 0.44F, 0.74F),
                               glm::vec3(0.48F, 0.70F, 0.46F), glm::vec3(0.86F, 0.60F, 0.68F)};
constexpr std::array grey = {glm::vec3(0.72F), glm::vec3(0.10F), glm::vec3(0.40F), glm::vec3(0.025F),
                             glm::vec3(0.22F)};
constexpr std::array ocean = {glm::vec3(0.80F, 0.88F, 0.92F), glm::vec3(0.045F, 0.30F, 0.52F),
                              glm::vec3(0.30F, 0.62F, 0.70F), glm::vec3(0.012F, 0.085F, 0.21F),
                              glm::vec3(0.55F, 0.74F, 0.62F)};
constexpr std::array neon = {glm::vec3(0.92F, 0.018F, 0.30F), glm::vec3(0.018F, 0.62F, 0.80F),
                             glm::vec3(0.90F, 0.72F, 0.012F), glm::vec3(0.28F, 0.028F, 0.80F),
                             glm::vec3(0.11F, 0.80F, 0.095F)};

}  // namespace

const StageLook& stageLook(Stage::Preset preset, bool shining) {
  switch (preset) {
    case Stage::Preset::daylight:
      return daylight;
    case Stage::Preset::overcast:
      return overcast;
    case Stage::Preset::sunset:
      return sunset;
    case Stage::Preset::night:
      return night;
    case Stage::Preset::hollow:
      return hollow;
    case Stage::Preset::paper:
      return paper;
    case Stage::Preset::blueprint:
      return blueprint;
    case Stage::Preset::automatic:
      return shining ? glow : studio;
    default:
      return studio;
  }
}

std::span<const glm::vec3> stageColors(Stage::Palette palette) {
  switch (palette) {
    case Stage::Palette::earth:
      return earth;
    case Stage::Palette::pastel:
      return pastel;
    case Stage::Palette::grey:
      return grey;
    case Stage::Palette::ocean:
      return ocean;
    case Stage::Palette::neon:
      return neon;
    default:
      return vivid;
  }
}

}  // namespace simreel::scene
