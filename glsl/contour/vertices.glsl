// Memory layout of a solid's vertices: the vertices of the samples (if there is a ceiling, followed by the ceiling's
// vertices above them), the vertices that never change, then four vertices per contour point. w of a position is the
// colour index.
#include "contour/types.glsl"
const uint rimBelow = 0u, wallBottom = 1u, wallTop = 2u, rimAbove = 3u;  // Indices of the four vertices of a point
// Colours of a class: face, face beside a rising wall, face beside a falling wall, foot of the wall, top of the wall.
const int faceColor = 0, footColor = 1, edgeColor = 2, wallFootColor = 3, wallTopColor = 4, classColors = 5;
layout(std430, binding = drawBinding) restrict readonly buffer DrawBlock { ContourDraw draw; };
layout(std430, binding = positionsBinding) restrict writeonly buffer PositionBlock { vec4 positions[]; };
uniform vec2 corner;    // x and z of sample (0, 0), m
uniform float spacing;  // Distance between samples, m
uniform float heights[LEVELS + 1];  // Height of each class, m
uniform uint fixedIndices;          // Number of constant indices, which precede all others
uniform uint indexRoom;

vec2 placeAt(vec2 sample_) {
  precise vec2 place = sample_ * spacing + corner;
  return place;
}
