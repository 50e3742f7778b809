#include "particles/types.glsl"

// The members of ParticleStep that the tested functions need.
struct ToldParticles {
  ParticleFields fields, fieldsBefore;
  Pace pace;
  float dt, perTurbulenceSize;
  int count, substep, seed, emitterCount, colliderCount;
  float windDrag;
  ParticleConstants constants;
  TurbulenceConstants turbulence;
  BallConstants balls;
  EmitterStep emitters[2];
  Collider colliders[1];
};
ToldParticles stepData;

#include "gpu/functions/solids_none.glsl"
#include "particles/pairs.glsl"
#include "particles/pace.glsl"
#include "particles/contact/scale.glsl"
#include "particles/model.glsl"

FUNCTION void prepare(int i) {
  blow(i % 3 == 0);
  stepData.fields.acceleration = vec4(0.0f, -10.0f, 0.0f, 0.0f);
  stepData.fields.attractor = vec4(0.5f, 0.25f, -0.5f, 4.0f);
  stepData.fields.turbulenceDrift = vec4(0.25f, 0.5f, 0.75f, 0.0f);
  stepData.fieldsBefore.acceleration = vec4(1.0f, -9.0f, 0.0f, 0.0f);
  stepData.fieldsBefore.attractor = vec4(0.25f, 0.25f, -0.75f, 4.0f);
  stepData.fieldsBefore.turbulenceDrift = vec4(0.125f, 0.5f, 0.5f, 0.0f);
  stepData.dt = 0.125f;
  stepData.constants.damping = i % 2 == 0 ? 0.0f : 0.75f;
  stepData.constants.attractorSoftening = 0.25f;
  stepData.constants.bounce = 0.5f;
  stepData.constants.margin = 0.03125f;
  stepData.balls.sizeExponent = i % 4 == 0 ? 0.0f : 0.5f;
  stepData.balls.perMassReference = 0.75f;
  stepData.pace = paceOf(stepData.dt, stepData.constants.damping);
  stepData.perTurbulenceSize = 1.5f;
  stepData.turbulence.strength = 2.0f;
  stepData.count = 24;
  stepData.substep = 7;
  stepData.seed = 3;
  stepData.emitterCount = 2;
  stepData.colliderCount = 1;
  stepData.windDrag = 0.5f;
  for (int e = 0; e < 2; ++e) {
    stepData.emitters[e].position = vec4(0.5f * float(e), 1.0f, 0.0f, 0.0f);
    stepData.emitters[e].positionBefore = vec4(0.25f, 1.0f, 0.25f, 0.0f);
    stepData.emitters[e].velocity = vec4(somePlace(i, 40 + e), 0.0f);
    stepData.emitters[e].velocityBefore = vec4(somePlace(i, 42 + e), 0.0f);
    stepData.emitters[e].coneHeight = e == 0 ? 0.25f : 1.75f;
    stepData.emitters[e].birthInterval = 0.03125f;
    stepData.emitters[e].firstLived = 0.125f;
    stepData.emitters[e].firstSlot = 4 + 8 * e;
    stepData.emitters[e].slots = 8;
    stepData.emitters[e].firstPlace = 6;
    stepData.emitters[e].newborns = 4;
    stepData.emitters[e].firstSerial = 100 * e + 30;
    stepData.emitters[e].constants.radius = 0.25f;
    stepData.emitters[e].constants.speedVariation = 0.5f;
    stepData.emitters[e].constants.lifetime = 0.5f;
    stepData.emitters[e].constants.lifetimeVariation = 0.25f;
    stepData.emitters[e].constants.mass = 2.0f;
  }
  stepData.colliders[0].a = vec4(0.0f, 0.5f, 0.0f, 0.0f);
  stepData.colliders[0].b = vec4(0.5f, 0.5f, 0.0f, 0.0f);
  stepData.colliders[0].velocityA = vec4(0.0f);
  stepData.colliders[0].velocityB = vec4(0.25f, 0.0f, 0.0f, 0.0f);
  stepData.colliders[0].reach = 0.25f;
  stepData.colliders[0].perLengthSquared = 4.0f;
  stepData.colliders[0].grip = 0.5f;
  stepData.colliders[0].plane = 0;
  stepData.colliders[0].friction = -1.0f;
}

FUNCTION vec4 asked(int i) {
  prepare(i);
  int slot = someOf(i, 0, 24);
  float age = float(someOf(i, 1, 9) - 1) * 0.125f;
  vec4 position = vec4(somePlace(i, 2), 1.0f), velocity = vec4(somePlace(i, 3), age);
  bool attractor = i % 5 < 3, turbulence = i % 7 < 3;
  int what = i % 6;
  if (what == 0) return vec4(fieldAcceleration(fieldsAt(0.25f), vec3(position), attractor, turbulence), lifetimeOf(slot, slot & 1));
  ParticleMotion m;
  if (what == 1) {
    m = moved(slot, position, velocity, somePlace(i, 4));
  } else if (what == 2) {
    m = newbornMoved(i % 2, someOf(i, 5, 4), attractor, turbulence);
  } else {
    m.position = position;
    m.velocity = velocity;
    if (what == 3) m = outOfSolids(m, somePlace(i, 6));
    if (what == 4) m = pulledSinceBirth(m, somePlace(i, 7), paceOf(0.0625f * float(someOf(i, 8, 40)), stepData.constants.damping));
    if (what == 5) {
      precise vec3 fast = vec3(velocity) * (i % 4 == 0 ? 1e9f : 1.0f);
      float lost = isLost(position, vec4(fast, age)) ? 1.0f : 0.0f;
      return vec4(vec3(kicked(velocity, somePlace(i, 9), stepData.pace)), lost);
    }
  }
  return i % 4 < 2 ? vec4(vec3(m.position) + vec3(0.0f), m.velocity.w) : vec4(vec3(m.velocity), m.position.w);
}
