#include "sim/flow/file.hpp"

#include "base/error.hpp"
#include "sim/kernels/table.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::sim {

namespace {

constexpr int sideLimit = 4096;

[[noreturn]] void broken(const std::string& name, const std::string& why) {
  fail(ExitCode::usage, "{}: {}", name, why);
}

void checkSize(const std::string& name, glm::ivec2 size) {
  if (size.x < 2 || size.y < 2 || size.x > sideLimit || size.y > sideLimit)
    broken(name, fmt::format("a grid of {} x {} velocities; a flow needs 2 to {} on each side", size.x,
                             size.y, sideLimit));
}

/// Evenly spaced coordinates of the grid lines along one axis.
struct Lines {
  double first = 0, spacing = 1;
  int count = 0;

  /// Returns the index of the grid line at the coordinate `place`, or -1 if none exists. `place` must not
  /// lie outside the grid, because the index is not checked against `count`.
  [[nodiscard]] int at(double place) const {
    const double index = std::round((place - first) / spacing);
    constexpr double slack = 0.02;
    return std::abs(first + index * spacing - place) <= slack * spacing ? static_cast<int>(index) : -1;
  }
};

/// Returns evenly spaced grid lines through the coordinates `places`. Throws UserError if they are not
/// evenly spaced.
Lines linesOf(std::vector<double> places, const char* axis, const std::string& name) {
  std::sort(places.begin(), places.end());
  const double span = places.back() - places.front();
  constexpr double same = 1e-6;  // tolerance for equal coordinates, as a fraction of the span
  places.erase(
      std::unique(places.begin(), places.end(), [&](double a, double b) { return b - a <= same * span; }),
      places.end());
  Lines lines{places.front(), 1, static_cast<int>(places.size())};
  if (places.size() < 2)
    broken(name, fmt::format("all points have the same {}; a flow needs a grid of points", axis));
  lines.spacing = span / (lines.count - 1);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (lines.at(places[i]) != static_cast<int>(i))
      broken(name,
             fmt::format("the points are no regular grid: the values of {} are not evenly spaced at {:g}",
                         axis, places[i]));
  return lines;
}

FlowGrid gridOfPoints(const KernelTable& table, const std::string& name) {
  std::size_t columns[4];
  constexpr const char* wanted[] = {"x", "y", "u", "v"};
  for (int i = 0; i < 4; ++i) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), wanted[i]);
    if (found == table.columns.end())
      broken(name, fmt::format("has no column \"{}\"; a flow needs x, y, u and v, and there are {}",
                               wanted[i], fmt::join(table.columns, ", ")));
    columns[i] = static_cast<std::size_t>(found - table.columns.begin());
  }
  const auto value = [&](std::size_t row, int which) {
    return table.values[row * table.columns.size() + columns[which]];
  };
  std::vector<double> xs, ys;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    xs.push_back(value(i, 0));
    ys.push_back(value(i, 1));
  }
  const Lines across = linesOf(xs, "x", name), along = linesOf(ys, "y", name);
  FlowGrid grid{{across.count, along.count}, static_cast<float>(across.spacing), {}};
  checkSize(name, grid.size);
  if (std::abs(across.spacing - along.spacing) > 0.01 * across.spacing)
    broken(name, fmt::format("points are {:g} apart in x and {:g} in y; a flow needs square cells",
                             across.spacing, along.spacing));
  const std::size_t cells = static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y);
  std::vector<bool> filled(cells);
  grid.values.resize(cells);
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto x = static_cast<std::size_t>(across.at(xs[i]));
    const auto row = static_cast<std::size_t>(along.count - 1 - along.at(ys[i]));
    const std::size_t cell = row * static_cast<std::size_t>(across.count) + x;
    if (filled[cell])
      broken(name, fmt::format("the point x = {:g}, y = {:g} has two velocities", xs[i], ys[i]));
    filled[cell] = true;
    grid.values[cell] = {value(i, 2), -value(i, 3)};
  }
  const auto hole =
      static_cast<std::size_t>(std::find(filled.begin(), filled.end(), false) - filled.begin());
  if (hole < cells) {
    const auto perRow = static_cast<std::size_t>(across.count);
    const std::size_t column = hole % perRow;
    const std::size_t row = static_cast<std::size_t>(along.count) - 1 - hole / perRow;
    broken(name, fmt::format("the point x = {:g}, y = {:g} of the grid has no velocity; give it 0, 0",
                             across.first + across.spacing * static_cast<double>(column),
                             along.first + along.spacing * static_cast<double>(row)));
  }
  return grid;
}

}  // namespace

FlowGrid readFlow(const std::filesystem::path& file, bool up, float cell) {
  const KernelTable table = readKernelTable(file);
  const std::string name = file.filename().string();
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (ending != ".npy") return gridOfPoints(table, name);
  if (table.columns.size() != 2 || table.size.y < 2)
    broken(name, fmt::format("expected an array of shape (rows, columns, 2), found {} x {} x {}",
                             table.size.y, table.size.x, table.columns.size()));
  FlowGrid grid{table.size, cell, {}};
  checkSize(name, grid.size);
  for (int row = 0; row < grid.size.y; ++row)
    for (int x = 0; x < grid.size.x; ++x) {
      const int from = up ? grid.size.y - 1 - row : row;
      const std::size_t at = static_cast<std::size_t>(from) * static_cast<std::size_t>(grid.size.x) +
                             static_cast<std::size_t>(x);
      grid.values.emplace_back(table.values[2 * at], (up ? -1 : 1) * table.values[2 * at + 1]);
    }
  return grid;
}

}  // namespace simreel::sim
