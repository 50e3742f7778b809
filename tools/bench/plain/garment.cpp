#include "plain.hpp"

#include <cmath>

namespace plain {

namespace {

struct Wide {
  float x, y, z;
};
Wide operator*(const Wide& a, float s) {
  return {a.x * s, a.y * s, a.z * s};
}
Wide operator+(const Wide& a, const Wide& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Wide between(const Vec3& a, const Vec3& b) {
  return {b.x - a.x, b.y - a.y, b.z - a.z};
}
float dot(const Wide& a, const Wide& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
void add(Vec3& to, const Wide& what, float times) {
  to.x += what.x * times;
  to.y += what.y * times;
  to.z += what.z * times;
}

/// Solves the three XPBD constraints of a face together: |fu| = 1, |fv| = 1 and fu.fv / (|fu| |fv|) = 0. fu
/// and fv are the deformed weft and warp directions.
void relax(const Garment::Face& f, std::vector<Vec3>& x, const std::vector<float>& w) {
  const Wide ab = between(x[f.a], x[f.b]), ac = between(x[f.a], x[f.c]);
  const Wide fu = ab * f.p + ac * f.q, fv = ab * f.r + ac * f.s;
  const float lengthU = std::sqrt(dot(fu, fu)), lengthV = std::sqrt(dot(fv, fv));
  const Wide u = fu * (1 / lengthU), v = fv * (1 / lengthV);
  const float sheared = dot(u, v);
  const Wide gu = (v + u * -sheared) * (1 / lengthU), gv = (u + v * -sheared) * (1 / lengthV);
  const float pa = -f.p - f.q, ra = -f.r - f.s;
  const float uu = f.p * f.p * w[f.b] + f.q * f.q * w[f.c] + pa * pa * w[f.a];
  const float uv = f.p * f.r * w[f.b] + f.q * f.s * w[f.c] + pa * ra * w[f.a];
  const float vv = f.r * f.r * w[f.b] + f.s * f.s * w[f.c] + ra * ra * w[f.a];
  const float m11 = uu + f.weft, m22 = vv + f.warp;
  const float m12 = uv * sheared, m13 = uv * dot(u, gv), m23 = uv * dot(v, gu);
  const float m33 = uu * dot(gu, gu) + 2 * uv * dot(gu, gv) + vv * dot(gv, gv) + f.shear;
  const float l21 = m12 / m11, l31 = m13 / m11;
  const float pivot2 = m22 - m12 * l21, l32 = (m23 - m13 * l21) / pivot2;
  const float pivot3 = m33 - m13 * l31 - (m23 - m13 * l21) * l32;
  const float y1 = 1 - lengthU, y2 = 1 - lengthV - l21 * y1, y3 = -sheared - l31 * y1 - l32 * y2;
  const float l3 = y3 / pivot3, l2 = y2 / pivot2 - l32 * l3, l1 = y1 / m11 - l21 * l2 - l31 * l3;
  const Wide alongU = u * l1 + gu * l3, alongV = v * l2 + gv * l3;
  add(x[f.a], alongU * pa + alongV * ra, w[f.a]);
  add(x[f.b], alongU * f.p + alongV * f.r, w[f.b]);
  add(x[f.c], alongU * f.q + alongV * f.s, w[f.c]);
}

}  // namespace

void Garment::step() {
  next_ = position;
  for (std::size_t i = 0; i < position.size(); ++i) {
    if (inverseMass[i] == 0) continue;
    Wide force{0, 0, 0};
    for (int k = firstBend[i]; k < firstBend[i + 1]; ++k)
      force = force + between(position[i], position[bends[k].other]) * -bends[k].stiffness;
    Vec3& v = velocity[i];
    v.y -= gravity * dt;
    add(v, force, inverseMass[i] * dt);
    v = {v.x * kept, v.y * kept, v.z * kept};
    add(next_[i], {v.x, v.y, v.z}, dt);
  }
  for (const Face& face : faces) relax(face, next_, inverseMass);
  for (std::size_t i = 0; i < position.size(); ++i) {
    const Wide d = between(position[i], next_[i]);
    velocity[i] = {d.x / dt, d.y / dt, d.z / dt};
  }
  position.swap(next_);
}

}  // namespace plain
