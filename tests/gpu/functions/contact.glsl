ContactStep contactStep;

#include "contact/model.glsl"

// Tests a vertex-face or edge-edge pair of cloths, balls and solids, at the current positions and after a move.
FUNCTION vec4 asked(int i) {
  contactStep.perDt = 64.0f;
  contactStep.recovery = 0.25f;
  contactStep.maxRecovery = 0.03125f;
  contactStep.horizon = 4.0f;
  contactStep.quanta = 65536.0f;
  contactStep.perQuanta = 0.0000152587890625f;
  contactStep.bounceFrom = 0.125f;
  contactStep.vertices = 12;
  contactStep.movable = 9;
  contactStep.balls = 6;
  ivec4 corners = ivec4(someOf(i, 4, 12), someOf(i, 5, 12), someOf(i, 6, 12), someOf(i, 7, 12));
  vec3 a = somePlace(i, 0), b = somePlace(i, 1), c = somePlace(i, 2), d = somePlace(i, 3);
  Near near = nearOfVertex(corners, a, b, c, d);
  if (i % 2 == 0) near = nearOfEdges(corners, a, b, c, d);
  if (i % 5 == 0) return near.shares;
  if (i % 5 == 1) return near.normal;
  vec4 heights = heightsOf(near, a, b, c, d);
  vec3 ways[4];
  for (int k = 0; k < 4; ++k) ways[k] = somePlace(i, 10 + k);
  vec4 after = heightsOf(near, a + ways[0], b + ways[1], c + ways[2], d + ways[3]);
  precise vec4 rises = after - heights;
  float thick = thicknessBetween(corners, 0.0625f, 0.125f);
  vec4 roams = abs(vec4(ways[0], ways[1].x)) * 0.25f;
  if (i % 5 == 2) {
    float says = (isNear(near, heights, rises, thick, roams) ? 1.0f : 0.0f) + (mayMeet(near, roams, thick) ? 2.0f : 0.0f) +
                 (isInside(near) ? 4.0f : 0.0f) + (pushesBall(near, 0.25f) ? 8.0f : 0.0f);
    return vec4(says, gapOf(near, heights), worstGap(near, heights, rises), leftOf(gapOf(near, heights), thick));
  }
  vec4 let = letOf(near, heights, heights, rises, thick);
  if (i % 5 == 3) {
    float through = passes(near, heights, heights, rises, let, thick) ? 1.0f : 0.0f;
    return i % 2 == 0 ? let : vec4(let.x, let.w, through, givenBack(near, ways[0], thick, 0.5f));
  }
  precise vec3 slide = ways[0] - ways[3];
  vec3 correction = correctionOf(near, slide, thick, frictionBetween(0.5f, i % 3 == 0 ? -1.0f : 0.25f), i % 4 == 0 ? 0.0f : 0.125f, i % 3 == 1);
  vec3 kept = keptWithin(a + ways[1], a, 0.5f, min(a, b), max(a, b));
  vec4 carries = carriesOf(near, firstGoesFurther(near, ways[0], ways[1]), heights, after, ways[2], thick);
  precise vec3 all_ = correction + 2.0f * kept + vec3(carries);
  return vec4(all_, float(quantaOf(correction, near.shares.y).x + massWeightOf(near.shares.x)));
}
