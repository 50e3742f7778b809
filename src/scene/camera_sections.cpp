#include "scene/scene.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace simreel::scene {

namespace {

/// Declares "damping", the camera's lag in seconds; 0 means no lag.
void describeDamping(Fields& fields, double& damping, const char* what) {
  fields.number("damping", damping, {0, 1000}, "s", what);
  constexpr double minimum = 1e-3;
  if (damping > 0 && damping < minimum)
    fields.error("damping", fmt::format("a damping of {:g} s is too short; give 0, or at least {} s",
                                        damping, minimum));
}

/// Warns if the target of a stationary camera lies outside the camera's near and far distance, because the
/// target is then not drawn.
void warnOutsideDepthRange(Fields& fields, const Camera& camera) {
  const bool placed = fields.given("position") || (fields.given("target") && fields.version() == 1);
  if (camera.follow || camera.track || camera.gltf || camera.orbit || !placed || camera.position.moves() ||
      camera.target.moves())
    return;
  const float away = glm::distance(camera.position.at(0), camera.target.at(0));
  if (away > camera.far)
    fields.idle(fields.given("far") ? "far" : "position", "",
                fmt::format("the target is {:.4g} m away, and nothing is drawn beyond \"far\", {:g} m",
                            away, camera.far));
  else if (away < camera.near)
    fields.idle(
        fields.given("near") ? "near" : "position", "",
        fmt::format("the target is {:.4g} m away, and nothing is drawn nearer than \"near\", {:g} m", away,
                    camera.near));
}

}  // namespace

void Follow::describe(Fields& fields) {
  PathPlace::describe(fields);
  fields.number("ahead", ahead, positive, "m",
                "Length of the part of the path ahead; the camera looks at the mean of its points.");
  describeDamping(fields, damping,
                  "Time by which the camera lags behind, smoothly, like a critically damped spring; "
                  "corners become curves. 0: no lag.");
}

void Track::describe(Fields& fields) {
  fields.text("object", object, "Name of the object; the camera looks at its middle.");
  fields.vector("offset", offset, anyNumber, "m",
                "Offset from the object's middle to the place that the camera looks at.");
  describeDamping(
      fields, damping,
      "Time by which the line of sight lags behind the object, smoothly, like a critically damped "
      "spring. 0: no lag.");
}

void CameraFile::describe(Fields& fields) {
  fields.asset("file", file, "glTF or GLB with a camera, perspective or orthographic.");
  fields.text("name", name, "Name of the camera, or of its node; a file with one camera needs none.");
  fields.text("animation", animation, "Name of the file's motion that the camera plays.");
  fields.leftOut("animation", "the first that moves it; without one the camera does not move");
  fields.number("speed", speed, {-100, 100}, "", "Speed of the motion; 2 is twice as fast, -1 backwards.");
  fields.number("start", start, {-1e6, 1e6}, "s", "Time in the motion at time 0 of the scene.");
  fields.boolean("loop", loop, "Starts the motion again when it has ended; else the last pose stays.");
  fields.number("distance", distance, positive, "m",
                "Distance along its line of sight to its target; a lens focuses there, and the ground "
                "fades around it.");
  if (file.empty()) fields.error("file", "a camera of a file needs \"file\": the glTF to read");
}

void Lens::describe(Fields& fields) {
  fields.number("fNumber", fNumber, {0.01, 1000}, "",
                "Focal length over the diameter of the opening; the smaller, the more is blurred. The "
                "focal length is the one for a picture 24 mm high: 33 mm at 40 degrees.");
  fields.optionalValue("focus", focus, Animated<float>(1.0F), [&](Animated<float>& distance) {
    fields.number("focus", distance, {0.001, 1e6}, "m",
                  "Distance along the line of sight at which the picture is sharp.");
  });
  fields.leftOut("focus", "the distance of the target");
  fields.integer("blades", blades, {0, 16}, "", "Sides of the opening, 3 or more; 0: it is round.");
  fields.integer("samples", samples, {2, 1024}, "",
                 "Points of the opening; each picture is drawn once for each. With too few, wide blurs "
                 "show as separate copies.");
  if (blades == 1 || blades == 2)
    fields.error(
        "blades",
        fmt::format("an opening cannot have {} blades; give 0 for a round one, or 3 to 16", blades));
}

void Shutter::describe(Fields& fields) {
  fields.number("angle", angle, {1, 360}, "degrees",
                "Exposure time as an angle: 360 is the whole time from the previous frame to this one, 180 "
                "its second half.");
  fields.integer("samples", samples, {2, 256}, "",
                 "Moments in that time; each picture is drawn once for each, or as often as the lens "
                 "needs. With too few, fast things show as separate copies.");
}

void Orbit::describe(Fields& fields) {
  fields.number("turn", turn, {-1e6, 1e6}, "degrees",
                "Angle at which it stands around the target: 0 on the side of +z, 90 on the side of +x.");
  fields.number("elevation", elevation, {-89, 89}, "degrees", "Angle of the camera above the horizon.");
  fields.number("distance", distance, positive, "m", "Distance from the target.");
  fields.leftOut("distance", "6; without \"target\" so far that the whole scene is in view");
  distanced = fields.given("distance");
}

void Camera::describe(Fields& fields) {
  fields.vector("position", position, anyNumber, "m", "Place of the camera.");
  fields.leftOut("position",
                 "[0,1.5,6], or whole caves, contours, cloths, meshes, bodies, balls and "
                 "particles are in view");
  fields.vector("target", target, anyNumber, "m", "Place that it looks at.");
  fields.leftOut("target", "[0,0,0], or its middle");
  fields.number("fieldOfView", fieldOfView, {1, 170}, "degrees", "Vertical angle of view.");
  fields.leftOut("fieldOfView", "40, 26 on a stage that is in view as a whole, or that of \"gltf\"");
  fields.choice("projection", projection, {"perspective", "orthographic"},
                "perspective: distant things look smaller. orthographic: they do not; all rays are "
                "parallel, and \"height\" takes the place of \"fieldOfView\".");
  fields.leftOut("projection", "perspective, or that of \"gltf\"");
  fields.number("height", height, positive, "m",
                "Height of the part of the scene that the picture shows; for an orthographic camera.");
  fields.leftOut("height", "4, what is in view as a whole with \"position\", or that of \"gltf\"");
  hasHeight = fields.given("height");
  if (projection == Projection::orthographic && fields.given("fieldOfView"))
    fields.error("fieldOfView", "an orthographic camera has no angle of view; give \"height\" (m) instead");
  if (projection == Projection::perspective && hasHeight && !fields.given("gltf"))
    fields.error("height",
                 "a perspective camera has no height; give \"fieldOfView\", or \"projection\": "
                 "\"orthographic\"");
  fields.number("roll", roll, anyNumber, "degrees", "Turn about the line of sight.");
  fields.optionalGroup("follow", follow, "Goes along a path that an object has found.");
  fields.shorthand("track", "object");
  fields.optionalGroup("track", track,
                       "Looks at an object, even if it moves, instead of at \"target\"; with \"orbit\" the "
                       "camera moves along with it.");
  if (track && follow)
    fields.error("track", "\"follow\" says what the camera looks at; leave out \"track\"");
  else if (track && fields.given("target"))
    fields.error("target", "\"track\" says what the camera looks at; leave out \"target\"");
  fields.optionalGroup("orbit", orbit, "Goes round its target, instead of standing at \"position\".");
  if (orbit && follow)
    fields.error("orbit", "\"follow\" says where the camera is; leave out \"orbit\"");
  else if (orbit && fields.given("position"))
    fields.error("position", "\"orbit\" says where the camera is; leave out \"position\"");
  describeDamping(
      fields, damping,
      "Time by which the line of sight lags behind \"target\", smoothly, like a critically damped "
      "spring. 0: no lag.");
  fields.idleUnless(target.moves(), "target", {"damping"}, "a \"target\" with keys");
  for (const char* name : {"follow", "track"})
    if (damping > 0 && fields.given(name))
      fields.error(
          "damping",
          fmt::format("this \"damping\" is only for \"target\"; put it into \"{0}\": {{ }}", name));
  fields.shorthand("gltf", "file");
  fields.optionalGroup("gltf", gltf,
                       "Takes position, direction and motion from the camera of a glTF file. Its vertical "
                       "angle of view is kept; \"render.size\" determines the width of the picture.");
  for (const char* name : {"position", "target", "track", "follow", "orbit", "damping"})
    if (gltf && fields.given(name))
      fields.error(name, fmt::format("\"gltf\" says where the camera is; leave out \"{}\"", name));
  if (gltf && fields.given("projection"))
    fields.error("projection", "\"gltf\" says what kind of camera it is; leave out \"projection\"");
  if (gltf) {
    gltf->hasNear = fields.given("near");
    gltf->hasFar = fields.given("far");
  }
  fields.switchable("lens");
  fields.optionalGroup("lens", lens,
                       "Depth of field: things nearer or farther than the focus are blurred. The driver's "
                       "rasterizer has none.");
  if (lens && projection == Projection::orthographic)
    fields.error("lens", "an orthographic camera has no lens: all is sharp; leave out \"lens\"");
  fields.switchable("shutter");
  fields.optionalGroup(
      "shutter", shutter,
      "Motion blur: the picture is the mean over the time before its frame. The motion of surfaces, "
      "particles, lights and the camera causes blur; changes inside fields, charts and growing caves do "
      "not. The driver's rasterizer has none.");
  hasAngle = fields.given("fieldOfView");
  placed = follow || (track && fields.version() == 1) || gltf || fields.given("position") ||
           fields.given("target") || (orbit && orbit->distanced);
  aimed = fields.version() > 1 && fields.given("target") && !fields.given("position") && !follow &&
          !track && !gltf && !orbit;
  if (aimed) placed = false;
  for (const char* name : {"position", "target"})
    if (follow && fields.given(name))
      fields.error(name, fmt::format("\"follow\" says where the camera is; leave out \"{}\"", name));
  fields.number("near", near, positive, "m", "Nearest distance drawn.");
  fields.leftOut("near", "0.05, or that of \"gltf\"");
  fields.number("far", far, positive, "m", "Farthest distance drawn.");
  fields.leftOut("far", "200, or that of \"gltf\"; with \"haze\" at least its \"start\" + 16 \"distance\"");
  if (!(near < far))
    fields.error(fields.given("near") ? "near" : "far",
                 fmt::format("\"near\" ({} m) must be less than \"far\" ({} m)", near, far));
  warnOutsideDepthRange(fields, *this);
  if (!aimed && !orbit && !track && !gltf && !position.moves() && !target.moves() &&
      position.at(0) == target.at(0))
    fields.error(
        fields.given("target") ? "target" : "position",
        "\"position\" and \"target\" are the same point, so the camera has no direction; move one of them");
}

}  // namespace simreel::scene
