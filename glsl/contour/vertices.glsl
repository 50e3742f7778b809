// How the solid's vertices lie in memory: the samples' own, with a ceiling those of the ceiling above them, what never
// changes, then four of each point of a contour. w of a position is the number of its colour.
#include "contour/types.glsl"
const uint rimBelow = 0u, wallBottom = 1u, wallTop = 2u, rimAbove = 3u;  // of a point's four
// Colours of a class: the face, the face beside a wall that rises, beside one that falls; the wall's foot and top.
const int faceColor = 0, footColor = 1, edgeColor = 2, wallFootColor = 3, wallTopColor = 4, classColors = 5;
layout(std430, binding = drawBinding) restrict readonly buffer DrawBlock { ContourDraw draw; };
layout(std430, binding = positionsBinding) restrict writeonly buffer PositionBlock { vec4 positions[]; };
uniform vec2 corner;    // m: x and z of sample (0, 0)
uniform float spacing;  // m between samples
uniform float heights[LEVELS + 1];  // m: of the classes
uniform uint fixedIndices;          // before all others
uniform uint indexRoom;

vec2 placeAt(vec2 sample_) {
  precise vec2 place = sample_ * spacing + corner;
  return place;
}
