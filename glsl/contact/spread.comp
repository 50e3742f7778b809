// Propagates displacements by solids: cloth that a solid carries also carries the cloth ahead of it. One invocation per
// near pair.
#include "contact/kernel.glsl"
#include "contact/near_list.glsl"
#include "contact/carry.glsl"

void main() {
  int i = nearIndex();
  if (i >= nearsThere()) return;
  Near near = nearAt(i);
  ivec4 c = cornersOf(near);
  vec3 now[4], carried[4];
  bool any = false;
  for (int k = 0; k < 4; ++k) {
    now[k] = pointAt(nowSection, c[k]).xyz;
    precise vec3 way = startOf(c[k]) - now[k];
    carried[k] = way;
    any = any || way != vec3(0.0f);
  }
  if (!any || meetsSolid(near)) return;
  vec4 heights = heightsOf(near, now[0], now[1], now[2], now[3]);
  precise vec4 after = heights + heightsOf(near, carried[0], carried[1], carried[2], carried[3]);
  float thick = thicknessOf(c);
  if (gapOf(near, after) >= leftOf(gapOf(near, heights), thick)) return;
  vec3 way = wayOfSide(near, true, carried[0], carried[1], carried[2], carried[3]);
  vec3 otherWay = wayOfSide(near, false, carried[0], carried[1], carried[2], carried[3]);
  bool first = firstGoesFurther(near, way, otherWay);
  vec3 leading = first ? way : otherWay;
  carryAll(c, carriesOf(near, first, heights, after, leading, thick), leading);
}
