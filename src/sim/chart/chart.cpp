#include "sim/chart/chart.hpp"

#include "gl/element_array.hpp"
#include "sim/chart/parameters.hpp"
#include "sim/core/frame_observer.hpp"
#include "sim/core/kind.hpp"
#include "sim/ports/measured.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr unsigned fullHeight = 1U << 24U;  ///< count that is drawn at the full height of the chart
constexpr int firstRows = 256;
constexpr std::array<glm::vec3, ChartParameters::maxCurves> curveColors = {
    glm::vec3(1, 0.42F, 0.08F), glm::vec3(0.08F, 0.45F, 1), glm::vec3(0.2F, 0.8F, 0.25F),
    glm::vec3(0.8F, 0.3F, 0.9F)};

/// Curves drawn over the picture. The state consists of the recorded values: one double per curve and
/// frame, from time 0 on.
class ChartObject : public Simulation, public FrameObserver {
 public:
  using Row = std::array<double, ChartParameters::maxCurves>;

  ChartObject(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        parameters_(parametersOf<ChartParameters>(object)),
        frameSeconds_(setting.frameSeconds),
        measured_(setting.links, object),
        kept_(name_, bytesOf(firstRows)),
        counts_(name_ + " counts", firstRows) {}

  void step(double /*time*/, const StepWatch& /*watch*/) override {}

  void observe(double time) override {
    if (time < -0.5 * frameSeconds_) return;
    Row row{};
    for (std::size_t i = 0; i < parameters_.curves.size(); ++i) {
      const ChartParameters::Curve& curve = parameters_.curves[i];
      row[i] = measured_(curve.object(), curve.quantity()) / curve.per;
    }
    rows_.push_back(row);
    if (rows_.size() > room_) {
      room_ *= 2;
      kept_ = gl::Buffer(name_, bytesOf(room_));
      kept_.write(0, std::as_bytes(std::span(rows_)));
      counts_ = gl::WordsArray(name_ + " counts", static_cast<int>(room_));
      shown_ = {0, 0};  // The scale is unknown, because the new buffer is still empty.
      return;
    }
    kept_.write(bytesOf(rows_.size() - 1), std::as_bytes(std::span(&rows_.back(), 1)));
  }

  void visitCheckpointData(CarryOver& carry) override {
    std::size_t rows = rows_.size(), room = room_;
    carry.number("noted frames", rows);
    carry.number("room for noted frames", room);
    if (room != room_) {
      room_ = room;
      kept_ = gl::Buffer(name_, bytesOf(room));
      counts_ = gl::WordsArray(name_ + " counts", static_cast<int>(room));
    }
    carry.array("noted", kept_);
    rows_.resize(rows);
    kept_.read(0, std::as_writable_bytes(std::span(rows_)));
    shown_ = {0, 0};
  }

  void publish(double /*time*/, Drawables& drawables) const override {
    const ChartRange range = rangeNow();
    count(range);
    Chart chart;
    chart.object = &name_;
    chart.counts = &counts_.view();
    chart.steps = static_cast<int>(rows_.size());
    const int asked = static_cast<int>(std::ceil(parameters_.seconds / frameSeconds_ - 1e-6)) + 1;
    chart.width = std::max({chart.steps, asked, 2});
    chart.max = fullHeight;
    chart.corner = {parameters_.x, parameters_.y};
    chart.extent = {parameters_.width, parameters_.height};
    chart.zero = static_cast<float>(std::clamp(-range.low / (range.high - range.low), 0.0, 1.0));
    chart.range = fmt::format("{:.6g} to {:.6g}", range.low + 0.0, range.high + 0.0);
    chart.length = fmt::format("{:.4g} s", (chart.width - 1) * frameSeconds_);
    for (std::size_t i = 0; i < parameters_.curves.size(); ++i) {
      const ChartParameters::Curve& curve = parameters_.curves[i];
      chart.names.push_back(curve.label.empty() ? curve.quantity() : curve.label);
      chart.colors.push_back(curve.color.value_or(curveColors[i]));
    }
    drawables.charts.push_back(std::move(chart));
  }

 private:
  static constexpr std::size_t bytesOf(std::size_t rows) { return rows * sizeof(Row); }

  /// Returns the range of the value axis: the limits given by the scene, otherwise rounded limits of the
  /// recorded values.
  [[nodiscard]] ChartRange rangeNow() const {
    double minimum = std::numeric_limits<double>::max(), maximum = std::numeric_limits<double>::lowest();
    for (const Row& row : rows_)
      for (std::size_t i = 0; i < parameters_.curves.size(); ++i) {
        if (!(std::abs(row[i]) < 1e30)) continue;
        minimum = std::min(minimum, row[i]);
        maximum = std::max(maximum, row[i]);
      }
    if (minimum > maximum) minimum = maximum = 0;
    if (parameters_.low) minimum = std::min(minimum, *parameters_.low);
    if (parameters_.high) maximum = std::max(maximum, *parameters_.high);
    ChartRange range = roundRange(minimum, maximum);
    if (parameters_.low) range.low = *parameters_.low;
    if (parameters_.high) range.high = *parameters_.high;
    if (!(range.low < range.high)) range.high = range.low + 1;
    return range;
  }

  /// Uploads the rows that are new. If the scale has changed, uploads all rows.
  void count(const ChartRange& range) const {
    const bool same = shown_.low == range.low && shown_.high == range.high;
    const std::size_t first = same ? std::min(counted_, rows_.size()) : 0;
    std::vector<glm::uvec4> counts;
    for (std::size_t row = first; row < rows_.size(); ++row) {
      glm::uvec4& made = counts.emplace_back(0U);
      for (std::size_t i = 0; i < parameters_.curves.size(); ++i) {
        const double high = (rows_[row][i] - range.low) / (range.high - range.low);
        // For NaN, the comparison is false, so the count stays 0.
        if (high > 0)
          made[static_cast<int>(i)] =
              static_cast<unsigned>(std::floor(std::min(high, 1.0) * fullHeight + 0.5));
      }
    }
    if (!counts.empty())
      counts_.buffer().write(first * sizeof(glm::uvec4), std::as_bytes(std::span(counts)));
    counted_ = rows_.size();
    shown_ = range;
  }

  std::string name_;
  ChartParameters parameters_;
  double frameSeconds_;
  QuantityReader measured_;
  std::size_t room_ = firstRows;
  std::vector<Row> rows_;
  gl::Buffer kept_;  ///< copy of rows_ on the GPU, which visitCheckpointData() visits
  mutable gl::WordsArray counts_;
  mutable std::size_t counted_ = 0;    ///< number of valid rows in counts_
  mutable ChartRange shown_ = {0, 0};  ///< scale of the rows in counts_
};

void checkChart(const scene::Object& /*object*/, const Setting& /*setting*/) {}

}  // namespace

SimulationKind chartKind() {
  return kindOf<ChartParameters>("chart", "Curves over the picture, which show what other objects measure.",
                                 checkChart, makeSimulation<ChartObject>);
}

}  // namespace simreel::sim
