#include "scene/framing.hpp"

#include "base/ieee.hpp"
#include "scene/beside.hpp"
#include "scene/covering.hpp"
#include "scene/drawn_on.hpp"
#include "scene/framed_in_part.hpp"
#include "scene/outline.hpp"
#include "scene/panels.hpp"
#include "scene/picture_area.hpp"
#include "scene/set_apart.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

namespace simreel::scene {

namespace {

/// Returns the unit vector from the target to the camera. The camera views flat boxes from above. It views
/// tall boxes almost level and slightly from the side, so that their depth shows.
glm::vec3 backFrom(const Box& box) {
  const glm::vec3 extent = box.max - box.min;
  const bool tall = extent.y > 0.5F * std::max(extent.x, extent.z);
  return glm::normalize(tall ? glm::vec3(-0.5F, 0.4F, 1) : glm::vec3(0, 1.15F, 1));
}

void addCorners(const Box& box, std::vector<glm::vec3>& points) {
  for (int i = 0; i < 8; ++i)
    points.emplace_back((i & 1) == 0 ? box.min.x : box.max.x, (i & 2) == 0 ? box.min.y : box.max.y,
                        (i & 4) == 0 ? box.min.z : box.max.z);
}

/// Appends 124 points on the surface of the ellipsoid inscribed in the box, roughly evenly distributed.
void addEllipsoid(const Box& box, std::vector<glm::vec3>& points) {
  constexpr int reach = 2;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y)
      for (int z = -reach; z <= reach; ++z)
        if (const glm::vec3 way(x, y, z); way != glm::vec3(0))
          points.push_back(0.5F * (box.min + box.max) +
                           0.5F * (box.max - box.min) * (way / glm::length(way)));
}

/// Orientation and angles of view of a camera. `back` is the unit vector from target to camera. `wide` and
/// `high` are the tangents of the half angles of view.
struct ViewAxes {
  glm::vec3 back, right, up;
  float wide, high;
};

/// Returns the smallest camera distance from `target` at which all points are in the picture. A point c
/// relative to the target is in the picture from distance d if |c . up| <= high (d - c . back), and
/// likewise for `right`.
float distanceOf(const ViewAxes& look, const glm::vec3& target, const std::vector<glm::vec3>& points) {
  float distance = 0;
  for (const glm::vec3& point : points) {
    const glm::vec3 from = point - target;
    const float before = glm::dot(from, look.back);
    distance = std::max({distance, before + std::abs(glm::dot(from, look.up)) / look.high,
                         before + std::abs(glm::dot(from, look.right)) / look.wide});
  }
  return distance;
}

/// Returns the target moved sideways so that opposite margins around the points are equal. Uses a few
/// iterations, so the result is approximate.
glm::vec3 centred(const ViewAxes& look, glm::vec3 target, const std::vector<glm::vec3>& points) {
  constexpr int looks = 4;
  for (int i = 0; i < looks; ++i) {
    const float distance = distanceOf(look, target, points);
    glm::vec2 low(1e9F);
    glm::vec2 high(-1e9F);
    for (const glm::vec3& point : points) {
      const glm::vec3 from = point - target;
      const glm::vec2 seen = glm::vec2(glm::dot(from, look.right), glm::dot(from, look.up)) /
                             std::max(distance - glm::dot(from, look.back), 1e-3F * distance);
      low = glm::min(low, seen);
      high = glm::max(high, seen);
    }
    const glm::vec2 aside = 0.5F * distance * (low + high);
    target += aside.x * look.right + aside.y * look.up;
  }
  return target;
}

/// Returns all points that must be in view. An object with outermost points contributes these points.
/// Otherwise a round box contributes points of its ellipsoid, and another box contributes its corners.
std::vector<glm::vec3> pointsOf(const std::vector<Framed>& framed) {
  std::vector<glm::vec3> points;
  for (const Framed& one : framed)
    if (!one.points.empty())
      points.insert(points.end(), one.points.begin(), one.points.end());
    else
      one.box.round ? addEllipsoid(one.box, points) : addCorners(one.box, points);
  return points;
}

bool hasPoints(const std::vector<Framed>& framed) {
  return std::any_of(framed.begin(), framed.end(), [](const Framed& one) { return !one.points.empty(); });
}

constexpr float stageLens = 26.0F;  // vertical angle of view on a stage, in degrees
/// Returns the fraction of the picture's width and height that the objects may fill.
float filledFraction(const Scene& scene) {
  return scene.staged ? 0.8F : 0.92F;
}

/// Returns the view from direction `back`, with tangents reduced by taken() to leave a margin.
ViewAxes lookFrom(const glm::vec3& back, const Scene& scene) {
  ViewAxes look{};
  const float half = 0.5F * glm::radians(scene.camera.fieldOfView.at(0));
  look.back = back;
  look.right = glm::normalize(glm::vec3(back.z, 0, -back.x));
  look.up = glm::normalize(glm::vec3(0, 1, 0) - back * back.y);
  look.high = filledFraction(scene) * static_cast<float>(ieee::tan(static_cast<double>(half)));
  const glm::ivec2 size = viewSize(scene);
  look.wide = look.high * static_cast<float>(size.x) / static_cast<float>(size.y);
  return look;
}

/// Gives an orthographic camera the view height that a perspective camera shows at `distance`. Does nothing
/// if the scene gives the height.
void matchViewHeight(Camera& camera, float distance) {
  if (camera.projection != Projection::orthographic || camera.hasHeight) return;
  const double half = 0.5 * static_cast<double>(glm::radians(camera.fieldOfView.at(0)));
  camera.height = 2 * distance * static_cast<float>(ieee::tan(half));
}

void reach(Camera& camera, float distance, float nearest, bool staged) {
  camera.near = std::min(camera.near, 0.5F * (distance - nearest));
  camera.far = std::max(camera.far, (staged ? 12.0F : 4.0F) * distance);
}

/// Returns the box of the rectangle on which an object is drawn. Returns nullopt if the source requests its
/// own box.
std::optional<Box> boxOfSource(const DrawnOn& drawn, std::span<const Object> all) {
  const auto source = std::find_if(all.begin(), all.end(),
                                   [&](const Object& object) { return object.name == drawn.source(); });
  if (source == all.end() || !source->parameters || source->parameters->framed()) return std::nullopt;
  return source->parameters->framedAlone();
}

std::optional<Box> boxOf(const Object& object, std::span<const Object> all) {
  if (!object.parameters) return std::nullopt;
  const auto* drawn = dynamic_cast<const DrawnOn*>(object.parameters.get());
  if (drawn != nullptr && drawn->framesSource()) return boxOfSource(*drawn, all);
  const auto* inPart = dynamic_cast<const FramedInPart*>(object.parameters.get());
  const std::optional<Box> whole = inPart == nullptr ? std::nullopt : inPart->framedWhole();
  const auto isOther = [&](const Object& other) {
    return &other != &object && other.parameters && other.parameters->framed();
  };
  return whole && std::any_of(all.begin(), all.end(), isOther) ? whole : object.parameters->framed();
}

/// Returns the point at which the scene aims the camera. This is the scene's target, or the centre of the
/// extent that the tracked object has over its whole motion. Returns nullopt if the scene gives neither a
/// target nor a tracked object.
std::optional<glm::vec3> aimPoint(const Scene& scene) {
  const Camera& camera = scene.camera;
  if (camera.aimed) return camera.target.at(0);
  if (!camera.track) return std::nullopt;
  for (const Object& object : scene.objects)
    if (object.name == camera.track->object)
      if (const std::optional<Framed> one = framedOf(object, scene.objects))
        return 0.5F * (one->box.min + one->box.max) + camera.track->offset;
  return std::nullopt;
}

/// Returns the angles of an orbit in degrees, at most 15 apart. They go from the smallest to the largest
/// key, or round a whole turn.
std::vector<double> turnsOf(const Orbit& orbit) {
  double low = 1e9, high = -1e9;
  for (const auto& key : orbit.turn.keys()) {
    low = std::min(low, static_cast<double>(key.value));
    high = std::max(high, static_cast<double>(key.value));
  }
  constexpr double apart = 15;
  if (high - low >= 360 - apart) low = 0, high = 360 - apart;
  const int steps = static_cast<int>(std::ceil((high - low) / apart));
  std::vector<double> turns = {low};
  for (int i = 1; i <= steps; ++i) turns.push_back(low + (high - low) * i / steps);
  return turns;
}

/// Places an orbiting camera. The target is the centre of all extents or of the tracked object; if the
/// camera does not turn, the visible extent is centred. The distance keeps all points in view at every
/// angle of the orbit and at every key of the elevation.
void frameOrbit(Scene& scene, const std::vector<Framed>& framed) {
  Camera& camera = scene.camera;
  if (scene.staged && !camera.hasAngle) camera.fieldOfView = stageLens;
  const Box box = boxAround(framed);
  const std::optional<glm::vec3> aim = aimPoint(scene);
  glm::vec3 target = aim.value_or(0.5F * (box.min + box.max));
  const std::vector<glm::vec3> points = pointsOf(framed);
  constexpr double radiansPerDegree = 0.017453292519943295;
  const std::vector<double> turns = turnsOf(*camera.orbit);
  const bool stands = turns.size() == 1 && camera.orbit->elevation.keys().size() == 1;
  const glm::vec2 room = stands && !aim ? roomBeside(scene) : glm::vec2(0);
  glm::vec3 aside(0);  // from the picture's centre to the centre of the free area, per metre of distance
  float distance = 0, nearest = 0;
  for (const auto& key : camera.orbit->elevation.keys())
    for (const double degrees : turns) {
      const double turn = degrees * radiansPerDegree;
      const double rise = static_cast<double>(key.value) * radiansPerDegree;
      const glm::vec3 back(ieee::cos(rise) * ieee::sin(turn), ieee::sin(rise),
                           ieee::cos(rise) * ieee::cos(turn));
      ViewAxes look = lookFrom(back, scene);
      const glm::vec2 off = room * glm::vec2(look.wide, look.high) / filledFraction(scene);
      aside = off.x * look.right - off.y * look.up;
      look.wide *= 1 - room.x;
      look.high *= 1 - room.y;
      if (stands && !aim) target = centred(look, target, points);
      distance = std::max(distance, distanceOf(look, target, points));
      for (const glm::vec3& point : points) nearest = std::max(nearest, glm::dot(point - target, back));
    }
  camera.target = room == glm::vec2(0) ? target : target + distance * aside;
  camera.orbit->distance = distance;
  matchViewHeight(camera, distance);
  reach(camera, distance, nearest, scene.staged);
}

}  // namespace

std::optional<Framed> framedOf(const Object& object, std::span<const Object> all) {
  const std::optional<Box> box = boxOf(object, all);
  if (!box) return std::nullopt;
  Framed framed{*box};
  if (const auto* outlined = dynamic_cast<const Outlined*>(object.parameters.get()))
    framed.points = outlined->outline();
  return framed;
}

std::vector<Framed> framedObjects(const Scene& scene) {
  std::vector<Framed> framed;
  for (const Object& object : scene.objects)
    if (std::optional<Framed> one = framedOf(object, scene.objects)) framed.push_back(std::move(*one));
  if (!framed.empty()) return framed;
  for (const Object& object : scene.objects)
    if (object.parameters)
      if (const std::optional<Box> box = object.parameters->framedAlone()) framed.push_back({*box});
  return framed;
}

void setApart(Scene& scene) {
  const auto apart = [](const Object& object) { return dynamic_cast<SetApart*>(object.parameters.get()); };
  if (std::none_of(scene.objects.begin(), scene.objects.end(), apart)) return;
  std::vector<Framed> others;
  for (const Object& object : scene.objects)
    if (apart(object) == nullptr)
      if (std::optional<Framed> one = framedOf(object, scene.objects)) others.push_back(std::move(*one));
  for (const Object& object : scene.objects)
    if (SetApart* const text = apart(object); text != nullptr && !others.empty()) {
      text->standAbove(boxAround(others));
      if (std::optional<Framed> one = framedOf(object, scene.objects)) others.push_back(std::move(*one));
    }
}

Box boxAround(const std::vector<Framed>& framed) {
  Box all = framed.front().box;
  for (const Framed& one : framed) all = {glm::min(all.min, one.box.min), glm::max(all.max, one.box.max)};
  return all;
}

glm::vec3 stageBack(const Box& box) {
  const glm::vec3 extent = box.max - box.min;
  const float height = std::min(extent.y / std::max(0.5F * std::max(extent.x, extent.z), 1e-6F), 1.0F);
  return glm::normalize(glm::vec3(-0.62F, 0.8F - 0.42F * height, 1));
}

glm::vec2 roomBeside(const Scene& scene) {
  glm::vec2 room(0);
  if (!scene.panels.empty()) return room;
  for (const Object& object : scene.objects)
    if (const auto* takes = dynamic_cast<const TakesRoom*>(object.parameters.get()))
      room = glm::max(room, takes->room());
  return room;
}

void makeRoom(Scene& scene) {
  const glm::vec2 room = roomBeside(scene);
  if (room == glm::vec2(0)) return;
  for (Object& object : scene.objects)
    if (auto* field = dynamic_cast<Covering*>(object.parameters.get()))
      if (field->covering() == Covering::Extent::whole) field->leaveRoom(room);
}

void moveAside(Scene& scene) {
  std::vector<PictureArea> taken;
  for (const Object& object : scene.objects)
    if (const auto* takes = dynamic_cast<const TakesArea*>(object.parameters.get()))
      taken.push_back(takes->area());
  for (Object& object : scene.objects)
    if (auto* moves = dynamic_cast<MovesAside*>(object.parameters.get())) moves->moveAside(taken);
}

void frameObjects(Scene& scene, const std::vector<Framed>& framed) {
  Camera& camera = scene.camera;
  if (camera.placed || framed.empty()) return;
  if (camera.orbit) return frameOrbit(scene, framed);
  if (scene.staged && !camera.hasAngle) camera.fieldOfView = stageLens;
  const Box box = boxAround(framed);
  ViewAxes look = lookFrom(scene.staged ? stageBack(box) : backFrom(box), scene);
  const std::optional<glm::vec3> aim = aimPoint(scene);
  const glm::vec2 room = aim ? glm::vec2(0) : roomBeside(scene);
  // Distance, per metre of distance from the eye, by which the picture's centre is beside the free area's.
  const glm::vec2 aside = room * glm::vec2(look.wide, look.high) / filledFraction(scene);
  look.wide *= 1 - room.x;
  look.high *= 1 - room.y;
  glm::vec3 target = aim.value_or(0.5F * (box.min + box.max));
  std::vector<glm::vec3> points;
  if (scene.staged || hasPoints(framed)) {
    points = pointsOf(framed);
    if (!aim) target = centred(look, target, points);
  } else {
    addCorners(box, points);
  }
  float nearest = 0;  // largest extent of the points from the target towards the camera, in metres
  for (const glm::vec3& point : points) nearest = std::max(nearest, glm::dot(point - target, look.back));
  const float distance = distanceOf(look, target, points);
  if (room != glm::vec2(0)) target += distance * (aside.x * look.right - aside.y * look.up);
  if (!camera.aimed) camera.target = target;
  camera.position = target + distance * look.back;
  matchViewHeight(camera, distance);
  reach(camera, distance, nearest, scene.staged);
}

}  // namespace simreel::scene
