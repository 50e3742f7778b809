// Narrows the bounds of the shadow casters in light space to the part that matters for the picture: the part of their
// box, extended without limit away from the sun, that the camera sees. Receivers outside the box are lit, and receivers
// outside the picture are invisible. The box of the result surrounds all corners of the intersection of the box with the
// pyramid of the rays through the picture: ends of the pyramid's edges inside the box, and of the box's edges inside the
// pyramid.
#include "common/exact.glsl"

struct LightBox {
  vec3 low, high;  // x, y: across the light; z: towards the sun (m)
};

// Part of a line from + t along, for which t is between `first` and `last`; empty if first > last.
struct Span {
  float first, last;
};

// Returns the part of the span in which start + t slope >= 0.
Span cutSpan(Span span, float start, float slope) {
  if (abs(slope) < 1e-20f) return start < 0.0f ? Span(1.0f, 0.0f) : span;
  precise float at = -start * exactReciprocal(slope);
  return slope > 0.0f ? Span(max(span.first, at), span.last) : Span(span.first, min(span.last, at));
}

// Extends `seen` by the ends of a span, across the light.
LightBox withEnds(LightBox seen, vec3 from, vec3 along, Span span) {
  if (span.first > span.last) return seen;
  precise vec3 a = from + span.first * along, b = from + span.last * along;
  return LightBox(min(seen.low, min(a, b)), max(seen.high, max(a, b)));
}

vec3 inLight(vec3 v) {
  return vec3(exactDot(v, frame.lightRight.xyz), exactDot(v, frame.lightUp.xyz), exactDot(v, frame.sunDirection.xyz));
}

// Returns the bounds for a perspective camera. Keeps their depths, and all of them if the camera sees no part of the box.
LightBox seenPart(LightBox casters) {
  const float farthest = 1e6f;
  vec3 eye = inLight(frame.eye.xyz);
  vec3 rays[4];
  for (int i = 0; i < 4; ++i) {  // counterclockwise, as seen from the eye
    float x = i == 1 || i == 2 ? 1.0f : -1.0f, y = i < 2 ? -1.0f : 1.0f;
    precise vec3 ray = frame.rayForward.xyz + x * frame.rayRight.xyz + y * frame.rayUp.xyz;
    rays[i] = inLight(ray);
  }
  LightBox seen = LightBox(vec3(3.4e38f), vec3(-3.4e38f));
  for (int i = 0; i < 4; ++i) {
    Span span = Span(0.0f, farthest);
    precise vec3 above = eye - casters.low, below = casters.high - eye;
    for (int axis = 0; axis < 2; ++axis) span = cutSpan(span, above[axis], rays[i][axis]);
    for (int axis = 0; axis < 3; ++axis) span = cutSpan(span, below[axis], -rays[i][axis]);
    seen = withEnds(seen, eye, rays[i], span);
  }
  precise vec3 extent = casters.high - casters.low;
  for (int edge = 0; edge < 8; ++edge) {  // four sides of the top, then the edges away from the sun
    bool right = (edge & 1) != 0, up = (edge & 2) != 0;
    vec3 from = vec3(right ? casters.high.x : casters.low.x, up ? casters.high.y : casters.low.y, casters.high.z);
    vec3 along = vec3(0, 0, -1);
    float length_ = farthest;
    if (edge < 4) {
      bool across = right == up;
      along = across ? vec3(right ? -1.0f : 1.0f, 0, 0) : vec3(0, up ? -1.0f : 1.0f, 0);
      length_ = across ? extent.x : extent.y;
    }
    precise vec3 aside = from - eye;
    Span span = Span(0.0f, length_);
    for (int i = 0; i < 4; ++i) {
      vec3 inwards = exactCross(rays[(i + 1) & 3], rays[i]);
      span = cutSpan(span, exactDot(inwards, aside), exactDot(inwards, along));
    }
    seen = withEnds(seen, from, along, span);
  }
  // 1 % is larger than all rounding errors.
  precise vec3 more = 0.01f * (seen.high - seen.low);
  precise vec3 low = seen.low - more, high = seen.high + more;
  if (seen.low.x > seen.high.x) return casters;
  return LightBox(vec3(max(low.xy, casters.low.xy), casters.low.z), vec3(min(high.xy, casters.high.xy), casters.high.z));
}
