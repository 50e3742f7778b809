#include "sim/fluid/plan.hpp"

#include "base/error.hpp"
#include "base/ieee.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Maximum of dt nu / h^2 for a stable step, where nu is the kinematic viscosity and h the cell width. The
/// limit is 1/4 in open cells and smaller beside walls, where mirrored cells are used.
constexpr double maxDiffusion = 0.2;

double greatest(const scene::Animated<float>& value) {
  double maximum = 0;
  for (const auto& key : value.keys()) maximum = std::max<double>(maximum, key.value);
  return maximum;
}

std::vector<StrokeParameters> plainStrokes(const std::vector<FluidStroke>& strokes) {
  return {strokes.begin(), strokes.end()};
}

std::vector<PictureDistances> picturesOf(const FluidParameters& p) {
  std::vector<PictureDistances> pictures(p.obstacles.size());
  for (std::size_t i = 0; i < pictures.size(); ++i)
    if (p.obstacles[i].shape == FluidObstacle::Shape::image)
      pictures[i] = PictureDistances(p.obstacles[i].image, p.obstacles[i].threshold);
  return pictures;
}

float isParabola(const FluidSide& side) {
  const bool is = side.kind == FluidSide::Kind::inflow && side.profile == FluidSide::Profile::parabola;
  return is ? 1 : 0;
}

bool inflowMoves(const FluidParameters& p) {
  return p.left.velocity.moves() || p.right.velocity.moves() || p.top.velocity.moves() ||
         p.bottom.velocity.moves();
}

/// Returns the velocity (x, y) of a side. A wall moves only along itself: in x if `alongX` is true,
/// otherwise in y.
glm::vec2 velocityOf(const FluidSide& side, bool alongX, double time) {
  const glm::vec3 v = side.velocity.at(time);
  if (side.kind == FluidSide::Kind::inflow) return {v.x, v.y};
  if (side.kind == FluidSide::Kind::wall) return alongX ? glm::vec2(v.x, 0) : glm::vec2(0, v.y);
  return {0, 0};
}

}  // namespace

FluidPlan::FluidPlan(FluidParameters parameters, const std::string& object, int seed, double frameSeconds,
                     std::vector<PictureDistances> pictures)
    : parameters_(std::move(parameters)),
      object_(object),
      frameSeconds_(frameSeconds),
      pictures_(pictures.empty() ? picturesOf(parameters_) : std::move(pictures)),
      strokes_(
          plainStrokes(parameters_.strokes), seed,
          {parameters_.size, parameters_.wrapsX() && parameters_.wrapsY(), "fluid \"" + object + "\""}) {
  const FluidParameters& p = parameters_;
  const double viscosity = greatest(p.viscosity);
  const double bySpeed = std::ceil(p.speed * frameSeconds / p.courant - 1e-9);
  const double byFriction = std::ceil(viscosity * frameSeconds / maxDiffusion - 1e-9);
  const double wanted = std::max({bySpeed, byFriction, 1.0});
  if (!p.substeps && wanted > 10000)
    fail(ExitCode::usage,
         "fluid \"{}\": \"speed\" {} and \"viscosity\" {} ask for {:.0f} substeps a frame, at most 10000 "
         "are taken; "
         "lower them, or give \"substeps\"",
         object, p.speed, viscosity, wanted);
  substeps_ = p.substeps ? *p.substeps : static_cast<int>(wanted);
  const double dt = frameSeconds / substeps_;
  if (dt * viscosity > maxDiffusion * (1 + 1e-9))
    fail(ExitCode::usage,
         "fluid \"{}\": a substep takes dt viscosity = {:.3g}, and is stable up to {}; give \"substeps\" "
         "{:.0f} or "
         "\"auto\"",
         object, dt * viscosity, maxDiffusion, byFriction);
  const double passes = std::ceil(p.speed * dt / shader::maxDyeWay - 1e-9);
  dyePasses_ = p.dyes() ? static_cast<int>(std::clamp(passes, 1.0, 10000.0)) : 0;
}

float FluidPlan::fastest() const {
  return parameters_.ownSpeed ? parameters_.speed : 1.1F * parameters_.speed;
}

std::string FluidPlan::speedRemark(float reached) const {
  // The advice is 10% more than the flow reached, rounded up to two digits.
  const double wanted = 1.1 * static_cast<double>(reached);
  const double digit = std::pow(10.0, std::floor(std::log10(wanted)) - 1);
  return fmt::format(
      "the flow reaches {:.4g} cells/s, above \"speed\" {:.4g} ({:.2g} cells per substep), so dye lags "
      "behind; give objects.{}.fluid.speed {:g}",
      reached, parameters_.speed, static_cast<double>(reached) * frameSeconds_ / substeps_, object_,
      digit * std::ceil(wanted / digit - 1e-9));
}

const std::shared_ptr<const FluidSolids>& FluidPlan::stillSolids() const {
  if (!still_)
    still_ =
        std::make_shared<FluidSolids>(parameters_, pictures_, 0, frameSeconds_ / substeps_, stepAt(0, 0));
  return still_;
}

std::shared_ptr<const FluidSolids> FluidPlan::solidsAt(double time, int step) const {
  const FluidParameters& p = parameters_;
  const bool changes = p.obstaclesMove() || (p.pocketsGrow() && inflowMoves(p));
  if (!changes) return stillSolids();
  const double dt = frameSeconds_ / substeps_;
  return std::make_shared<FluidSolids>(p, pictures_, time + step * dt, dt, stepAt(time, step));
}

// Closed faces have the velocity of their side, or 0. The cells outside the grid are set by the first
// projection.
std::vector<glm::vec4> FluidPlan::firstFlow(double time) const {
  const glm::ivec2 size = parameters_.size;
  const glm::vec3 flow = parameters_.flow;
  const shader::FluidStep sides = stepAt(time, 0);
  const auto solids = solidsAt(time, 0);
  std::vector<glm::vec4> cells(static_cast<std::size_t>(elements()), glm::vec4(0));
  for (int y = 0; y <= size.y; ++y)
    for (int x = 0; x <= size.x; ++x) {
      const int number = y / 2 * (size.x / 2 + 1) + x / 2;
      const glm::uvec4 block = solids->levels().weights()[static_cast<std::size_t>(number)];
      const glm::vec2 open = shader::faceWeights(block[y % 2 * 2 + x % 2]);
      const int element = (y + 1) * (size.x + 2) + x + 1;
      glm::vec4& cell = cells[static_cast<std::size_t>(element)];
      const float left = shader::sideSpeed(y, size.y, sides.leftRight.x, sides.parabolas.x);
      const float right = shader::sideSpeed(y, size.y, sides.leftRight.z, sides.parabolas.y);
      const float top = shader::sideSpeed(x, size.x, sides.topBottom.y, sides.parabolas.z);
      const float bottom = shader::sideSpeed(x, size.x, sides.topBottom.w, sides.parabolas.w);
      const float acrossX = x == 0 ? left : x == size.x ? right : 0;
      const float acrossY = y == 0 ? top : y == size.y ? bottom : 0;
      cell.x = open.x > 0 ? flow.x : acrossX;
      cell.y = open.y > 0 ? flow.y : acrossY;
    }
  return cells;
}

shader::FluidStep FluidPlan::stepAt(double time, int step) const {
  const FluidParameters& p = parameters_;
  const double dt = frameSeconds_ / substeps_;
  const double now = time + step * dt;
  const auto scaled = [&](const scene::Animated<float>& value) {
    return static_cast<float>(dt * static_cast<double>(value.at(now)));
  };
  const glm::vec2 left = velocityOf(p.left, false, now), right = velocityOf(p.right, false, now);
  const glm::vec2 top = velocityOf(p.top, true, now), bottom = velocityOf(p.bottom, true, now);
  shader::FluidStep s{};
  s.leftRight = {left.x, left.y, right.x, right.y};
  s.topBottom = {top.x, top.y, bottom.x, bottom.y};
  s.dt = static_cast<float>(dt);
  s.perDt = static_cast<float>(1 / dt);
  s.viscosity = scaled(p.viscosity);
  s.confinement = scaled(p.confinement);
  s.lift = scaled(p.lift);
  s.keptHeat = shader::exactExp(static_cast<float>(-dt * p.cooling));
  s.dyeDt = static_cast<float>(dt / std::max(dyePasses_, 1));
  s.weight = scaled(p.dyeWeight);
  s.parabolas = {isParabola(p.left), isParabola(p.right), isParabola(p.top), isParabola(p.bottom)};
  s.confined = {static_cast<float>(2.0 / static_cast<double>(p.speed)), 0, 0, 0};
  return s;
}

float FluidPlan::linePhase(double time) const {
  const double turns = time * parameters_.lineRate;
  return static_cast<float>(turns - std::floor(turns));
}

FluidPlan::Brushes FluidPlan::brushesAt(double time, int step) const {
  Brushes all;
  if (strokes_.empty()) return all;
  const double dt = frameSeconds_ / substeps_;
  const double now = time + step * dt;
  std::vector<int> numbers;
  all.strokes = strokes_.into(now, dt, std::lround(now / dt), &numbers);
  if (all.strokes.size() > static_cast<std::size_t>(shader::maxBrushes))
    fail(ExitCode::usage, "fluid \"{}\": {} strokes are active at {:.3f} s, but at most {} may be", object_,
         all.strokes.size(), now, shader::maxBrushes);
  for (std::size_t i = 0; i < all.strokes.size(); ++i) {
    const shader::Stroke& stroke = all.strokes[i];
    const FluidStroke& what = parameters_.strokes[static_cast<std::size_t>(numbers[i])];
    shader::FluidBrush brush{};
    brush.segment = {stroke.from.x, stroke.from.y, stroke.to.x, stroke.to.y};
    const float hard = 1 - what.soft;
    const float rim =
        stroke.radius2 * (1 - hard * hard);  // Difference between the squared radius of the rim and the
                                             // squared radius at which the fade starts.
    brush.reach = {stroke.radius2, stroke.perLength2, std::min(stroke.value, 1.0F),
                   rim > 1e-6F && stroke.imageSize.x == 0 ? 1 / rim : 0};
    brush.stamp = {stroke.seed, stroke.picked, stroke.imageWord,
                   (what.setsVelocity ? 1 : 0) + (what.setsTemperature ? 2 : 0) + (what.setsDye ? 4 : 0)};
    brush.image = {stroke.imageFrom.x, stroke.imageFrom.y, stroke.imageSize.x, stroke.imageSize.y};
    brush.box = Strokes::box(stroke, parameters_.size);
    const glm::vec3 velocity = what.velocity.at(now), dye = what.dye.at(now);
    const glm::dvec3 force(what.force.at(now));
    const double push = static_cast<double>(what.strength.at(now)) * dt;
    brush.flow = {velocity.x, velocity.y, what.temperature.at(now), 0};
    brush.force = {static_cast<float>(force.x * push), static_cast<float>(force.y * push), 0, 0};
    brush.dye = {dye.x, dye.y, dye.z, 0};
    all.brushes.push_back(brush);
  }
  return all;
}

}  // namespace simreel::sim
