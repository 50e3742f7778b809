#include "sim/cave/cave.hpp"

#include "sim/cave/growth.hpp"
#include "sim/cave/parameters.hpp"
#include "sim/contour/solid.hpp"
#include "sim/contour/walls.hpp"
#include "sim/core/collider.hpp"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace simreel::sim {

namespace {

/// Returns the palette in the order of glsl/contour/vertices.glsl. Floor beside a wall is darkened because
/// of the wall's shadow, and the upper edge of the rock is brightened.
std::vector<glm::vec4> cavePalette(const CaveParameters& p) {
  const glm::vec3 shade(0.55F);
  const glm::vec3 of[] = {p.floor, p.floor * shade, p.floor,       p.wall * shade, p.wall,
                          p.rock,  p.rock,          p.rock * 1.5F, p.wall * shade, p.wall * 1.15F};
  std::vector<glm::vec4> colors;
  for (const glm::vec3& color : of) colors.emplace_back(color, 1);
  if (p.ceiling) {
    colors[5] = glm::vec4(p.rock, 1);  // The last colours belong to the ceiling, and to the ceiling
                                       // beside a wall.
    colors[6] = glm::vec4(p.rock * shade, 1);
  }
  return colors;
}

class Cave final : public Simulation {
 public:
  Cave(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        distanceName_(name_ + ".distance"),
        material_(object.material),
        parameters_(parametersOf<CaveParameters>(object)),
        frameSeconds_(setting.frameSeconds),
        colors_(parameters_.display.colors()),
        palette_(name_ + " colours", cavePalette(parameters_)),
        growth_(name_, parameters_, setting.seed),
        solid_(name_, parameters_.shape(setting.startTime)),
        walls_(name_, solid_, parameters_.position, parameters_.grip) {
    advanceTo(setting.startTime);
  }

  void step(double time, const StepWatch& watch) override {
    advanceTo(time + frameSeconds_);
    if (watch) watch(1);
  }
  void resumed(double time) override {
    growth_.restored();
    make(time);
  }
  bool grow() override { return solid_.grow(); }
  void connect(Outlets& outlets) override { outlets.provide(&walls_); }

  void publish(double /*time*/, Drawables& drawables) const override {
    publishMap(drawables);
    if (!walk_.empty()) drawables.paths.push_back({&name_, &walk_});
    if (!parameters_.visible) return;
    Surface surface = solid_.surface();
    surface.model = glm::translate(glm::mat4(1), parameters_.position);
    surface.palette = &palette_.view();
    surface.material = &material_;
    drawables.surfaces.push_back(surface);
  }

  void visitCheckpointData(CarryOver& carry) override { growth_.visitCheckpointData(carry); }
  [[nodiscard]] std::vector<StateArray> state() const override {
    return {{"cells", &growth_.cells().buffer(), true},
            {"distances", &growth_.distances().buffer()},
            {"tallies", &solid_.tallies(), true}};
  }
  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    MeshTable table = solid_.unwrapped();
    for (glm::vec3& position : table.positions) position += parameters_.position;
    return table;
  }
  [[nodiscard]] std::optional<ContourLines> lines() const override {
    ContourLines lines = solid_.lines();
    for (const glm::dvec2& at : growth_.way().walk) lines.path.emplace_back(at);
    lines.rooms = growth_.rooms();
    return lines;
  }
  [[nodiscard]] std::vector<double> measure() const override {
    std::int64_t rock = 0;
    for (const glm::uvec4& four : growth_.cells().buffer().readAll<glm::uvec4>())
      for (int i = 0; i < 4; ++i) rock += std::popcount(four[i]);
    const auto path = static_cast<double>(growth_.way().path.size());
    return {static_cast<double>(growth_.grid().numbers() - rock), path - 1};
  }

 private:
  void advanceTo(double time) {
    const int stage = parameters_.stageAt(time);
    const std::vector<float> heights = parameters_.heightsAt(time);
    const float transition = parameters_.transitionAt(time);
    if (made_ && stage == growth_.stage() && transition == transition_ && heights == heights_) return;
    growth_.advance(std::max(stage, growth_.stage()));
    make(time);
  }
  void make(double time) {
    heights_ = parameters_.heightsAt(time);
    transition_ = parameters_.transitionAt(time);
    if (parameters_.moves()) growth_.blend(transition_);
    solid_.make(parameters_.moves() ? blended() : map(), heights_);
    made_ = true;
    walk_.clear();
    for (const glm::dvec2& at : growth_.way().walk) walk_.push_back(placeOf(at));
  }

  /// Returns the world position, on the floor, of a point given in cells.
  [[nodiscard]] glm::vec3 placeOf(glm::dvec2 at) const {
    const glm::dvec2 middle = 0.5 * glm::dvec2(parameters_.size - 1);
    const glm::vec2 place(static_cast<double>(parameters_.cell) * (at - middle));
    return parameters_.position + glm::vec3(place.x, 0, place.y);
  }
  [[nodiscard]] Field map() const {
    Field field;
    field.name = &name_;
    field.words = &growth_.cells().view();
    field.cells = Field::Cells::bits;
    field.size = parameters_.size;
    field.rowWords = growth_.grid().rowWords();
    field.range = {static_cast<float>(parameters_.display.low),
                   static_cast<float>(parameters_.display.high)};
    field.colors = &colors_;
    field.display = &parameters_.display;
    static const std::vector<std::pair<int, std::string>> classes = {{0, "open"}, {1, "rock"}};
    if (colors_.size() == 2 && field.range == glm::vec2(0, 1)) field.classes = &classes;
    return field;
  }
  /// Returns the field whose contours are the solid's walls while it moves from stage to stage.
  [[nodiscard]] Field blended() const {
    Field field = map();
    field.words = &growth_.blended().view();
    field.cells = Field::Cells::floats;
    field.rowWords = 32 * growth_.grid().rowWords();
    return field;
  }
  void publishMap(Drawables& drawables) const {
    const bool showsCells = parameters_.show == CaveParameters::Show::cells;
    Field field = map();
    if (!showsCells) field.display = nullptr;
    drawables.fields.push_back(field);
    field.name = &distanceName_;
    field.words = &growth_.distances().view();
    field.cells = Field::Cells::floats;
    field.rowWords = 32 * growth_.grid().rowWords();
    field.range = {0.0F, static_cast<float>(std::max<std::size_t>(growth_.way().path.size(), 2) - 1)};
    field.display = showsCells ? nullptr : &parameters_.display;
    drawables.fields.push_back(field);
  }

  std::string name_, distanceName_;
  scene::Material material_;
  CaveParameters parameters_;
  double frameSeconds_;
  std::vector<glm::vec3> colors_;
  gl::Vec4Array palette_;
  CaveGrowth growth_;
  Solid solid_;
  Walls walls_;
  std::vector<float> heights_;
  float transition_ = 1;
  std::vector<glm::vec3> walk_;  ///< Points of the smoothed path in metres.
  bool made_ = false;
};

}  // namespace

SimulationKind caveKind() {
  return kindOf<CaveParameters>("cave",
                                "Caves grown by a cellular automaton, as a map and as a solid to walk in.",
                                nullptr, makeSimulation<Cave>);
}

}  // namespace simreel::sim
