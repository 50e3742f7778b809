#include "scene/haze.hpp"

namespace simreel::scene {

namespace {

constexpr Range lengths{1e-3, 1e9};

}  // namespace

void Haze::describe(Fields& fields) {
  fields.number("distance", distance, lengths, "m",
                "Length of a level way at the ground's height that lets 37% (1/e) of the light through. "
                "Twice the length lets 14% through, three times 5%.");
  fields.optionalValue("color", color, Animated<glm::vec3>(glm::vec3(0.68F, 0.80F, 0.93F)),
                       [&](Animated<glm::vec3>& value) {
                         fields.color("color", value, notNegative, "Colour of dense haze, linear RGB.");
                       });
  fields.leftOut("color", "the sky's colour in that direction, below the horizon that of the horizon");
  fields.optionalNumber("height", height, lengths, "m", "Height over which the haze thins to 37% (1/e).");
  fields.leftOut("height", "none: the haze is equally dense at all heights");
  fields.number("start", start, notNegative, "m", "Radius of the clear air around the camera.");
}

}  // namespace simreel::scene
