#include "sim/nodes/sample.hpp"

#include <algorithm>
#include <cmath>

namespace simreel::sim {

namespace {

double dot(const glm::dquat& a, const glm::dquat& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

glm::dquat timesScalar(const glm::dquat& q, double by) {
  return {q.w * by, q.x * by, q.y * by, q.z * by};
}

glm::dquat unitOf(const glm::dquat& q) {
  const double squared = dot(q, q);
  return squared > 1e-30 ? timesScalar(q, 1.0 / std::sqrt(squared)) : glm::dquat(1, 0, 0, 0);
}

/// Returns sin(u a) / sin(a), where cos(a) = 1 + `below`: u (1 + b1 (1 + b2 (1 + ...))) with b_i = (u^2 -
/// i^2) / (i (2i + 1)) * below. If a is at most a right angle, |b_i| is at most 1/2.
double sineShare(double u, double below) {
  double sum = 1;
  for (int i = 44; i >= 1; --i) {
    const double n = i;
    sum = 1 + sum * ((u * u - n * n) / (n * (2 * n + 1)) * below);
  }
  return u * sum;
}

/// Returns the components of a key. Quaternions are not normalized.
glm::dvec4 keyAt(const FigureChannel& channel, std::size_t item) {
  const std::size_t width = channel.path == FigureChannel::Path::rotation ? 4 : 3;
  glm::dvec4 value(0);
  for (std::size_t k = 0; k < width; ++k) value[static_cast<int>(k)] = channel.values[item * width + k];
  return value;
}

glm::dvec4 finished(const FigureChannel& channel, const glm::dvec4& value) {
  if (channel.path != FigureChannel::Path::rotation) return value;
  const glm::dquat q = unitOf(glm::dquat(value.w, value.x, value.y, value.z));
  return {q.x, q.y, q.z, q.w};
}

}  // namespace

glm::dquat slerp(const glm::dquat& from, const glm::dquat& to, double u) {
  const double cosine = dot(from, to);
  const double sign = cosine < 0 ? -1.0 : 1.0;
  const double below = std::min(cosine * sign, 1.0) - 1.0;
  const glm::dquat a = timesScalar(from, sineShare(1 - u, below));
  const glm::dquat b = timesScalar(to, sign * sineShare(u, below));
  return unitOf({a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z});
}

glm::dvec4 sample(const FigureChannel& channel, double seconds) {
  using Interpolation = FigureChannel::Interpolation;
  const bool cubic = channel.way == Interpolation::cubic;
  const auto value = [&](std::size_t key) { return keyAt(channel, cubic ? 3 * key + 1 : key); };
  const auto& times = channel.times;
  const auto next =
      static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), seconds,
                                                [](double at, float key) { return at < double{key}; }) -
                               times.begin());
  if (next == 0) return finished(channel, value(0));
  if (next == times.size() || channel.way == Interpolation::step) return finished(channel, value(next - 1));
  const double length = double{times[next]} - double{times[next - 1]};
  const double u = (seconds - double{times[next - 1]}) / length;
  const glm::dvec4 from = value(next - 1);
  const glm::dvec4 to = value(next);
  if (cubic) {
    // Hermite interpolation uses the out-tangent of the previous key and the in-tangent of the next key;
    // both are per second.
    const glm::dvec4 out = keyAt(channel, 3 * (next - 1) + 2) * length;
    const glm::dvec4 in = keyAt(channel, 3 * next) * length;
    const double u2 = u * u;
    const double u3 = u2 * u;
    return finished(channel, from * (2 * u3 - 3 * u2 + 1) + out * (u3 - 2 * u2 + u) +
                                 to * (3 * u2 - 2 * u3) + in * (u3 - u2));
  }
  if (channel.path != FigureChannel::Path::rotation) return from * (1 - u) + to * u;
  const glm::dquat q = slerp(unitOf(glm::dquat(from.w, from.x, from.y, from.z)),
                             unitOf(glm::dquat(to.w, to.x, to.y, to.z)), u);
  return {q.x, q.y, q.z, q.w};
}

void move(FigureNode& node, const FigureChannel& channel, double seconds) {
  const glm::dvec4 value = sample(channel, seconds);
  switch (channel.path) {
    case FigureChannel::Path::translation:
      node.translation = glm::dvec3(value);
      break;
    case FigureChannel::Path::rotation:
      node.rotation = glm::dquat(value.w, value.x, value.y, value.z);
      break;
    case FigureChannel::Path::scale:
      node.scale = glm::dvec3(value);
      break;
  }
}

glm::dmat4 transformOf(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale) {
  const glm::dquat q = unitOf(rotation);
  // These are the columns of the unit quaternion's rotation matrix, each multiplied by a scale.
  return {glm::dvec4(1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z),
                     2 * (q.x * q.z - q.w * q.y), 0) *
              scale.x,
          glm::dvec4(2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z),
                     2 * (q.y * q.z + q.w * q.x), 0) *
              scale.y,
          glm::dvec4(2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x),
                     1 - 2 * (q.x * q.x + q.y * q.y), 0) *
              scale.z,
          glm::dvec4(translation, 1)};
}

}  // namespace simreel::sim
