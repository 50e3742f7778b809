// Stretch and shear of a face, and seams. Compiles as GLSL and as C++. Needs `stepData` (ClothStep) and
// common/exact.glsl.
//
// A face has the corners a, b and c, and the area A. `shape` = (p, q, r, s) is the inverse ((p, r), (q, s)) of the
// matrix of its edges in the rest shape, along weft and warp. The deformation gradient has the columns fu = (b - a) p +
// (c - a) q and fv = (b - a) r + (c - a) s. XPBD enforces the constraints |fu| = 1, |fv| = 1 and fu.fv / (|fu| |fv|) =
// 0 with the compliances 1 / (k A). The energy is therefore A / 2 (weft eu^2 + warp ev^2 + shear g^2), where eu, ev and
// g are the three constraint errors; it does not depend on the mesh if the strain is even. The three constraints of a
// face are solved together: (J W J^T + compliance / h^2) l = -C, with the Jacobian J, the inverse masses W, the
// multipliers l and the errors C. Damping preserves the part `kept` of C (keptStrain; compare keptStretch in
// cloth/model.glsl).
struct FaceShift {
  vec3 a, b, c;  // Displacement of each corner in metres, per unit of its inverse mass
};

FUNCTION vec3 keptStrain(vec3 a, vec3 b, vec3 c, vec4 shape) {
  precise vec3 first = b - a;
  precise vec3 second = c - a;
  precise vec3 fu = first * shape.x + second * shape.y;
  precise vec3 fv = first * shape.z + second * shape.w;
  float squaredU = max(exactDot(fu, fu), 1e-12f);
  float squaredV = max(exactDot(fv, fv), 1e-12f);
  float inverseU = exactInverseSqrt(squaredU);
  float inverseV = exactInverseSqrt(squaredV);
  precise float stretchU = squaredU * inverseU - 1.0f;
  precise float stretchV = squaredV * inverseV - 1.0f;
  precise float sheared = exactDot(fu, fv) * inverseU * inverseV;
  precise vec3 kept = vec3(stretchU, stretchV, sheared) * stepData.dampedPart;
  return kept;
}

FUNCTION FaceShift faceShift(vec4 a, vec4 b, vec4 c, vec4 shape, vec3 compliance, vec3 kept) {
  precise vec3 first = vec3(b) - vec3(a);
  precise vec3 second = vec3(c) - vec3(a);
  precise vec3 fu = first * shape.x + second * shape.y;
  precise vec3 fv = first * shape.z + second * shape.w;
  float squaredU = max(exactDot(fu, fu), 1e-12f);
  float squaredV = max(exactDot(fv, fv), 1e-12f);
  float inverseU = exactInverseSqrt(squaredU);
  float inverseV = exactInverseSqrt(squaredV);
  precise vec3 u = fu * inverseU;
  precise vec3 v = fv * inverseV;
  precise float stretchU = squaredU * inverseU - 1.0f - kept.x;
  precise float stretchV = squaredV * inverseV - 1.0f - kept.y;
  float sheared = exactDot(u, v);
  precise float shear = sheared - kept.z;
  // Gradients of the shear constraint with respect to fu and fv.
  precise vec3 gu = (v - u * sheared) * inverseU;
  precise vec3 gv = (u - v * sheared) * inverseV;
  precise float ofA = -(shape.x + shape.y);
  precise float alsoA = -(shape.z + shape.w);
  precise float uu = shape.x * shape.x * b.w + shape.y * shape.y * c.w + ofA * ofA * a.w;
  precise float uv = shape.x * shape.z * b.w + shape.y * shape.w * c.w + ofA * alsoA * a.w;
  precise float vv = shape.z * shape.z * b.w + shape.w * shape.w * c.w + alsoA * alsoA * a.w;
  float uOnV = exactDot(u, gv);
  float vOnU = exactDot(v, gu);
  float guu = exactDot(gu, gu);
  float guv = exactDot(gu, gv);
  float gvv = exactDot(gv, gv);
  precise float m11 = uu + compliance.x;
  precise float m12 = uv * sheared;
  precise float m13 = uv * uOnV;
  precise float m22 = vv + compliance.y;
  precise float m23 = uv * vOnU;
  precise float m33 = uu * guu + 2.0f * uv * guv + vv * gvv + compliance.z;
  // Solves by an L D L^T factorization. The pivots have a lower bound, because cancellation could round them to zero.
  float inverse1 = exactReciprocal(max(m11, 1e-20f));
  precise float l21 = m12 * inverse1;
  precise float l31 = m13 * inverse1;
  precise float pivot2 = m22 - m12 * l21;
  precise float least2 = m22 * 1e-5f;
  float inverse2 = exactReciprocal(max(max(pivot2, least2), 1e-20f));
  precise float rest32 = m23 - m13 * l21;
  precise float l32 = rest32 * inverse2;
  precise float pivot3 = m33 - m13 * l31 - rest32 * l32;
  precise float least3 = m33 * 1e-5f;
  float inverse3 = exactReciprocal(max(max(pivot3, least3), 1e-20f));
  precise float y2 = stretchU * l21 - stretchV;
  precise float y3 = stretchU * l31 - shear - l32 * y2;
  precise float lambda3 = y3 * inverse3;
  precise float lambda2 = y2 * inverse2 - l32 * lambda3;
  precise float lambda1 = -stretchU * inverse1 - l21 * lambda2 - l31 * lambda3;
  precise vec3 alongU = u * lambda1 + gu * lambda3;
  precise vec3 alongV = v * lambda2 + gv * lambda3;
  precise vec3 shiftA = alongU * ofA + alongV * alsoA;
  precise vec3 shiftB = alongU * shape.x + alongV * shape.z;
  precise vec3 shiftC = alongU * shape.y + alongV * shape.w;
  FaceShift shift;
  shift.a = shiftA;
  shift.b = shiftB;
  shift.c = shiftC;
  return shift;
}

// Returns the force on one corner for cloth that conserves energy (cloth/keeping.glsl): the negative gradient of 1/2
// (k_u eu^2 + k_v ev^2 + k_g g^2). `stiffness` holds the stiffnesses k (N m), the reciprocals of 1 / (k A) + softening
// dt^2 S, where S is the sum of the inverse masses times the squared rest gradients. `left` and `right` are the edges
// to the other two corners; `shape` holds the gradients for these corners.
FUNCTION vec3 membraneForce(vec3 left, vec3 right, vec4 shape, vec3 stiffness) {
  precise vec3 fu = left * shape.x + right * shape.y;
  precise vec3 fv = left * shape.z + right * shape.w;
  float squaredU = max(exactDot(fu, fu), 1e-12f);
  float squaredV = max(exactDot(fv, fv), 1e-12f);
  float inverseU = exactInverseSqrt(squaredU);
  float inverseV = exactInverseSqrt(squaredV);
  precise vec3 u = fu * inverseU;
  precise vec3 v = fv * inverseV;
  float sheared = exactDot(u, v);
  precise float pullU = (squaredU * inverseU - 1.0f) * stiffness.x;
  precise float pullV = (squaredV * inverseV - 1.0f) * stiffness.y;
  precise float turnU = sheared * stiffness.z * inverseU;
  precise float turnV = sheared * stiffness.z * inverseV;
  precise vec3 alongU = u * pullU + (v - u * sheared) * turnU;
  precise vec3 alongV = v * pullV + (u - v * sheared) * turnV;
  precise vec3 force = alongU * (shape.x + shape.y) + alongV * (shape.z + shape.w);
  return force;
}
// Returns `shape` rotated so that it describes the two corners after corner k. The gradients of the three corners sum
// to zero.
FUNCTION vec4 shapeFrom(vec4 shape, uint k) {
  precise float ofU = -(shape.x + shape.y);
  precise float ofV = -(shape.z + shape.w);
  vec4 second = vec4(shape.y, ofU, shape.w, ofV);
  vec4 third = vec4(ofU, shape.x, ofV, shape.z);
  return k == 0u ? shape : k == 1u ? second : third;
}

// Returns the displacement of a stitch's first end per unit of inverse mass; the second end moves in the opposite
// direction. A stitch may be `longest` metres long at the start, and this limit decreases linearly to zero. `perSecond`
// is 1 / closing time.
FUNCTION vec3 stitchShift(vec4 a, vec4 b, float longest, float perSecond) {
  precise float left = 1.0f - float(stepData.substep + 1) * stepData.dt * perSecond;
  precise float rest = longest * max(left, 0.0f);
  precise vec3 d = vec3(b) - vec3(a);
  float squared = max(exactDot(d, d), 1e-20f);
  float inverse = exactInverseSqrt(squared);
  precise float beyond = squared * inverse - rest;
  precise float weight = a.w + b.w;
  precise float part = beyond * inverse * exactReciprocal(max(weight, 1e-20f));
  precise vec3 shift = d * part;
  return beyond > 0.0f && weight > 0.0f ? shift : vec3(0.0f);
}

// Returns the displacement of a vertex towards a pin if its distance from the pin exceeds `longest` metres. The
// stiffness is 1 / compliance (N/m). If `held` is true, the attachment also held the vertex in the previous substep, so
// its trend contains the pull. Otherwise, the vertex is stopped without a trend, so that it does not bounce.
FUNCTION vec3 attachedShift(vec4 here, vec3 pin, float longest, float compliance, bool held) {
  precise vec3 d = pin - vec3(here);
  float squared = max(exactDot(d, d), 1e-20f);
  float inverse = exactInverseSqrt(squared);
  precise float beyond = squared * inverse - longest;
  float perStep = held ? stepData.perReach : stepData.perDt;
  precise float weight = here.w + compliance * perStep * perStep;
  precise float part = beyond * inverse * exactReciprocal(max(weight, 1e-20f)) * here.w;
  precise vec3 shift = d * part;
  return beyond > 0.0f && here.w > 0.0f ? shift : vec3(0.0f);
}
FUNCTION vec4 attached(vec4 here, vec3 pin, float longest, float compliance, bool held) {
  precise vec3 moved = vec3(here) + attachedShift(here, pin, longest, compliance, held);
  return vec4(moved, here.w);
}

// Adds the displacement by an attachment or a seam to the velocity before constraints, because one-sided pulls must not
// enter the trend (cloth/motion.glsl).
FUNCTION vec4 pushed(vec4 aim, vec4 from, vec4 to) {
  precise vec3 velocity = vec3(aim) + (vec3(to) - vec3(from)) * stepData.perDt;
  return vec4(velocity, aim.w);
}

FUNCTION vec4 shifted(vec4 corner, vec3 shift) {
  precise vec3 moved = vec3(corner) + shift * corner.w;
  return vec4(moved, corner.w);
}
