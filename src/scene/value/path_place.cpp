#include "scene/value/path_place.hpp"

namespace simreel::scene {

void PathPlace::describe(Fields& fields) {
  fields.text("object", object, "Name of the object whose path it is: a cave.");
  fields.number("progress", progress, fraction, "", "How far along, as a fraction of the path's length.");
  fields.number("height", height, anyNumber, "m", "Over the path.");
  fields.number("side", side, anyNumber, "m", "To the right of the way; negative: to the left.");
}

}  // namespace simreel::scene
