#include "scene/value/path_place.hpp"

namespace simreel::scene {

void PathPlace::describe(Fields& fields) {
  fields.text("object", object, "Name of the object whose path it is: a cave.");
  fields.number("progress", progress, fraction, "", "Place on the path, as a fraction of its length.");
  fields.number("height", height, anyNumber, "m", "Height over the path.");
  fields.number("side", side, anyNumber, "m", "To the right of the way; negative: to the left.");
}

}  // namespace simreel::scene
