#include "sim/fluid/chart.hpp"

#include "sim/fluid/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr unsigned whole = 1U << 24U;  ///< Maximum count such that floats represent every smaller integer.
constexpr int firstRoom = 1024;
const std::vector<const char*> names = {"lift",      "drag",        "kineticEnergy",
                                        "enstrophy", "temperature", "speed"};
constexpr glm::vec3 colors[] = {
    {1, 0.42F, 0.08F}, {0.08F, 0.45F, 1}, {0.2F, 0.8F, 0.25F}, {0.8F, 0.3F, 0.9F}};

const char* nameOf(FluidChartParameters::Quantity quantity) {
  return names[static_cast<std::size_t>(quantity)];
}

/// Returns the index of a quantity in FluidParameters::quantities().
std::size_t placeOf(FluidChartParameters::Quantity quantity) {
  const auto list = FluidParameters().quantities();
  const auto is = [&](const scene::Quantity& q) { return std::string_view(q.name) == nameOf(quantity); };
  return static_cast<std::size_t>(std::find_if(list.begin(), list.end(), is) - list.begin());
}

}  // namespace

bool FluidChartParameters::showsForces() const {
  return std::any_of(curves.begin(), curves.end(), [](const Curve& curve) {
    return curve.of == Quantity::lift || curve.of == Quantity::drag;
  });
}

void FluidChartParameters::describe(scene::Fields& f) {
  f.list(
      "curves", curves, "Curves that are drawn; left out: the lift.",
      [](scene::Fields& c, Curve& curve) {
        c.choice("of", curve.of, names, "The quantity, as \"checks\" know it.");
        c.number("per", curve.per, {1e-12, 1e12}, "",
                 "Value that the chart shows as 1; for a coefficient, speed^2 * diameter / 2.");
        glm::vec3 color = curve.color.value_or(glm::vec3(0));
        c.color("color", color, scene::fraction, "Colour of the curve, linear RGB.");
        c.leftOut("color", "orange, blue, green, violet");
        if (c.given("color")) curve.color = color;
      },
      4);
  f.number("low", low, {-1e12, 1e12}, "", "Value at the foot of the chart.");
  f.number("high", high, {-1e12, 1e12}, "", "Value at the top of the chart, greater than \"low\".");
  if (high <= low) f.error("high", "\"high\" is not above \"low\"");
  f.number("seconds", seconds, {0, 1e6}, "s",
           "Length of its time axis, which grows beyond that when needed.");
}

FluidChart::FluidChart(const std::string& name, const FluidChartParameters& parameters, double frameSeconds)
    : name_(name + " chart"),
      parameters_(&parameters),
      frameSeconds_(frameSeconds),
      room_(firstRoom),
      rows_(name_, firstRoom) {}

void FluidChart::add(std::span<const double> measured) {
  if (done_ == room_) {
    gl::WordsArray longer(name_, 2 * room_);
    glCopyNamedBufferSubData(rows_.buffer().name(), longer.buffer().name(), 0, 0,
                             static_cast<GLsizeiptr>(room_) * 16);
    rows_ = std::move(longer);
    room_ *= 2;
  }
  const FluidChartParameters& p = *parameters_;
  glm::uvec4 row(0);
  for (std::size_t i = 0; i < p.curves.size(); ++i) {
    const double shown = measured[placeOf(p.curves[i].of)] / p.curves[i].per;
    const double height = (shown - p.low) / (p.high - p.low);
    // If the value is NaN, the comparison is false and the count is 0.
    row[static_cast<int>(i)] =
        height > 0 ? static_cast<unsigned>(std::floor(std::min(height, 1.0) * whole + 0.5)) : 0;
  }
  rows_.buffer().write(static_cast<std::size_t>(done_++) * 16, std::as_bytes(std::span(&row, 1)));
}

void FluidChart::visitCheckpointData(CarryOver& carry) {
  const int room = room_;
  carry.number("charted frames", done_);
  carry.number("room for charted frames", room_);
  if (room_ != room) rows_ = gl::WordsArray(name_, room_);
  carry.array("chart", rows_.buffer());
}

void FluidChart::publish(Drawables& drawables) const {
  const FluidChartParameters& p = *parameters_;
  Chart chart;
  chart.counts = &rows_.view();
  chart.steps = done_;
  chart.width = std::max({done_, static_cast<int>(std::ceil(p.seconds / frameSeconds_ - 1e-6)) + 1, 2});
  chart.max = whole;
  chart.corner = {0.025F, 0.67F};
  chart.extent = {0.42F, 0.3F};
  chart.zero = static_cast<float>(std::clamp(-p.low / (p.high - p.low), 0.0, 1.0));
  chart.range = fmt::format("{:g} to {:g}", p.low, p.high);
  chart.length = fmt::format("{:.4g} s", (chart.width - 1) * frameSeconds_);
  for (std::size_t i = 0; i < p.curves.size(); ++i) {
    chart.names.emplace_back(nameOf(p.curves[i].of));
    chart.colors.push_back(p.curves[i].color.value_or(colors[i]));
  }
  drawables.charts.push_back(std::move(chart));
}

}  // namespace simreel::sim
