#include "sim/arrows/arrows.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/arrows/parameters.hpp"
#include "sim/core/collider.hpp"
#include "sim/core/kind.hpp"
#include "sim/flow/sheet.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/kernels/copies.hpp"
#include "sim/ports/color_scale.hpp"
#include "sim/ports/moving_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace simreel::sim {

namespace {

/// Part of a kernel interface: inputs common to both kernels (glsl/arrows/arrow.glsl).
struct ArrowPart {
  gl::Uniform<"count", int> count;
  gl::Uniform<"scale", float> scale;
  gl::Uniform<"longest", float> longest;
  gl::Uniform<"low", float> low;
  gl::Uniform<"perRange", float> perRange;
  gl::Uniform<"ahead", float> ahead;
  gl::Out<"places"> places;
  gl::Out<"speeds"> speeds;
  gl::Out<"turns"> turns;
};

struct GridArrows {
  static constexpr auto file = "arrows/grid.comp";
  ArrowPart part;
  gl::Uniform<"columns", int> columns;
  gl::Uniform<"first", glm::vec3> first;
  gl::Uniform<"across", glm::vec3> across;
  gl::Uniform<"down", glm::vec3> down;
  gl::Uniform<"above", glm::vec3> above;
  FluidWindPart wind;
};

struct PointArrows {
  static constexpr auto file = "arrows/points.comp";
  ArrowPart part;
  gl::Uniform<"every", int> every;
  gl::In<"positions"> positions;
  gl::In<"velocities"> velocities;
};

/// Regular grid of positions in the world at which arrows are drawn.
struct ArrowGrid {
  glm::ivec2 size{0, 0};
  glm::vec3 first{0};   ///< position of the top left grid point in metres
  glm::vec3 across{0};  ///< vector in metres from a grid point to its right neighbour
  glm::vec3 down{0};    ///< vector in metres from a grid point to the neighbour below
  glm::vec3 above{0};   ///< vector in metres from the source's plane to the arrows
};

ArrowGrid gridOf(const FluidWind& wind, float spacing, float height) {
  const FluidPlane& plane = wind.plane();
  const glm::mat4 turned = rotationMatrix(plane.rotation);
  const glm::vec2 extent = plane.cell * glm::vec2(wind.grid().size);
  ArrowGrid grid;
  for (int axis = 0; axis < 2; ++axis)
    grid.size[axis] = std::max(1, static_cast<int>(std::min(extent[axis] / spacing + 1e-3F, 1e5F)));
  grid.across = spacing * glm::vec3(turned[0]);
  grid.down = -spacing * glm::vec3(turned[1]);
  grid.first = plane.position - 0.5F * (static_cast<float>(grid.size.x - 1) * grid.across +
                                        static_cast<float>(grid.size.y - 1) * grid.down);
  grid.above = height * glm::vec3(turned[2]);
  return grid;
}

/// Arrows that show the velocities of another object. This object has no state.
class Arrows : public Simulation, public HasShownSpeeds, public HasColorScale {
 public:
  Arrows(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        parameters_(parametersOf<ArrowParameters>(object)),
        material_(object.material),
        wind_(setting.find<FluidWind>(parameters_.of)),
        points_(wind_ != nullptr ? nullptr : setting.find<MovingPoints>(parameters_.of)),
        ofGrid_(gl::kernelDefines(setting.fast)),
        ofPoints_(gl::kernelDefines(setting.fast)) {
    wind_ != nullptr ? planGrid() : planPoints();
    if (count_ > maxArrows)
      fail(ExitCode::usage, "arrows \"{}\": {} arrows are more than the {} that fit here; {}", name_,
           count_, maxArrows, wind_ != nullptr ? "raise \"spacing\"" : "draw fewer with \"every\"");
    places_ = gl::Vec4Array(name_ + " places", static_cast<int>(count_));
    speeds_ = gl::Vec4Array(name_ + " speeds", static_cast<int>(count_));
    turns_ = gl::Vec4Array(name_ + " turns", static_cast<int>(count_));
    if (parameters_.sheet && wind_ != nullptr)
      sheet_.emplace(name_, wind_->plane(), wind_->grid().size, object.material);
    material_.skin.reset();
    update();
  }

  void step(double /*time*/, const StepWatch& /*watch*/) override { update(); }
  void pass(double /*time*/) override {}
  void resumed(double /*time*/) override { update(); }

  void publish(double time, Drawables& drawables) const override {
    static_cast<void>(time);
    if (sheet_) drawables.surfaces.push_back(sheet_->surface());
    drawables.instances.push_back(instances());
  }

  [[nodiscard]] PointTable points() const override {
    PointTable table{{"x", "y", "z", "dx", "dy", "dz", "length"}, {}};
    const auto places = places_.buffer().readAll<glm::vec4>(),
               speeds = speeds_.buffer().readAll<glm::vec4>(), turns = turns_.buffer().readAll<glm::vec4>();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const glm::vec4 &p = places[i], &d = turns[i];
      if (speeds[i].w >= 0) table.values.insert(table.values.end(), {p.x, p.y, p.z, d.x, d.y, d.z, p.w});
    }
    return table;
  }
  [[nodiscard]] ColorScale colorScale() const override { return {parameters_.colors, range_, false, {}}; }
  /// Computes the arrows once more with a range that no speed exceeds, and with a scale at which no arrow
  /// is left out.
  [[nodiscard]] std::vector<float> shownSpeeds() const override {
    constexpr float whole = 1 << 20;  // m/s; a power of two, so that quotients are exact
    ArrowPart part = part_;
    part.low = 0.0F;
    part.perRange = 1 / whole;
    part.scale = whole * part_.longest.value;
    place(part);
    std::vector<float> shown;
    for (const glm::vec4& speed : speeds_.buffer().readAll<glm::vec4>())
      if (speed.w >= 0) shown.push_back(whole * speed.w);
    update();
    return shown;
  }
  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    MeshTable all = copiesOf(instances(), places_.buffer().readAll<glm::vec4>(),
                             speeds_.buffer().readAll<glm::vec4>(), turns_.buffer().readAll<glm::vec4>());
    if (sheet_) append(all, sheet_->table());
    return all;
  }

 private:
  void planGrid() {
    const FluidPlane& plane = wind_->plane();
    const glm::ivec2 cells = wind_->grid().size;
    constexpr float inLine = 28;
    const auto longer = plane.cell * static_cast<float>(std::max(cells.x, cells.y));
    const float spacing = parameters_.spacing ? static_cast<float>(*parameters_.spacing) : longer / inLine;
    part_.longest = static_cast<float>(parameters_.length.value_or(static_cast<double>(spacing)));
    grid_ = gridOf(*wind_, spacing, heightOf(part_.longest.value));
    count_ = std::int64_t{grid_.size.x} * grid_.size.y;
    planRange(wind_->speed() * plane.cell, ArrowParameters::Anchor::middle);
  }
  void planPoints() {
    SIMREEL_CHECK(points_ != nullptr);
    part_.longest = parameters_.lengthAt(points_->size);
    count_ = (points_->count + parameters_.every - 1) / parameters_.every;
    planRange(points_->speed, ArrowParameters::Anchor::tail);
  }
  [[nodiscard]] float heightOf(float longest) const {
    return parameters_.height ? static_cast<float>(*parameters_.height) : 0.15F * longest;
  }
  /// Determines the range of speeds and the anchor. `fastest` is the maximum speed of the source in m/s,
  /// `anchor` the default for this source.
  void planRange(float fastest, ArrowParameters::Anchor anchor) {
    const auto low = static_cast<float>(parameters_.speeds.low);
    const auto high = static_cast<float>(parameters_.speeds.last(static_cast<double>(fastest)));
    range_ = {low, high};
    part_.count = static_cast<int>(std::min<std::int64_t>(count_, maxArrows));
    part_.scale = parameters_.scale ? static_cast<float>(*parameters_.scale) : part_.longest.value / high;
    part_.low = low;
    part_.perRange = 1 / (high - low);
    part_.ahead = parameters_.anchor.value_or(anchor) == ArrowParameters::Anchor::tail ? 0.5F : 0.0F;
  }

  void update() const { place(part_); }

  /// Computes all arrows.
  void place(ArrowPart part) const {
    part.places = places_;
    part.speeds = speeds_;
    part.turns = turns_;
    gl::barrier();
    if (wind_ != nullptr)
      ofGrid_.dispatch(part.count.value, {.part = part,
                                          .columns = grid_.size.x,
                                          .first = grid_.first,
                                          .across = grid_.across,
                                          .down = grid_.down,
                                          .above = grid_.above,
                                          .wind = wind_->part()});
    else
      ofPoints_.dispatch(part.count.value, {.part = part,
                                            .every = parameters_.every,
                                            .positions = *points_->positions,
                                            .velocities = *points_->velocities});
    gl::barrier();
  }

  [[nodiscard]] Instances instances() const {
    Instances instances;
    instances.positions = &places_.view();
    instances.velocities = &speeds_.view();
    instances.capacity = part_.count.value;
    instances.shape = Instances::Shape::mesh;
    instances.mesh = assetFolder() / "meshes" / "arrow.obj";
    instances.turning = Instances::Turning::direction;
    instances.turns = &turns_.view();
    instances.size = 1;
    instances.massExponent = 1;  // the mass of an instance is the arrow's length
    if (!parameters_.colors.empty()) {
      instances.colorBy = Instances::ColorBy::age;  // the age of an instance is the speed mapped to 0 to 1
                                                    // within its range
      instances.colors = &parameters_.colors;
    }
    instances.material = &material_;
    return instances;
  }

  std::string name_;
  ArrowParameters parameters_;
  scene::Material material_;
  const FluidWind* wind_;       ///< source of the velocities, if it is a field
  const MovingPoints* points_;  ///< source of the velocities, if it consists of points
  std::int64_t count_ = 0;
  ArrowGrid grid_;
  ArrowPart part_;
  glm::vec2 range_{0, 1};  ///< speeds of the first and the last colour in m/s
  gl::Kernel<GridArrows> ofGrid_;
  gl::Kernel<PointArrows> ofPoints_;
  gl::Vec4Array places_;  ///< xyz: centre of the arrow in metres; w: length of the arrow in metres
  gl::Vec4Array speeds_;  ///< xyz: velocity at which the arrow moves; w: speed mapped to 0 to 1 within its
                          ///< range, or -1 if there is no arrow
  gl::Vec4Array turns_;   ///< xyz: unit vector along the arrow
  std::optional<FieldSheet> sheet_;
};

}  // namespace

SimulationKind arrowsKind() {
  return kindOf<ArrowParameters>("arrows", "Arrows along the velocities of a fluid, a flow or particles.",
                                 nullptr, makeSimulation<Arrows>);
}

}  // namespace simreel::sim
