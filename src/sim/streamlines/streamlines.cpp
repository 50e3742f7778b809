#include "sim/streamlines/streamlines.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/collider.hpp"
#include "sim/core/kind.hpp"
#include "sim/flow/sheet.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/ports/color_scale.hpp"
#include "sim/streamlines/parameters.hpp"
#include "sim/tubes/tubes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

namespace simreel::sim {

namespace {

constexpr int pointsPerLine = 2 * pointsAside + 1;
constexpr int rounds = 12;  // number of rounds of trimming; each round makes those undecided lines final
                            // that are the longest in their surroundings

/// Part of a kernel interface: inputs common to all kernels (glsl/streamlines/lines.glsl).
struct LinePart {
  gl::Uniform<"count", int> count;
  gl::InOut<"points"> points;
  gl::InOut<"SpanBlock"> spans;
};

struct TraceLines {
  static constexpr auto file = "streamlines/trace.comp";
  LinePart part;
  gl::Uniform<"columns", int> columns;
  gl::Uniform<"seed", int> seed;
  gl::Uniform<"first", glm::vec3> first;
  gl::Uniform<"across", glm::vec3> across;
  gl::Uniform<"down", glm::vec3> down;
  gl::Uniform<"normal", glm::vec3> normal;
  gl::Uniform<"height", float> height;
  gl::Uniform<"stride", float> stride;
  gl::Uniform<"still", float> still;
  gl::Uniform<"low", float> low;
  gl::Uniform<"perRange", float> perRange;
  FluidWindPart wind;
};

/// Part of a kernel interface: inputs of the kernels that keep lines apart (glsl/streamlines/claims.glsl).
struct ClaimPart {
  gl::Uniform<"round", int> round;
  gl::Uniform<"cellCount", glm::ivec2> cellCount;
  gl::Uniform<"toColumn", glm::vec4> toColumn;
  gl::Uniform<"toRow", glm::vec4> toRow;
  gl::InOut<"ClaimBlock"> claims;
};

struct ClearClaims {
  static constexpr auto file = "streamlines/clear.comp";
  gl::Uniform<"count", int> count;
  gl::Out<"ClaimBlock"> claims;
};

struct ClaimCells {
  static constexpr auto file = "streamlines/claim.comp";
  LinePart part;
  ClaimPart claim;
};

struct TrimLines {
  static constexpr auto file = "streamlines/trim.comp";
  LinePart part;
  ClaimPart claim;
  gl::Uniform<"fewest", int> fewest;
};

struct NumberLines {
  static constexpr auto file = "streamlines/number.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"tubes", int> tubes;
  gl::Uniform<"indicesPerTube", int> indicesPerTube;
  gl::In<"SpanBlock"> spans;
  gl::Out<"TubeBlock"> tubeSpans;
  gl::Out<"ArgumentBlock"> arguments;
};

/// Streamlines of another object's flow. This object has no state.
class Streamlines : public Simulation, public HasShownSpeeds, public HasColorScale {
 public:
  Streamlines(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        parameters_(parametersOf<StreamlineParameters>(object)),
        material_(object.material),
        wind_(setting.wanted<FluidWind>(parameters_.of)),
        trace_(gl::kernelDefines(setting.fast)),
        clear_(gl::kernelDefines(setting.fast)),
        claim_(gl::kernelDefines(setting.fast)),
        trim_(gl::kernelDefines(setting.fast)),
        number_(gl::kernelDefines(setting.fast)) {
    seed_ = parameters_.seed.value_or(setting.seed);
    plan();
    points_ = gl::Vec4Array(name_ + " points", count_ * pointsPerLine);
    spans_ = gl::Buffer(name_ + " spans", std::size_t{16} * static_cast<std::size_t>(count_));
    claims_ = gl::Buffer(name_ + " claims", std::size_t{4} * static_cast<std::size_t>(cells_.x) *
                                                static_cast<std::size_t>(cells_.y));
    const bool own = parameters_.colors.empty();
    tubeSpans_ =
        gl::Buffer(name_ + " spans of tubes", std::size_t{16} * static_cast<std::size_t>(tubeCount_));
    tubes_ = Tubes(name_, tubeCount_, pointsPerLine,
                   own ? std::vector<glm::vec3>{glm::vec3(1)} : parameters_.colors, setting.fast);
    if (!own) material_.color = glm::vec3(1);
    if (parameters_.sheet) sheet_.emplace(name_, wind_->plane(), wind_->grid().size, object.material);
    material_.skin.reset();
    update();
  }

  void step(double /*time*/, const StepWatch& /*watch*/) override { update(); }
  void pass(double /*time*/) override {}
  void resumed(double /*time*/) override { update(); }

  void publish(double /*time*/, Drawables& drawables) const override {
    if (sheet_) drawables.surfaces.push_back(sheet_->surface());
    drawables.surfaces.push_back(tubes_.surface(material_));
  }

  [[nodiscard]] PointTable points() const override {
    PointTable table{{"x", "y", "z", "line", "color"}, {}};
    const auto points = points_.buffer().readAll<glm::vec4>();
    const auto spans = spans_.readAll<glm::ivec4>();
    for (std::size_t line = 0; line < spans.size(); ++line)
      for (int i = spans[line].x; spans[line].x < spans[line].y && i <= spans[line].y; ++i) {
        const glm::vec4& p = points[line * pointsPerLine + static_cast<std::size_t>(i)];
        table.values.insert(table.values.end(), {p.x, p.y, p.z, static_cast<float>(line), p.w});
      }
    return table;
  }
  [[nodiscard]] ColorScale colorScale() const override { return {parameters_.colors, range_, false, {}}; }
  /// Computes the lines once more with a range that no speed exceeds.
  [[nodiscard]] std::vector<float> shownSpeeds() const override {
    constexpr float whole = 1 << 20;  // m/s; a power of two, so that quotients are exact
    trace(0, 1 / whole);
    std::vector<float> shown;
    const auto points = points_.buffer().readAll<glm::vec4>();
    const auto spans = spans_.readAll<glm::ivec4>();
    for (std::size_t line = 0; line < spans.size(); ++line)
      for (int i = spans[line].x; spans[line].x < spans[line].y && i <= spans[line].y; ++i)
        shown.push_back(whole * points[line * pointsPerLine + static_cast<std::size_t>(i)].w);
    trace(range_.x, perRange_);
    return shown;
  }
  [[nodiscard]] std::optional<MeshTable> mesh() const override { return tubes_.table(); }

 private:
  void plan() {
    const FluidPlane& plane = wind_->plane();
    const glm::vec2 extent = plane.cell * glm::vec2(wind_->grid().size);
    constexpr double inLine = 56, separations = 30;
    const double separation =
        parameters_.separation.value_or(static_cast<double>(std::max(extent.x, extent.y)) / inLine);
    const auto distance = static_cast<float>(separation);
    stride_ = static_cast<float>(parameters_.length.value_or(separations * separation) / (2 * pointsAside));
    width_ = static_cast<float>(parameters_.width.value_or(0.3 * separation));
    height_ = static_cast<float>(parameters_.height.value_or(static_cast<double>(width_)));
    // There are more seeds than lines, so that lines fill the gaps that others leave.
    constexpr double seedsPerSeparation = 1.6;
    const glm::dvec2 seeds =
        glm::max(glm::dvec2(1), glm::floor(seedsPerSeparation * glm::dvec2(extent) / separation + 1e-3));
    if (seeds.x * seeds.y > maxSeeds)
      fail(ExitCode::usage,
           "streamlines \"{}\": a separation of {:g} m makes {:.0f} seeds, more than the {} that fit here; "
           "raise "
           "\"separation\"",
           name_, separation, seeds.x * seeds.y, maxSeeds);
    columns_ = static_cast<int>(seeds.x);
    count_ = columns_ * static_cast<int>(seeds.y);
    // Lines are at least two and a half separations long and at least half a separation apart.
    tubeCount_ = std::max(1, count_ / 3);
    const glm::mat4 turned = rotationMatrix(plane.rotation);
    const glm::vec3 right(turned[0]), up(turned[1]);
    normal_ = glm::vec3(turned[2]);
    across_ = extent.x / static_cast<float>(seeds.x) * right;
    down_ = -extent.y / static_cast<float>(seeds.y) * up;
    first_ = plane.position -
             0.5F * (static_cast<float>(seeds.x - 1) * across_ + static_cast<float>(seeds.y - 1) * down_);
    const glm::vec3 corner = plane.position - 0.5F * extent.x * right + 0.5F * extent.y * up;
    cells_ = glm::ivec2(extent / (0.5F * distance)) + 1;
    toColumn_ = glm::vec4(2 / distance * right, -2 / distance * glm::dot(right, corner));
    toRow_ = glm::vec4(-2 / distance * up, 2 / distance * glm::dot(up, corner));
    const double fastest = static_cast<double>(wind_->speed() * plane.cell);
    const double high = parameters_.speeds.last(fastest);
    range_ = glm::vec2(parameters_.speeds.low, high);
    perRange_ = static_cast<float>(1 / (high - parameters_.speeds.low));
    still_ = static_cast<float>(1e-4 * std::max(fastest, 1e-6));
    fewest_ = std::max(2, static_cast<int>(2.5F * distance / stride_));
  }

  void update() {
    trace(range_.x, perRange_);
    tubes_.make(points_, tubeSpans_, {.radius = 0.5F * width_, .taperFirst = 8, .taperLast = 8});
  }

  /// Computes all lines with colours that begin at the speed `low` (m/s). `perRange`: 1 / (width of the
  /// range of speeds), in s/m.
  void trace(float low, float perRange) const {
    const LinePart part{.count = count_, .points = points_, .spans = spans_};
    gl::barrier();
    trace_.dispatch(count_, {.part = part,
                             .columns = columns_,
                             .seed = seed_,
                             .first = first_,
                             .across = across_,
                             .down = down_,
                             .normal = normal_,
                             .height = height_,
                             .stride = stride_,
                             .still = still_,
                             .low = low,
                             .perRange = perRange,
                             .wind = wind_->part()});
    clear_.dispatch(cells_.x * cells_.y, {.count = cells_.x * cells_.y, .claims = claims_});
    for (int round = 1; round <= rounds; ++round) {
      const ClaimPart claim{.round = rounds - round,
                            .cellCount = cells_,
                            .toColumn = toColumn_,
                            .toRow = toRow_,
                            .claims = claims_};
      claim_.dispatch(count_, {.part = part, .claim = claim});
      trim_.dispatch(count_, {.part = part, .claim = claim, .fewest = fewest_});
    }
    number_.dispatch(1, {.count = count_,
                         .tubes = tubeCount_,
                         .indicesPerTube = tubes_.indicesPerTube(),
                         .spans = spans_,
                         .tubeSpans = tubeSpans_,
                         .arguments = tubes_.arguments()});
  }

  std::string name_;
  StreamlineParameters parameters_;
  scene::Material material_;
  const FluidWind* wind_;
  int seed_ = 1, columns_ = 1, count_ = 1, tubeCount_ = 1, fewest_ = 2;
  float stride_ = 0, width_ = 0, height_ = 0, still_ = 0, perRange_ = 1;
  glm::vec2 range_{0, 1};  ///< speeds of the first and the last colour in m/s
  glm::vec3 first_{0}, across_{0}, down_{0}, normal_{0};
  glm::ivec2 cells_{1, 1};
  glm::vec4 toColumn_{0}, toRow_{0};
  gl::Vec4Array points_;  ///< xyz: position in metres; w: position of the speed within its range, 0 to 1
  gl::Buffer spans_;      ///< two spans per line, each with the indices of a first and a last point: the
                          ///< current span, and the span as traced
  gl::Buffer tubeSpans_;  ///< spans of the lines that are drawn
  gl::Buffer claims_;     ///< for each cell: round and rank of the line that claims it
  Tubes tubes_;
  gl::Kernel<TraceLines> trace_;
  gl::Kernel<ClearClaims> clear_;
  gl::Kernel<ClaimCells> claim_;
  gl::Kernel<TrimLines> trim_;
  gl::Kernel<NumberLines> number_;
  std::optional<FieldSheet> sheet_;
};

}  // namespace

SimulationKind streamlinesKind() {
  return kindOf<StreamlineParameters>("streamlines",
                                      "Evenly spaced lines along the flow of a fluid or a flow.", nullptr,
                                      makeSimulation<Streamlines>);
}

}  // namespace simreel::sim
