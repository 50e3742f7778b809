#include "sim/particles/parameters.hpp"

#include "scene/value/implied_shape.hpp"
#include "sim/contact/lock_step.hpp"
#include "sim/contour/walls.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/grid/color_choice.hpp"
#include "sim/mesh/height_field.hpp"
#include "sim/ports/color_scale.hpp"
#include "sim/ports/markers.hpp"
#include "sim/ports/moving_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

/// Greatest a dt^2 and v dt of "auto" substeps, as fractions of a ball's radius.
constexpr double overlapOfStep = 1.75e-4, wayOfStep = 0.3;

/// Returns the group of a scene without groups and emitters: a galaxy that turns visibly within a second.
ParticleGroup galaxy() {
  ParticleGroup group;
  group.shape = ParticleGroup::Shape::disk;
  group.count = 6000;
  group.totalMass = 150;
  group.centralMass = 100;
  group.thickness = 0.1F;
  group.rotation = {20, 0, 10};
  return group;
}

}  // namespace

void ParticleGroup::describe(scene::Fields& f) {
  f.choice("shape", shape, {"ball", "cube", "plummer", "disk", "file"},
           "Uniform ball or cube, Plummer sphere or rotating disk in equilibrium, or read from a file.");
  f.integer("count", count, {1, 1 << 24}, "particles", "Number of particles; a file has its own.");
  f.number("radius", radius, {1e-4, 1e5}, "m",
           "Radius of the ball, half the side of the cube, scale radius of the Plummer sphere or scale "
           "length of the disk.");
  f.number("thickness", thickness, {0, 10}, "", "Scale height of a disk as a fraction of its radius.");
  f.number("totalMass", totalMass, {1e-6, 1e8}, "kg", "Shared equally; a file may give masses itself.");
  f.number("centralMass", centralMass, {0, 1e8}, "kg",
           "Mass of one more particle in the middle, the bulge of a disk; 0: none.");
  f.number("speed", speed, {0, 1e5}, "m/s", "Random velocity of the particles of a ball or cube.");
  f.number("spin", spin, {-1e4, 1e4}, "rad/s", "Rotation of a ball or cube about its own y axis.");
  f.vector("position", position, {-1e7, 1e7}, "m", "Position of the middle.");
  f.vector("velocity", velocity, {-1e6, 1e6}, "m/s", "Velocity of the whole group.");
  f.vector("rotation", rotation, scene::anyNumber, "degrees",
           "About x, then y, then z; unrotated a disk lies in the xz plane.");
  f.asset("file", file, "CSV with a first line naming x,y,z[,vx,vy,vz][,mass], or PLY.");
  scene::implyShape(f, shape, Shape::file, "file", file, "file", "ball");
  if (shape == Shape::file && file.empty())
    f.error("shape", "shape \"file\" needs \"file\", a CSV or PLY file");
  if (totalMass / static_cast<float>(count) < 1e-9F)
    f.error("totalMass", "shared by all particles this is less than 1e-9 kg each");
  f.idleUnless(shape != Shape::file, "file", {"count", "radius", "centralMass"},
               "groups that are no \"file\"");
  f.idleUnless(shape == Shape::disk, "shape", {"thickness"}, "a \"disk\"");
  f.idleUnless(shape == Shape::ball || shape == Shape::cube, "shape", {"speed", "spin"},
               "a \"ball\" or a \"cube\"");
}

void Emitter::describe(scene::Fields& f) {
  f.number("rate", rate, {1e-3, 1e8}, "1/s", "Particles born per second.");
  f.vector("position", position, {-1e7, 1e7}, "m", "Middle of the ball in which they appear.");
  f.number("radius", radius, {0, 1e5}, "m", "Radius of that ball.");
  f.vector("velocity", velocity, {-1e6, 1e6}, "m/s", "Mean velocity at birth.");
  f.number("spread", spread, {0, 180}, "degrees", "Half the angle of the cone of velocities.");
  f.number("speedVariation", speedVariation, {0, 1}, "", "Variation of the speed, as a fraction.");
  f.number("lifetime", lifetime, {1e-3, 1e5}, "s", "Mean time a particle lives.");
  f.number("lifetimeVariation", lifetimeVariation, {0, 0.95}, "",
           "Variation of the lifetime, as a fraction.");
  f.number("mass", mass, {1e-9, 1e8}, "kg", "Mass of each particle.");
  f.number("from", from, {0, 1e9}, "s", "When it starts; 0: at once, before frame 0 too.");
  f.number("until", until, {0, 1e9}, "s", "When it stops.");
  if (until < from) f.error("until", "the emitter stops before it starts");
}

void ParticleParameters::describe(scene::Fields& f) {
  f.list("groups", groups, "Clouds of particles there from the start.",
         [](scene::Fields& g, ParticleGroup& group) { group.describe(g); });
  f.list(
      "emitters", emitters, "Sources of particles that live for a while.",
      [](scene::Fields& e, Emitter& emitter) { emitter.describe(e); }, shader::maxEmitters);
  const bool isGalaxy = f.version() > 1 && !f.given("groups") && !f.given("emitters") && groups.empty();
  if (isGalaxy) groups.push_back(galaxy());
  f.choice("method", method, {"none", "all-pairs", "tree"},
           "Attraction between particles. none: no attraction; all-pairs: each by each (exact, N^2); tree: "
           "distant groups as one body (N log N).");
  f.leftOut("method", "\"all-pairs\", of emitters alone \"none\"");
  if (!f.given("method") && groups.empty() && !emitters.empty()) method = GravityMethod::none;
  f.number("gravity", gravity, {0, 1e6}, "m^3/(kg s^2)", "The constant G.");
  f.number("softening", softening, {1e-6, 1e4}, "m",
           "Length below which the attraction between particles fades.");
  f.number("opening", opening, {0, 1.15}, "rad",
           "Angle below which \"tree\" counts a cell as one body; smaller is more exact.");
  f.optionalGroup("attractor", attractor, "A heavy body that moves along keyframes and is not moved.",
                  [&](scene::Fields& a, Attractor& body) {
                    a.vector("position", body.position, {-1e7, 1e7}, "m", "Place of the attractor.");
                    a.number("mass", body.mass, {-1e8, 1e8}, "kg", "Negative ones push away.");
                    a.number("softening", attractorSoftening, {1e-6, 1e4}, "m",
                             "Length below which its attraction fades.");
                  });
  f.vector("acceleration", acceleration, {-1e6, 1e6}, "m/s^2",
           "Acceleration that is the same for every particle, such as that of weight.");
  f.number("damping", damping, {0, 1e4}, "1/s",
           "Rate at which velocity decays; 0.06 keeps 0.999 of it each 1/60 s.");
  f.group("turbulence", "Swirls without sources that push the particles about.", [&](scene::Fields& t) {
    t.number("strength", turbulence.strength, {0, 1e5}, "m/s^2", "Typical acceleration; 0: none.");
    t.number("size", turbulence.size, {1e-3, 1e6}, "m", "Size of the swirls.");
    t.number("speed", turbulence.speed, {0, 1e5}, "m/s", "Speed at which they drift through the scene.");
    t.idleUnless(turbulence.strength != 0, "strength", {"size", "speed"}, "turbulence with a \"strength\"");
  });
  f.optionalGroup("wind", wind, "Wind that carries them along.", [](scene::Fields& w, ParticleWind& blown) {
    w.text("fluid", blown.fluid,
           "Name of the fluid whose flow is the wind, where its \"plane\" lies in the world; outside its "
           "rectangle the air is still. The flow at the end of a frame counts for all of it.");
    w.number("drag", blown.drag, {0, 1e4}, "1/s", "Rate at which their velocity becomes the wind's.");
    if (blown.fluid.empty()) w.error("fluid", "whose wind? Give \"fluid\", the name of one of this scene");
  });
  f.integer("substeps", substeps, {1, 1024}, "per frame", "Steps a frame is divided into.");
  f.leftOut("substeps", "1, or with \"contact\" as many as balls of their size and weight need");
  f.boolean("collides", collides,
            "Makes them meet everything that collides: shapes, the ground, bodies, a mesh that collides, "
            "and cloths with \"contact\".");
  f.text("cloths", cloths,
         "Cloths with \"contact\" that they meet: \"all\", \"none\" or the name of one. Cloth and particle "
         "push each other, by their masses, at the distance \"margin\" plus half the cloth's thickness; "
         "friction is the cloth's. Cloths without \"contact\" let them through.");
  f.text("walls", walls, "Name of the cave or contour whose walls, floor and tops they meet.");
  f.number("bounce", bounce, {0, 1}, "", "Fraction of the speed of impact that is given back.");
  f.number("margin", margin, {0, 1e3}, "m", "Distance kept from what they meet, and from walls.");
  f.leftOut("margin", "0, or with \"contact\" the radius");
  if (!collides && f.given("cloths"))
    f.error("cloths", "\"cloths\" is for particles with \"collides\": true");
  for (const char* name : {"bounce", "margin"})
    if (!collides && walls.empty() && f.given(name))
      f.error(name, fmt::format("\"{}\" is for particles with \"collides\": true or \"walls\"", name));
  f.group("look", "Look of the particles.",
          [&](scene::Fields& l) { describeLook(l, isGalaxy && !f.given("contact")); });
  describeContact(f);
  f.switchable("trails");
  f.optionalGroup("trails", trails,
                  "Tubes through the places of the latest frames, which end where a particle was born.");
  remarkForces(f);
  if (groups.empty() && emitters.empty())
    f.error("groups", "no particles: give \"groups\" or \"emitters\"");
}

void BallParameters::describe(scene::Fields& f) {
  f.number("radius", radius, {0, 1e3}, "m",
           "Radius of a particle; 0: half the \"size\" of its look. It grows with mass as the look does.");
  f.number("friction", friction, {0, 10}, "", "Coulomb coefficient of friction between particles.");
  f.number("restitution", restitution, {0, 1}, "",
           "Fraction of the approach speed with which two particles part.");
  f.boolean("rolls", rolls, "Lets friction turn the balls, so that they roll; meshes turn with them.");
}

void ParticleParameters::describeContact(scene::Fields& f) {
  f.switchable("contact");
  f.optionalGroup("contact", contact,
                  "Makes particles balls that push each other, by their masses. Without it "
                  "they pass through each other.");
  if (!contact) return;
  autoSubsteps = !f.given("substeps");
  if (!f.given("margin")) margin = ballRadius();
  for (const ParticleGroup& group : groups) {
    const bool cube = group.shape == ParticleGroup::Shape::cube;
    if (massExponent > 0 || (!cube && group.shape != ParticleGroup::Shape::ball)) continue;
    // Randomly placed balls can be moved apart if their volume is at most half of the group's volume.
    const double volume = cube ? 8 : 4.18879;
    const double wide = ballRadius() * std::cbrt(group.count * 4.18879 / (0.5 * volume));
    if (wide > group.radius)
      f.error("contact",
              fmt::format("{} balls of radius {:.3g} m do not fit into a group of radius {:.3g} m; "
                          "give it {:.3g} m or more",
                          group.count, ballRadius(), group.radius, wide));
  }
}

void ParticleParameters::remarkForces(scene::Fields& f) const {
  const bool attracts = method != GravityMethod::none;
  // Groups in equilibrium need G for their initial velocities.
  const bool orbits = std::any_of(groups.begin(), groups.end(), [](const ParticleGroup& group) {
    return group.shape == ParticleGroup::Shape::plummer || group.shape == ParticleGroup::Shape::disk;
  });
  f.idleUnless(method == GravityMethod::tree, "method", {"opening"}, "\"method\": \"tree\"");
  f.idleUnless(attracts || orbits, "method", {"softening"}, "particles that attract each other");
  f.idleUnless(attracts || orbits || attractor.has_value(), "method", {"gravity"},
               "particles that attract each other (weight is an \"acceleration\")");
}

void ParticleParameters::describeLook(scene::Fields& l, bool stars) {
  l.choice("shape", shape, {"sprite", "sphere", "mesh"},
           "Discs that face the camera, lit as balls or glowing; spheres; or a mesh.");
  l.asset("mesh", mesh, "OBJ, PLY, STL, glTF or GLB file of shape \"mesh\".");
  scene::implyShape(l, shape, Instances::Shape::mesh, "mesh", mesh, "mesh", "sprite");
  l.boolean("alongVelocity", alongVelocity, "Turns a mesh's z axis along the velocity.");
  // The default of a key is set behind its declaration, because the schema states the general default.
  const auto ofStars = [&](const char* key, auto& value, auto star) {
    if (stars && !l.given("shape") && !l.given("mesh") && !l.given(key)) value = star;
  };
  l.number("size", size, {1e-5, 1e5}, "m", "Diameter; for a mesh, a factor on its coordinates.");
  ofStars("size", size, 0.07F);
  l.number("massExponent", massExponent, {0, 2}, "",
           "Size grows with mass to this power; 0.333 for balls of one density.");
  l.choice("colorBy", colorBy, {"material", "speed", "mass", "age"},
           "The object's material, or a colour map of the speed, mass or age.");
  ofStars("colorBy", colorBy, Instances::ColorBy::speed);
  const bool measured = colorBy == Instances::ColorBy::speed || colorBy == Instances::ColorBy::mass;
  if (measured && l.version() > 1 && !l.given("colorFrom") && !l.given("colorTo"))
    autoColors = {true, true};
  describeEnd(l, "colorFrom", colorRange.x, autoColors.low, "",
              "Speed (m/s), mass (kg) or age (0 to 1) at the start of the colour map; \"auto\": the lowest "
              "of the whole run.");
  describeEnd(l, "colorTo", colorRange.y, autoColors.high, "",
              "Speed (m/s), mass (kg) or age (0 to 1) at the end of the colour map; \"auto\": the highest "
              "of the whole run.");
  l.leftOut("colorFrom", "0, or \"auto\" in version 2 for speed and mass");
  l.leftOut("colorTo", "1, or \"auto\" in version 2 for speed and mass");
  colors = describeColors(l, "particles");
  const bool ownColors = l.given("colors") || l.given("colorStops");
  l.boolean("additive", additive, "Light that adds up and casts no shadow, for sparks and stars.");
  l.leftOut("additive", "false; in version 2 true for an object without groups, emitters and contact");
  ofStars("additive", additive, true);
  l.number("brightness", brightness, {0, 1e5}, "", "Factor on the colours of additive particles.");
  ofStars("brightness", brightness, 0.8F);
  l.number("fade", fade, {0, 0.5}, "",
           "Fraction of life over which additive particles of an emitter fade in and out.");
  if (l.version() > 1 && additive && !ownColors && colorBy != Instances::ColorBy::material) {
    colors = {{0.16F, 0.02F, 0.1F}, {0.75F, 0.09F, 0.03F}, {1, 0.4F, 0.08F}, {1, 0.82F, 0.5F}};
    if (colorBy == Instances::ColorBy::age) std::reverse(colors.begin(), colors.end());
  }
  l.leftOut("colors", "\"viridis\"; in version 2 the colours of fire for particles that are \"additive\"");
  if (shape == Instances::Shape::mesh && mesh.empty())
    l.error("shape", "shape \"mesh\" needs \"mesh\", a mesh file");
  if (colorRange.x == colorRange.y && !autoColors.any())
    l.error("colorTo", "colorFrom and colorTo must differ");
  l.idleUnless(shape == Instances::Shape::mesh, "shape", {"alongVelocity"}, "shape \"mesh\"");
  l.idleUnless(colorBy != Instances::ColorBy::material, "colorBy",
               {"colorFrom", "colorTo", "colors", "colorStops"},
               "\"colorBy\": \"speed\", \"mass\" or \"age\"");
  l.idleUnless(additive, "additive", {"brightness", "fade"}, "particles that are \"additive\"");
  if (additive) l.idleUnless(!emitters.empty(), "fade", {"fade"}, "particles of \"emitters\"");
}

ShownQuantity ParticleParameters::shownQuantity() const {
  using By = Instances::ColorBy;
  if (colorBy == By::speed) return {"speed", "m/s"};
  if (colorBy == By::mass) return {"mass", "kg"};
  return {colorBy == By::age ? "age" : ""};
}

std::vector<MeasuredRange> ParticleParameters::measuredRanges() {
  if (colorBy == Instances::ColorBy::material) return {};
  return measuredRange("look", "colorFrom", "colorTo", autoColors, colorRange.x, colorRange.y);
}

ParticleParameters ParticleParameters::withContactSubsteps(int contactSubsteps) const {
  ParticleParameters all = *this;
  if (meetsCloths() && contactSubsteps > 0) {
    all.substeps = contactSubsteps;
    all.autoSubsteps = false;
  }
  return all;
}

// The overlap of balls in a heap is proportional to the heap's depth and to a dt^2, with the acceleration a
// and the substep dt (glsl/particles/README.md).
int ParticleParameters::substepsPerFrame(double frameSeconds) const {
  if (!autoSubsteps) return substeps;
  double strongest = 0;
  for (const auto& key : acceleration.keys())
    strongest = std::max(strongest, static_cast<double>(glm::length(key.value)));
  double fastest = 0;
  for (const ParticleGroup& group : groups)
    fastest = std::max<double>(fastest, glm::length(group.velocity) + group.speed);
  for (const Emitter& emitter : emitters)
    for (const auto& key : emitter.velocity.keys())
      fastest = std::max<double>(fastest, (1 + emitter.speedVariation) * glm::length(key.value));
  const double radius = ballRadius();
  const double steps = frameSeconds * std::max(std::sqrt(strongest / (overlapOfStep * radius)),
                                               fastest / (wayOfStep * radius));
  return static_cast<int>(std::clamp(std::ceil(steps), 4.0, 64.0));
}

void ParticleParameters::ports(Ports& ports) const {
  ports.want<Walls>(walls, {"walls"});
  ports.provide<MovingPoints>();
  ports.provide<ColorScale>(colorBy != Instances::ColorBy::material,
                            " whose \"look\" has no \"colorBy\": \"speed\", \"mass\" or \"age\"");
  if (wind) ports.want<FluidWind>(wind->fluid, {"wind", "fluid"});
  if (collides) {
    ports.wantAll<HeightField>();
    ports.requireAny<Touchable>({"collides"});
  }
  if (!meetsCloths()) return;
  ports.join<LockStep>(false);
  if (cloths == "all")
    ports.wantAll<ContactCloth>();
  else
    ports.want<ContactCloth>(cloths, {"cloths"}, "; \"all\" and \"none\" are words here, too");
}

std::span<const scene::Quantity> ParticleParameters::quantities() const {
  static const scene::Quantity table[] = {{"population", "", "Living particles."},
                                          {"mass", "kg", "Mass of all living particles."},
                                          {"momentum", "kg m/s", "Size of the sum of mass times velocity."},
                                          {"kineticEnergy", "J", "Sum of m v^2 / 2."}};
  return table;
}

// Particles may fall without end, so only the positions of emitters determine the result.
double ParticleParameters::warmUp() const {
  constexpr double longest = 4;
  double seconds = 0;
  if (!groups.empty()) return 0;
  for (const Emitter& emitter : emitters) {
    if (emitter.from > 0) return 0;
    seconds = std::max(seconds, static_cast<double>(emitter.lifetime) * (1 + emitter.lifetimeVariation));
  }
  return std::min(seconds, longest);
}

std::optional<float> ParticleParameters::supportHeight() const {
  if (emitters.empty()) return std::nullopt;
  const auto falls = [&](const Emitter& emitter) {
    const auto& keys = emitter.velocity.keys();
    return std::all_of(keys.begin(), keys.end(), [&](const auto& key) {
      return key.value.y < 0 || (key.value.y <= 0 && acceleration.at(0).y < 0);
    });
  };
  float lowest = std::numeric_limits<float>::infinity();
  for (const Emitter& emitter : emitters)
    for (const auto& key : emitter.position.keys())
      if (!falls(emitter)) lowest = std::min(lowest, key.value.y - emitter.radius);
  return lowest;
}

double ParticleParameters::fallsTo(double seconds, double ground) const {
  double lowest = std::numeric_limits<double>::infinity();
  const double weight = acceleration.at(0).y;
  if (collides || !walls.empty() || wind || attractor || weight >= 0) return lowest;
  const auto fall = [&](double height, double speed, double time) {
    if (height <= ground || time <= 0) return;
    // With damping, the speed approaches `last`.
    const double last = damping > 0 ? weight / damping : 0;
    const double way = damping > 0
                           ? last * time + (speed - last) * (1 - std::exp(-damping * time)) / damping
                           : speed * time + 0.5 * weight * time * time;
    lowest = std::min(lowest, height + way);
  };
  for (const ParticleGroup& group : groups) fall(group.position.y, group.velocity.y, seconds);
  for (const Emitter& emitter : emitters)
    fall(emitter.position.at(emitter.from).y - emitter.radius, emitter.velocity.at(emitter.from).y,
         std::min<double>(emitter.lifetime, seconds - emitter.from));
  return lowest;
}

}  // namespace simreel::sim
