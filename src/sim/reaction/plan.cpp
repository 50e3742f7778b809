#include "sim/reaction/plan.hpp"

#include "base/log.hpp"
#include "sim/grid/picture_file.hpp"
#include "sim/reaction/mesh_maps.hpp"
#include "sim/reaction/rule/model.hpp"
#include "sim/reaction/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simreel::sim {

namespace {

constexpr int maxRuleMapSide = 32768;

std::vector<StrokeParameters> plainStrokes(const std::vector<ReactionStroke>& strokes) {
  return {strokes.begin(), strokes.end()};
}

/// Magnitude of the largest eigenvalue of the 9-point Laplacian and of the 19-point Laplacian, in units of
/// 1/h^2 (cell distance h). It belongs to the checkerboard pattern along two axes.
constexpr double gridFastest = 16.0 / 3;

/// Returns an upper bound of the magnitudes of the Laplacian's eigenvalues by Gershgorin's theorem, in
/// 1/m^2: the maximum over all cells of twice the sum of the cell's weights.
double fastestOf(const MeshCells& cells) {
  double fastest = 0;
  for (std::size_t cell = 0; cell + 1 < cells.first.size(); ++cell) {
    double sum = 0;
    for (int i = cells.first[cell]; i < cells.first[cell + 1]; ++i)
      sum += std::abs(cells.links[static_cast<std::size_t>(i)].weight);
    fastest = std::max(fastest, 2 * sum / cells.areas[cell]);
  }
  return fastest;
}

float stored(double value) {
  return shader::reaction::grained(static_cast<float>(value), storedGrain);
}

}  // namespace

ReactionPlan::ReactionPlan(ReactionParameters parameters, const std::string& object, int seed,
                           double frameSeconds)
    : parameters_(std::move(parameters)),
      seed_(seed),
      frameSeconds_(frameSeconds),
      rule_(compileRule(parameters_.ruleText())),
      program_(programOf(rule_, parameters_.method)),
      strokes_(
          parameters_.space() == RuleSpace::plane ? plainStrokes(parameters_.strokes)
                                                  : std::vector<StrokeParameters>(),
          seed,
          {parameters_.size, parameters_.boundary == RuleBoundary::torus, "reaction \"" + object + "\""}) {
  if (parameters_.space() == RuleSpace::mesh) readMesh(object);
  if (parameters_.space() != RuleSpace::plane) checkBrushes(object);
  warnOfSteps(object);
}

// Loads the mesh. The unit of length is chosen so that the mean distance between neighbours is `spacing`.
// If the scene does not set `spacing`, it is increased until diffusion is no faster than on a regular grid.
void ReactionPlan::readMesh(const std::string& object) {
  onMesh_ = true;
  mesh_ = parameters_.mesh->make();
  cells_ = cellsOf(mesh_, "reaction \"" + object + "\"");
  places_ = mapPlaces(*parameters_.mesh, mesh_, cells_, "reaction \"" + object + "\"");
  parameters_.size = {cells_.count(), 1};
  if (!parameters_.hasSpacing)
    parameters_.spacing *= std::max(1.0, cells_.meanEdge * std::sqrt(fastestOf(cells_) / gridFastest));
  perMetre_ = parameters_.spacing / cells_.meanEdge;
  const int count = cells_.count();
  for (int begin = 0; begin < count; begin += 4) {
    const auto degree = [&](int i) {
      if (i >= count) return 0;
      const auto cell = static_cast<std::size_t>(i);
      return cells_.first[cell + 1] - cells_.first[cell];
    };
    const int slots = std::max({degree(begin), degree(begin + 1), degree(begin + 2), degree(begin + 3)});
    const auto first = static_cast<int>(links_.weights.size());
    links_.ranges.emplace_back(first, first + slots);
    for (int s = 0; s < slots; ++s) {
      glm::ivec4 neighbours(-1);
      glm::vec4 weights(0);
      for (int c = 0; c < 4; ++c) {
        const int i = begin + c;
        if (s >= degree(i)) continue;
        const auto cell = static_cast<std::size_t>(i);
        const MeshCells::Link& link =
            cells_.links[static_cast<std::size_t>(cells_.first[cell]) + static_cast<std::size_t>(s)];
        neighbours[c] = link.neighbour;
        weights[c] = stored(link.weight / (cells_.areas[cell] * perMetre_ * perMetre_));
      }
      links_.neighbours.push_back(neighbours);
      links_.weights.push_back(weights);
    }
  }
}

/// Returns the coordinates of the cells along an axis in units of length; 0 is the mesh's minimum.
std::vector<float> ReactionPlan::placesAlong(int axis) const {
  std::vector<float> places;
  for (const glm::dvec3& place : cells_.places)
    places.push_back(stored((place[axis] - cells_.low[axis]) * perMetre_));
  return places;
}

// Warns if the steps are too long for the diffusion. For the eigenvalue lambda of the fastest mode,
// explicit methods of order 1 and 2 are stable if dt lambda >= -2, and the method of order 4 if dt lambda
// >= -2.785.
void ReactionPlan::warnOfSteps(const std::string& object) {
  const ReactionParameters& p = parameters_;
  const double limit = p.method == RuleMethod::rk4 ? 2.785 : 2;
  const double fastest = onMesh_ ? fastestOf(cells_) * std::pow(p.spacing / perMetre_, 2) : gridFastest;
  for (const ReactionSpecies& species : p.species) {
    double maximum = 0;
    for (const auto& key : species.diffusion.keys())
      maximum = std::max(maximum, static_cast<double>(key.value));
    const double number = p.dt * maximum / (p.spacing * p.spacing);
    const double greatest = limit / fastest;
    if (number <= greatest) continue;
    tooFast_ = true;
    warn(
        "reaction \"{}\": dt diffusion / spacing^2 of \"{}\" is {:.3g}, and a step is stable up to "
        "{:.3g}; "
        "lower dt to {:.3g}",
        object, species.name, number, greatest, p.dt * greatest / number);
  }
}

void ReactionPlan::checkPictures() const {
  for (const ReactionParameter& parameter : parameters_.parameters)
    if (!parameter.image.empty())
      static_cast<void>(loadPicture(parameter.image, "map of a parameter", maxRuleMapSide));
}

std::vector<float> ReactionPlan::edges() const {
  std::vector<float> all(maxSpecies);
  for (std::size_t i = 0; i < parameters_.species.size(); ++i) all[i] = stored(parameters_.species[i].edge);
  return all;
}

std::vector<float> ReactionPlan::weightsOf(const ReactionParameter& parameter) const {
  const glm::ivec2 size = parameters_.size;
  std::vector<float> weights;
  if (onMesh_ && !parameter.image.empty()) {
    const Picture picture = loadPicture(parameter.image, "map of a parameter", maxRuleMapSide);
    for (const std::uint8_t level : levelsOnGrid(picture, picture.size))
      weights.push_back(static_cast<float>(level) / 255.0F);
    return sampledAt(weights, picture.size, places_);
  }
  if (onMesh_) {
    if (!parameter.across && !parameter.down) return std::vector<float>(static_cast<std::size_t>(size.x));
    const int axis = parameter.across ? 0 : 1;
    const double extent = std::max((cells_.high[axis] - cells_.low[axis]) * perMetre_, 1e-30);
    for (const float place : placesAlong(axis)) {
      const double share = std::clamp(static_cast<double>(place) / extent, 0.0, 1.0);
      weights.push_back(stored(parameter.across ? share : 1 - share));
    }
    return weights;
  }
  weights.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  if (!parameter.image.empty()) {
    const Picture picture = loadPicture(parameter.image, "map of a parameter", maxRuleMapSide);
    for (const std::uint8_t level : levelsOnGrid(picture, size))
      weights.push_back(static_cast<float>(level) / 255.0F);
    // Copies the map to all layers.
    const std::vector<float> layer = weights;
    for (int z = 1; z < parameters_.depth; ++z) weights.insert(weights.end(), layer.begin(), layer.end());
    return weights;
  }
  // The first row is the top row of a plane, but the bottom row of a layer of a volume.
  const bool upwards = parameters_.space() == RuleSpace::volume;
  const auto downTo = [&](int y) {
    return static_cast<float>(upwards ? size.y - 1 - y : y) / static_cast<float>(size.y - 1);
  };
  for (int r = 0; r < size.y * parameters_.depth; ++r)
    for (int x = 0; x < size.x; ++x)
      weights.push_back(parameter.across ? static_cast<float>(x) / static_cast<float>(size.x - 1)
                        : parameter.down ? downTo(r % size.y)
                                         : 0.0F);
  return weights;
}

RuleField ReactionPlan::firstField() const {
  const ReactionParameters& p = parameters_;
  RuleField field;
  field.size = p.size;
  field.depth = p.depth;
  field.boundary = p.boundary;
  field.edges = edges();
  field.seed = noiseSeed();
  const auto cells = static_cast<std::size_t>(p.size.x) * static_cast<std::size_t>(field.rows());
  const bool mapped = std::any_of(
      p.parameters.begin(), p.parameters.end(),
      [](const ReactionParameter& parameter) { return parameter.isMapped() || !parameter.field.empty(); });
  if (mapped || onMesh_)
    for (const ReactionParameter& parameter : p.parameters) field.weights.push_back(weightsOf(parameter));
  field.links = links();
  if (onMesh_)
    for (int axis = 0; axis < bindMaps; ++axis) field.weights.push_back(placesAlong(axis));
  field.stage = evaluateStarts(rule_, valuesAt(0), field);
  field.next = field.base = field.stage;
  if (program_.sums) field.sum = field.stage;
  field.lets.assign(static_cast<std::size_t>(program_.lets), std::vector<float>(cells));
  return field;
}

bool ReactionPlan::retune(const ReactionParameters& now) {
  std::vector<ReactionParameter>& ours = parameters_.parameters;
  const bool alike = std::equal(ours.begin(), ours.end(), now.parameters.begin(), now.parameters.end(),
                                [](const ReactionParameter& a, const ReactionParameter& b) {
                                  return a.name == b.name && a.across == b.across && a.down == b.down &&
                                         a.image == b.image && a.white == b.white && a.field == b.field;
                                });
  if (alike) ours = now.parameters;
  return alike;
}

std::vector<float> ReactionPlan::valuesAt(double time) const {
  const ReactionParameters& p = parameters_;
  std::vector<float> values(static_cast<std::size_t>(rule_.uniforms.count()));
  const auto set = [&](int place, double value) {
    values[static_cast<std::size_t>(place)] = stored(value);
  };
  set(UniformIndex::dt, p.dt);
  set(UniformIndex::halfDt, p.dt / 2);
  set(UniformIndex::sixthDt, p.dt / 6);
  const double perLaplacian = onMesh_ ? 1 : 1 / (6 * p.spacing * p.spacing);
  set(UniformIndex::perLaplacian, perLaplacian);
  set(UniformIndex::perGradient, 1 / (2 * p.spacing));
  set(UniformIndex::spacing, p.spacing);
  const glm::dvec3 extent = onMesh_ ? (cells_.high - cells_.low) * perMetre_
                                    : p.spacing * glm::dvec3(p.size.x, p.size.y, p.depth);
  set(UniformIndex::width, extent.x);
  set(UniformIndex::height, extent.y);
  set(UniformIndex::depth, extent.z);
  for (std::size_t i = 0; i < p.parameters.size(); ++i) {
    const ReactionParameter& parameter = p.parameters[i];
    const auto now = static_cast<double>(parameter.value.at(time));
    const double end = parameter.across          ? *parameter.across
                       : parameter.down          ? *parameter.down
                       : parameter.image.empty() ? now
                                                 : parameter.white;
    set(UniformIndex::value(static_cast<int>(i)), now);
    set(rule_.uniforms.span(static_cast<int>(i)), end - now);
  }
  for (std::size_t i = 0; i < p.species.size(); ++i) {
    const auto d = static_cast<double>(p.species[i].diffusion.at(time));
    set(rule_.uniforms.diffusion(static_cast<int>(i)), onMesh_ ? d : d / (6 * p.spacing * p.spacing));
    set(rule_.uniforms.edge(static_cast<int>(i)), p.species[i].edge);
  }
  return values;
}

long ReactionPlan::stepAt(double time) const {
  return std::lround(time / frameSeconds_ * parameters_.steps);
}

float ReactionPlan::modelTime(long step, long first, double later) const {
  return stored((static_cast<double>(step - first) + later) * parameters_.dt);
}

std::vector<ReactionPlan::Painted> ReactionPlan::strokesAt(double time, int step) const {
  const double seconds = frameSeconds_ / std::max(parameters_.steps, 1);
  const double now = time + step * seconds;
  if (parameters_.space() != RuleSpace::plane) return brushesAt(now, seconds);
  if (strokes_.empty()) return {};
  std::vector<int> numbers;
  const std::vector<shader::Stroke> active =
      strokes_.into(now, seconds, std::lround(now / seconds), &numbers);
  std::vector<Painted> painted;
  for (std::size_t i = 0; i < active.size(); ++i)
    painted.push_back(
        {active[i], parameters_.painted(parameters_.strokes[static_cast<std::size_t>(numbers[i])]), {}});
  return painted;
}

void evaluateStep(const ReactionPlan& plan, std::vector<float> values, long number, long first,
                  RuleField& field) {
  const RuleProgram& program = plan.program();
  field.base = field.stage;
  for (const RuleProgram::Stage& stage : program.stages) {
    values[UniformIndex::time] = plan.modelTime(number, first, stage.time);
    for (const int i : stage.passes) {
      const RulePass& pass = program.passes[static_cast<std::size_t>(i)];
      evaluatePass(plan.rule().graph, pass, ruleUniformsOf(plan.rule().graph, pass, values),
                   static_cast<unsigned>(number), field);
    }
    std::swap(field.stage, field.next);
  }
}

std::vector<float> evaluateShown(const ReactionPlan& plan, std::vector<float> values, long number,
                                 long first, RuleField& field) {
  const RuleProgram& program = plan.program();
  values[UniformIndex::time] = plan.modelTime(number, first, 0);
  for (const int i : program.showing) {
    const RulePass& pass = program.passes[static_cast<std::size_t>(i)];
    evaluatePass(plan.rule().graph, pass, ruleUniformsOf(plan.rule().graph, pass, values), 0, field);
  }
  return field.array(program.shown.array)[static_cast<std::size_t>(program.shown.plane)];
}

}  // namespace simreel::sim
