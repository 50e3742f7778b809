// Shades the hits of the paths' continuation rays. A ray that leaves the scene adds the sky's light. At a hit point,
// the kernel starts two rays. A shadow ray goes towards one light. A second continuation ray adds the sky's light if
// nothing blocks the ray. One invocation handles one path. Defines: SAMPLES; LAMPS and the other light defines;
// ENVIRONMENT; TRIANGLES, BALLS, GROUND; LAID and the other material defines; BALLOT.
#define EXACT_PICTURE
#define LISTS_RAYS
#include "draw/frame_block.glsl"
#include "draw/exact/rays/spot_read.glsl"
#include "draw/exact/rays/lights.glsl"
#include "draw/exact/rays/path_rays.glsl"
#include "draw/exact/rays/ground_ray.glsl"
#include "draw/exact/rays/found_facet.glsl"
#include "draw/exact/rays/ray_width.glsl"
#include "draw/exact/haze.glsl"
#ifdef FINISHED
#include "draw/exact/rays/finished_spot.glsl"
#endif
#ifdef EMITTERS
#include "draw/exact/rays/emitters.glsl"
#endif
layout(local_size_x = 64) in;
layout(binding = rayUnit) uniform samplerBuffer rays;
layout(binding = rayHitUnit) uniform usamplerBuffer rayHits;
layout(binding = rayLightUnit) uniform samplerBuffer onwardLight;

// Returns the number of rays per steradian that all samples of the pixel together send in a direction. `density` is the
// probability density of one sample.
float allTowards(float density) {
  precise float all_ = density * float(sampleMask + 1u);
  return all_;
}

// Returns the sky's light for a ray, times the fraction `share` of the ray. Includes the sun if the ray was sampled
// from the specular lobe and hits the sun's disc.
vec3 beyond(vec3 direction, float roughness, float lobeShare, float density, float share) {
  precise vec3 light = skyLight(direction, skyFactor(roughness, lobeShare), roughness, lobeShare, allTowards(density));
  float angle = sunAngle();
  precise float likely = density * angle;
  bool sun = likely > 0.0f && isOnSun(direction);
  // The sun's radiance is irradiance / angle. Samples of the lobe have the weight density / (density + 1 / angle)
  // relative to samples of the sun (multiple importance sampling).
  precise float both = 1.0f + likely;
  precise vec3 ofSun = frame.sunLight.rgb * (3.14159265f * density * exactReciprocal(both));
  precise vec3 sum = (sun ? light + ofSun : light) * share;
  return sum;
}

// Starts a shadow ray from a hit point towards one light. The light is the sun, a lamp or an emitting triangle, chosen
// with a probability proportional to its light. Returns the light that needs no shadow ray (OPEN_SUN).
vec3 towardsLight(int path, Facet f, vec3 weight, vec3 u) {
  vec3 direction = sunDirectionAt(u.x, u.y);
  float nl = exactDot(f.normal, direction);
#ifdef FINISHED
  precise vec3 ofSun = frame.sunLight.rgb * (f.matt * mattCosine(f, nl) + mirroredBy(f, lobe(f.normal, f.view, direction, f.alpha)) * max(nl, 0.0f) + overLight(f, direction, f.coatAlpha));
#else
  precise vec3 ofSun = frame.sunLight.rgb * (f.matt * mattCosine(f, nl) + mirroredBy(f, lobe(f.normal, f.view, direction, f.alpha)) * max(nl, 0.0f));
#endif
  precise vec3 light = ofSun;
  float far = farAway, sunWeight = brightnessOf(ofSun), lamps = brightnessOfLamps(f);
  precise float all_ = sunWeight + lamps;
#ifdef EMITTERS
  if (emitterCount > 0) {
    ChosenEmitter e = chosenEmitter(f, u, false);
    precise float both = all_ + e.bright;
    precise float likely = e.bright * exactReciprocal(max(both, 1e-25f));
    if (e.bright > 0.0f && u.z < likely) {
      precise vec3 lit = e.light * weight * (both * exactReciprocal(max(e.bright, 1e-25f)));
      putLightRay(0, nextLightKind, path, beginning(f, e.direction), e.direction, e.far, lit);
      return vec3(0);
    }
    precise float rest = 1.0f - likely;
    precise float left = (u.z - likely) * exactReciprocal(max(rest, 1e-12f));
    precise vec3 more = weight * (both * exactReciprocal(max(all_, 1e-25f)));
    u.z = clamp(left, 0.0f, 0.999999f);
    weight = more;
  }
#endif
#ifdef LAMPS
#if SHADOWED_LAMPS > 0
  precise float wanted = u.z * all_;
  bool sun = wanted < sunWeight;
  precise float rest = (wanted - sunWeight) * exactReciprocal(max(lamps, 1e-25f));
  Chosen chosen = chosenLamp(f, clamp(rest, 0.0f, 0.999999f));
  precise vec3 throughSun = ofSun * (all_ * exactReciprocal(max(sunWeight, 1e-25f)));
  precise vec3 throughLamp = chosen.light * (all_ * exactReciprocal(max(lamps, 1e-25f)));
  if (sun) {
    light = throughSun;
  } else if (chosen.lamp >= 0) {
    precise vec3 to = lampPlaceAt(f.place, chosen.lamp, u.x, u.y) - f.place;
    direction = unitOf(to);
    far = lampReach(f.place, chosen.lamp, direction, exactSqrt(exactDot(to, to)));
    light = throughLamp;
  }
#endif
#endif
  precise vec3 brings = light * weight;
#ifdef OPEN_SUN
  if (far == farAway) {
    putNone(nextLightKind, path);
    return brings;
  }
#endif
  putLightRay(0, nextLightKind, path, beginning(f, direction), direction, far, brings);
  return vec3(0);
}

void main() {
  int path = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (path >= paths) return;
  int ray = onwardKind * paths + path;
  vec4 from = texelFetch(rays, 2 * ray), towards = texelFetch(rays, 2 * ray + 1), weight = texelFetch(onwardLight, ray);
  uvec4 hit = texelFetch(rayHits, ray);
  int at = int(hit.y);
  bool there = towards.w > 0.0f;
  PathStart start = pathStart(path);
#ifdef FINISHED
  float roughness = roughnessOfNote(from.w);
  from.w = shareOfNote(from.w);
#else
  float roughness = uintBitsToFloat(texelFetch(spots, 4 * start.at + 2).x);
#endif
  float share = at < 0 ? 0.0f : 1.0f;
  vec3 p = placeAlong(from.xyz, towards.xyz, uintBitsToFloat(hit.x));
#ifdef GROUND
  share = at == groundHit ? groundAlpha(p) : share;
#endif
  precise float open = 1.0f - share;
  precise vec3 sure = weight.rgb * beyond(towards.xyz, roughness, from.w, weight.w, open);
#ifdef HAZE
  precise vec3 carried = sure + texelFetch(onwardLight, nextSure * paths + path).rgb;
  sure = carried;
#endif
  if (!there || share <= 0.0f) {
    putNone(nextLightKind, path);
    putNone(nextOnwardKind, path);
    rayLight[nextSure * paths + path] = vec4(there ? sure : vec3(0), 0.0f);
    return;
  }
  // A rough surface that receives light from smooth surfaces would get rare, very bright samples. The hit surface is
  // therefore treated as rougher.
  precise float minimum = 0.7f + (roughness - 0.7f) * from.w;
  Facet f = foundFacet(at, p, towards.xyz, uintBitsToFloat(hit.x), uintBitsToFloat(hit.zw), minimum, rayWidth(from.xyz, uintBitsToFloat(hit.x), weight.w));
  precise vec3 through = weight.rgb * share;
#ifdef HAZE
  precise vec3 way = towards.xyz * uintBitsToFloat(hit.x);
  float passes = passed(hazeBehind(from.xyz, way));
  sure = sure + through * hazeInMirror(towards.xyz) * (skyFactor(roughness, from.w) * (1.0f - passes));
  through = through * passes;
#endif
  vec3 certain = towardsLight(path, f, through, samplePoint(start.number, sampleMask, start.seed, 3u));
  Onward onward = onwardFrom(f, samplePoint(start.number, sampleMask, start.seed, 4u));
#ifdef FINISHED
  float ownRoughness = onward.roughness;
#else
  float ownRoughness = f.roughness;
#endif
  precise vec3 brings = through * onward.weight * skyLight(onward.direction, skyFactor(ownRoughness, onward.share), ownRoughness, onward.share,
                                                           allTowards(onward.density));
  putLightRay(1, nextOnwardKind, path, beginning(f, onward.direction), onward.direction, farAway, brings);
  sure = sure + certain + through * openLamps(f);
#ifdef EMITTERS
  if (max(f.emission.x, max(f.emission.y, f.emission.z)) > 0.0f) {
    // Weight of multiple importance sampling: this ray hit the emitter by chance, but emitter sampling could also have
    // chosen the point.
    precise float square = uintBitsToFloat(hit.x) * uintBitsToFloat(hit.x);
    float found = emitterCount > 0 ? emitterDensity(f.sought, square, abs(exactDot(f.facing, towards.xyz))) : 0.0f;
    precise float both = weight.w + found;
    precise float counts = both > 0.0f ? weight.w * exactReciprocal(max(both, 1e-12f)) : 0.0f;
    sure = sure + through * f.emission * counts;
  }
#endif
  rayLight[nextSure * paths + path] = vec4(sure, 0.0f);
}
