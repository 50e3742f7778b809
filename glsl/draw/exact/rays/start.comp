// Starts the paths at the visible surface points (spots, see spots.glsl). Each path has a shadow ray to the sun, a
// shadow ray to a lamp, and a continuation ray. One invocation handles one path. Defines: SAMPLES; LAMPS and the other
// light defines; ENVIRONMENT; BALLOT.
#define EXACT_PICTURE
#define LISTS_RAYS
#include "draw/frame_block.glsl"
#include "draw/exact/rays/spot_read.glsl"
#include "draw/exact/rays/lights.glsl"
#include "draw/exact/rays/path_rays.glsl"
#ifdef FINISHED
#include "draw/exact/rays/finished_spot.glsl"
#endif
#ifdef EMITTERS
#include "draw/exact/rays/emitters.glsl"
#endif
layout(local_size_x = 64) in;

Facet facetAt(int at) {
  uvec4 first = texelFetch(spots, 4 * at), second = texelFetch(spots, 4 * at + 1), third = texelFetch(spots, 4 * at + 2);
  vec3 place = uintBitsToFloat(first.xyz);
  precise vec3 to = view.eye.xyz - place;
  float square = max(exactDot(to, to), 1e-12f);
#ifdef PARALLEL
  to = -view.forward.xyz;
#endif
  Facet f = facetOf(place, unpackedUnit(first.w), unpackedUnit(second.w), unitOf(to), uintBitsToFloat(second.xyz),
                    uintBitsToFloat(third.xyz), exactSqrt(square));
  f.lift = uintBitsToFloat(texelFetch(spots, 4 * at + 3).z);
#ifdef FINISHED
  f = finishedSpot(f, at, uintBitsToFloat(second.xyz), uintBitsToFloat(third.y));
#endif
  return f;
}

// Starts the shadow ray to the sun. Continuation rays may hit the sun too, so the light is weighted by the densities of
// both methods. Returns the light that needs no shadow ray (OPEN_SUN).
vec3 towardsSun(int path, Facet f, vec3 u) {
  vec3 direction = sunDirectionAt(u.x, u.y);
  float nl = exactDot(f.normal, direction), angle = sunAngle();
  Lobed lobed = lobeTowards(f, direction);
  precise float both = 1.0f + densityTowards(f, lobed, nl) * angle;
#ifdef FINISHED
  precise float alone = 1.0f + lobed.clearDensity * angle;
  precise vec3 own = (f.matt * mattCosine(f, nl) + lobed.light + lobed.fibres) * exactReciprocal(both) + lobed.clear * exactReciprocal(alone);
  precise vec3 light = frame.sunLight.rgb * own;
#else
  precise vec3 light = frame.sunLight.rgb * (f.matt * mattCosine(f, nl) + lobed.light) * exactReciprocal(both);
#endif
#ifdef OPEN_SUN
  putNone(sunKind, path);
  return light;
#endif
  putLightRay(0, sunKind, path, beginning(f, direction), direction, farAway, light);
  return vec3(0);
}

// Starts the shadow ray to a lamp or to an emitting triangle. One of them is chosen with a probability proportional to
// its light.
void towardsLamp(int path, Facet f, vec3 u) {
  precise float all_ = brightnessOfLamps(f);
  float wanted = u.z, times = 1.0f;
#ifdef EMITTERS
  if (emitterCount > 0) {
    ChosenEmitter e = chosenEmitter(f, u, true);
    precise float both = all_ + e.bright;
    precise float likely = e.bright * exactReciprocal(max(both, 1e-25f));
    if (e.bright > 0.0f && u.z < likely) {
      precise vec3 light = e.light * (both * exactReciprocal(max(e.bright, 1e-25f)));
      putLightRay(1, lampKind, path, beginning(f, e.direction), e.direction, e.far, light);
      return;
    }
    precise float rest = 1.0f - likely;
    precise float left = (u.z - likely) * exactReciprocal(max(rest, 1e-12f));
    precise float more = both * exactReciprocal(max(all_, 1e-25f));
    wanted = clamp(left, 0.0f, 0.999999f);
    times = more;
  }
#endif
#ifdef LAMPS
  Chosen chosen = chosenLamp(f, wanted);
  if (chosen.lamp >= 0) {
    precise vec3 to = lampPlaceAt(f.place, chosen.lamp, u.x, u.y) - f.place;
    vec3 direction = unitOf(to);
    float far = lampReach(f.place, chosen.lamp, direction, exactSqrt(exactDot(to, to)));
    precise vec3 brings = chosen.light * times;
    putLightRay(1, lampKind, path, beginning(f, direction), direction, far, brings);
    return;
  }
#endif
  putNone(lampKind, path);
}

void main() {
  int path = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (path >= paths) return;
  PathStart start = pathStart(path);
  if (!start.there) {
    for (int kind = sunKind; kind <= onwardKind; ++kind) putNone(kind, path);
    rayLight[spotSure * paths + path] = vec4(0);
    return;
  }
#ifdef HAZE
  rayLight[nextSure * paths + path] = vec4(0);
#endif
  Facet f = facetAt(start.at);
  precise vec3 sure = openLamps(f) + towardsSun(path, f, samplePoint(start.number, sampleMask, start.seed, 0u));
  towardsLamp(path, f, samplePoint(start.number, sampleMask, start.seed, 1u));
  Onward onward = onwardFrom(f, samplePoint(start.number, sampleMask, start.seed, 2u));
#ifdef FINISHED
  float note = noteOf(onward.share, onward.roughness);
#else
  float note = onward.share;
#endif
  putRay(onwardKind, path, beginning(f, onward.direction), note, onward.direction, farAway,
         vec4(onward.weight, onward.density));
  rayLight[spotSure * paths + path] = vec4(sure, 0.0f);
}
