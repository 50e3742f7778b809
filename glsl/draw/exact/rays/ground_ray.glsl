// Where rays meet the ground, and how much of it there is at a place: it fades out far from what the camera looks at.
#include "draw/arithmetic.glsl"

vec3 placeAlong(vec3 origin, vec3 along, float t) {
  precise vec3 p = origin + along * t;
  return p;
}

// m along the ray; -1: it does not.
float groundAlong(vec3 origin, vec3 along) {
  precise float down = frame.groundHeight - origin.y;
  bool towards = down < 0.0f ? along.y < -1e-6f : along.y > 1e-6f;
  precise float t = down * exactReciprocal(towards ? along.y : 1.0f);
  precise vec2 aside = origin.xz + along.xz * t - frame.target.xz;
  return towards && max(abs(aside.x), abs(aside.y)) <= frame.groundReach ? t : -1.0f;
}

float groundAlpha(vec3 p) {
  precise vec3 aside = p - frame.target.xyz;
  precise float distance2 = aside.x * aside.x + aside.z * aside.z;
  precise float far = (root(distance2) - frame.groundFadeStart) * frame.perGroundFade;
  precise float alpha = 1.0f - smoothed(clamp(far, 0.0f, 1.0f));
  return alpha;
}
