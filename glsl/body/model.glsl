// Linear blend skinning: p' = sum w_i M_i p over the joints i of a vertex p, with the weights w_i and matrices M_i. The
// normal is transformed by the cofactor matrix of sum w_i M_i. Compiles as GLSL and as C++
// (tests/reference/body_twin.hpp). Needs loadPose(i), which returns a row of a joint's matrix. There are three rows per
// joint: first the rows of all joints at the start of the frame, then the rows of all joints at its end.
struct Moment {
  int joints;
  float before;  // Weight of the pose at the start of the frame, 1 - now
  float now;     // Weight of the pose at the end of the frame
};

// Replaces tiny numbers by zero, because drivers disagree on subnormal numbers.
FUNCTION vec3 flushed(vec3 v) {
  return vec3(exactFlush(v.x), exactFlush(v.y), exactFlush(v.z));
}

FUNCTION vec4 poseRow(int joint, int row, Moment moment) {
  int at = 3 * joint + row;
  vec4 begin = loadPose(at);
  vec4 end = loadPose(at + 3 * moment.joints);
  precise vec4 between = begin * moment.before + end * moment.now;
  return between;
}

FUNCTION vec4 blendedRow(uvec4 follow, vec4 weights, int row, Moment moment) {
  vec4 first = poseRow(int(follow.x), row, moment);
  vec4 second = poseRow(int(follow.y), row, moment);
  vec4 third = poseRow(int(follow.z), row, moment);
  vec4 fourth = poseRow(int(follow.w), row, moment);
  precise vec4 sum = first * weights.x + second * weights.y + third * weights.z + fourth * weights.w;
  return vec4(flushed(vec3(sum)), exactFlush(sum.w));
}

// Blended matrix of a vertex, as rows.
struct Blend {
  vec4 row0;
  vec4 row1;
  vec4 row2;
};

FUNCTION Blend blendOf(uvec4 follow, vec4 weights, Moment moment) {
  Blend blend;
  blend.row0 = blendedRow(follow, weights, 0, moment);
  blend.row1 = blendedRow(follow, weights, 1, moment);
  blend.row2 = blendedRow(follow, weights, 2, moment);
  return blend;
}

FUNCTION vec3 skinnedPosition(Blend blend, vec3 rest) {
  precise float x = exactDot(vec3(blend.row0), rest) + blend.row0.w;
  precise float y = exactDot(vec3(blend.row1), rest) + blend.row1.w;
  precise float z = exactDot(vec3(blend.row2), rest) + blend.row2.w;
  return flushed(vec3(x, y, z));
}

FUNCTION vec3 skinnedNormal(Blend blend, vec3 rest) {
  vec3 row0 = vec3(blend.row0);
  vec3 row1 = vec3(blend.row1);
  vec3 row2 = vec3(blend.row2);
  vec3 turned = flushed(vec3(exactDot(flushed(exactCross(row1, row2)), rest), exactDot(flushed(exactCross(row2, row0)), rest),
                             exactDot(flushed(exactCross(row0, row1)), rest)));
  float perLength = exactInverseSqrt(max(exactDot(turned, turned), 1e-24f));
  precise vec3 normal = turned * perLength;
  return flushed(normal);
}
