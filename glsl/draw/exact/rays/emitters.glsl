// Emitting triangles as light sources for sampling. A triangle is chosen with a probability proportional to its area
// times brightness; then a uniformly distributed point on it. Defines: EMITTERS, LAID.
#include "draw/exact/rays/looks.glsl"
// One entry per emitter. x: end of its interval in a cumulative distribution over 0..2^24; y: index of the triangle.
layout(binding = rayEmitterUnit) uniform usamplerBuffer emitters;
layout(binding = solidPlaceUnit) uniform samplerBuffer solidPlaces;
#include "draw/exact/rays/solid_words.glsl"
#ifdef LAID
#include "draw/exact/rays/lays.glsl"
#endif
const int emitterCandidates = 4;   // number of points of which one gets a shadow ray
const float perCandidate = 0.25f;  // 1 / emitterCandidates
uniform int emitterCount;
uniform float perEmission;  // 1 / (sum of area times brightness over all emitters)

// Returns the first emitter whose interval ends above u.
int emitterAt(float u) {
  precise float part = u * 16777216.0f;
  uint wanted = uint(int(part));
  int low = 0, high = emitterCount - 1;
  while (low < high) {
    int middle = (low + high) >> 1;
    bool before = texelFetch(emitters, middle).x <= wanted;
    low = before ? middle + 1 : low;
    high = before ? high : middle;
  }
  return low;
}

// Returns the density (1/sr) with which emitter sampling chooses a point. `square` is the squared distance to the
// point. `cosine` is the cosine at the emitter.
float emitterDensity(vec3 emission, float square, float cosine) {
  precise float density = brightnessOf(emission) * perEmission * square * exactReciprocal(max(cosine, 1e-4f));
  return density;
}

struct Emitting {
  vec3 direction;
  float far;       // distance to the emitter in metres, slightly shortened
  vec3 emission;
  float density;   // density in 1/sr; 0 if there is no usable sample
};
Emitting emittingTowards(vec3 p, vec3 u) {
  int id = int(texelFetch(emitters, emitterAt(u.z)).y);
  ivec3 v = ivec3(int(texelFetch(corners, 3 * id).x), int(texelFetch(corners, 3 * id + 1).x), int(texelFetch(corners, 3 * id + 2).x));
  vec3 a = texelFetch(solidPlaces, v.x).xyz, b = texelFetch(solidPlaces, v.y).xyz, c = texelFetch(solidPlaces, v.z).xyz;
  float side = exactSqrt(u.x);
  precise vec3 weight = vec3(1.0f - side, side * (1.0f - u.y), side * u.y);
  precise vec3 to = a * weight.x + b * weight.y + c * weight.z - p;
  precise vec3 first = b - a;
  precise vec3 second = c - a;
  vec3 across = exactCross(first, second);
  float area2 = exactDot(across, across), square = exactDot(to, to);
  bool there = area2 > 1e-28f && square > 1e-14f;
  Emitting found;
  found.direction = there ? unitOf(to) : vec3(0, 1, 0);
  precise float cosine = abs(exactDot(across, found.direction)) * exactInverseSqrt(max(area2, 1e-30f));
  precise float far = exactSqrt(square) * 0.9999f;
  found.far = far;
  int owner = int(texelFetch(vertexWords, v.x).w);
  found.emission = lookOf(owner, lightLook).rgb;
  found.density = there && cosine > 1e-4f ? emitterDensity(found.emission, square, cosine) : 0.0f;
#ifdef LAID
  ivec4 map = ivec4(lookWords(owner, emissionMapLook));
  vec4 how = lookOf(owner, laidLook);
  if (map.x > 0 && how.w <= 0.0f) {
    precise vec2 uv = (texelFetch(lays, v.x).xy * weight.x + texelFetch(lays, v.y).xy * weight.y + texelFetch(lays, v.z).xy * weight.z) * how.xy;
    precise vec3 part = found.emission * mapAt(Seen(uv, vec2(0), vec2(0)), map).rgb;
    found.emission = part;
  }
#endif
  return found;
}

// Returns the emitter's light that a facet reflects to the viewer. `weighed` is true if continuation rays may hit the
// emitter too; the weight of multiple importance sampling is then applied.
vec3 emittedLight(Facet f, Emitting e, bool weighed) {
  Lobed lobed = lobeTowards(f, e.direction);
  float nl = exactDot(f.normal, e.direction);
  precise vec3 own = f.matt * mattCosine(f, nl) + lobed.light;
#ifdef FINISHED
  own = own + lobed.fibres;
#endif
  precise float either = e.density + (weighed ? densityTowards(f, lobed, nl) : 0.0f);
  precise vec3 light = e.emission * own * (0.31830989f * exactReciprocal(max(either, 1e-12f)));
#ifdef FINISHED
  precise float clearly = e.density + (weighed ? lobed.clearDensity : 0.0f);
  light = light + e.emission * (lobed.clear * 0.31830989f * exactReciprocal(max(clearly, 1e-12f)));
#endif
  return e.density > 0.0f ? light : vec3(0);
}

// A point of an emitter, chosen among `emitterCandidates` points in proportion to the light that a facet reflects
// (Talbot, Cline and Egbert, "Importance Resampling for Global Illumination", EGSR 2005). Its light is divided by that
// probability, so its brightness is the mean brightness of all candidates.
struct ChosenEmitter {
  vec3 direction;
  float far;
  vec3 light;
  float bright;  // brightness of `light`; 0 if there is no light
};
ChosenEmitter chosenEmitter(Facet f, vec3 u, bool weighed) {
  ChosenEmitter chosen = ChosenEmitter(vec3(0, 1, 0), 0.0f, vec3(0), 0.0f);
  uvec3 mixed = hash3(floatBitsToUint(u));
  float pick = unitFraction(mixed.x), emitter = unitFraction(mixed.y);
  precise float all_ = 0.0f;
  for (int i = 0; i < emitterCandidates; ++i) {
    precise float part = (emitter + float(i)) * perCandidate;
    Emitting e = emittingTowards(f.place, vec3(u.xy, part));
    vec3 light = emittedLight(f, e, weighed);
    float bright = brightnessOf(light);
    all_ = all_ + bright;
    precise float likely = bright * exactReciprocal(max(all_, 1e-25f));
    bool here = bright > 0.0f && pick < likely;
    precise float within = pick * exactReciprocal(max(likely, 1e-12f));
    precise float rest = 1.0f - likely;
    precise float beyond_ = (pick - likely) * exactReciprocal(max(rest, 1e-12f));
    pick = clamp(here ? within : beyond_, 0.0f, 0.999999f);
    if (here) {
      chosen.direction = e.direction;
      chosen.far = e.far;
      chosen.light = light;
      chosen.bright = bright;
    }
    precise vec2 next = u.xy + vec2(0.75487766f, 0.56984029f);  // the R2 sequence of Roberts
    precise vec2 after = next - vec2(next.x < 1.0f ? 0.0f : 1.0f, next.y < 1.0f ? 0.0f : 1.0f);
    u.xy = after;
  }
  precise float mean = all_ * perCandidate;
  precise vec3 light = chosen.light * (mean * exactReciprocal(max(chosen.bright, 1e-25f)));
  chosen.light = light;
  chosen.bright = chosen.bright > 0.0f ? mean : 0.0f;
  return chosen;
}
