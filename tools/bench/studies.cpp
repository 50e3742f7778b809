// Checks that cloth behaves the same at every resolution: figures must not change on finer grids, and
// energy must be conserved.
//
//   bench_studies resolution [SECONDS]   flag.json with 48, 96 and 192 columns: folds, stretch
//   bench_studies energy [SECONDS]       swings without damping: drift, and rise of the mean
//
// The exit code is 1 if a figure misses the required value.
#include "beside/subject.hpp"
#include "gl/context.hpp"
#include "reference/swing.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

using namespace simreel;

namespace {

constexpr double degrees = 57.29577951308232;
constexpr double flagWidth = 95 * 0.0215, flagHeight = 63 * 0.0215;  // size in metres of the cloth in
                                                                     // flag.json
constexpr int coarsest = 48;

/// A mean over time and its standard error. The error is estimated from the scatter of the means of single
/// seconds.
class Mean {
 public:
  void add(double squared, int frame) {
    const auto second = static_cast<std::size_t>(frame / 60);
    seconds_.resize(std::max(seconds_.size(), second + 1));
    seconds_[second] += squared / 60;
  }
  [[nodiscard]] double rms() const { return std::sqrt(mean()); }
  /// Returns the standard error of rms().
  [[nodiscard]] double error() const {
    double sum = 0;
    for (const double s : seconds_) sum += (s - mean()) * (s - mean());
    const auto n = static_cast<double>(seconds_.size());
    return std::sqrt(sum / n / std::max(n - 1, 1.0)) / (2 * rms());
  }

 private:
  [[nodiscard]] double mean() const {
    double sum = 0;
    for (const double s : seconds_) sum += s;
    return sum / static_cast<double>(seconds_.size());
  }
  std::vector<double> seconds_;
};

/// Results for a flag. alongEdge and toEdge are root mean square angles in degrees between adjacent chords:
/// along the fly edge, and along the last tenth of each row. Index 0 is for chords as long as a link of the
/// coarsest grid, index 1 for chords twice as long.
struct Flag {
  int columns = 0, substeps = 0;
  std::array<Mean, 2> alongEdge, toEdge;
  double stretch = 0;   ///< maximum stretch over all frames
  double strained = 0;  ///< mean number of links per frame that are more than 5% longer than at rest
  double reach = 0;     ///< mean distance in metres from the pole to the fly edge, along x
  double height = 0;    ///< mean height in metres of the fly edge
  double kinetic = 0;   ///< mean kinetic energy in joules
};

/// Sum of squared angles between adjacent chords, each of which spans `pace` links of a line of particles.
struct Angles {
  double sum = 0;
  long count = 0;
  void add(const std::vector<glm::dvec3>& line, std::size_t pace) {
    for (std::size_t i = 0; i + 2 * pace < line.size(); ++i) {
      const glm::dvec3 a = line[i + pace] - line[i], b = line[i + 2 * pace] - line[i + pace];
      const double angle = degrees * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
      sum += angle * angle;
      ++count;
    }
  }
  [[nodiscard]] double mean() const { return sum / static_cast<double>(count); }
};

/// Simulates the flag with the given number of columns. Angles are measured between chords of a fixed
/// length, independent of the particle spacing. Measuring starts after 3 s.
Flag flagOf(int columns, int seconds, const std::vector<scene::Override>& more) {
  const double spacing = flagWidth / (columns - 1);
  const int rows = static_cast<int>(std::lround(flagHeight / spacing)) + 1;
  std::vector<scene::Override> overrides = {
      {"objects.flag.cloth.size", fmt::format("[{}, {}]", columns, rows)},
      {"objects.flag.cloth.spacing", fmt::format("{:.7f}", spacing)},
      {"objects.flag.cloth.jitter", fmt::format("{:.7f}", 0.093 * spacing)},
      {"time.start", "3"}};
  overrides.insert(overrides.end(), more.begin(), more.end());
  const auto scene =
      scene::loadScene(std::filesystem::path(SIMREEL_SCENES) / "flag.json", overrides, sim::kinds());
  sim::World world(scene);
  std::size_t flag = 0;
  while (world.objectName(flag) != "flag") ++flag;
  const auto pace = static_cast<std::size_t>(std::lround(static_cast<double>(columns) / coarsest));
  Flag result;
  result.columns = columns;
  result.substeps = world.object(flag).stepsPerFrame();
  const int frames = 60 * seconds;
  for (int frame = 0; frame < frames; ++frame) {
    world.advanceTo(frame);
    const auto measured = world.object(flag).measure();
    result.kinetic += measured[2] / frames;
    result.stretch = std::max(result.stretch, measured[6]);
    const auto positions = world.object(flag).state()[0].buffer->readAll<glm::vec4>();
    const auto at = [&](int x, int y) {
      return glm::dvec3(positions[static_cast<std::size_t>(y * columns + x)]);
    };
    std::array<Angles, 2> along, to;
    std::vector<glm::dvec3> line;
    for (int y = 0; y < rows; ++y) {
      line.push_back(at(columns - 1, y));
      result.height += line.back().y / rows / frames;
      result.reach += (line.back().x - at(0, y).x) / rows / frames;
    }
    for (std::size_t k = 0; k < 2; ++k) along[k].add(line, (k + 1) * pace);
    for (int y = 0; y < rows; ++y) {
      line.clear();
      for (int x = columns * 9 / 10; x < columns; ++x) line.push_back(at(x, y));
      for (std::size_t k = 0; k < 2; ++k) to[k].add(line, (k + 1) * pace);
      for (int x = 0; x + 1 < columns; ++x)
        if (glm::length(at(x + 1, y) - at(x, y)) > 1.05 * spacing) result.strained += 1.0 / frames;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      result.alongEdge[k].add(along[k].mean(), frame);
      result.toEdge[k].add(to[k].mean(), frame);
    }
  }
  return result;
}

bool resolution(int seconds, const std::vector<scene::Override>& more) {
  const double chord = 1000 * flagWidth / (coarsest - 1);
  fmt::print(
      "flag.json for {} s: angles between neighbouring chords of {:.0f} and {:.0f} mm, rms, degrees\n",
      seconds, chord, 2 * chord);
  fmt::print("{:>8} {:>9} {:>14} {:>14} {:>14} {:>14} {:>8} {:>8} {:>8} {:>9} {:>9}\n", "columns",
             "substeps", "along fly edge", "", "rows near it", "", "stretch", "over 5%", "reach m",
             "height m", "kinetic J");
  std::vector<Flag> flags;
  for (const int columns : {coarsest, 96, 192}) {
    flags.push_back(flagOf(columns, seconds, more));
    const Flag& f = flags.back();
    const auto angle = [](const Mean& m) { return fmt::format("{:.2f} +- {:.2f}", m.rms(), m.error()); };
    fmt::print("{:>8} {:>9} {:>14} {:>14} {:>14} {:>14} {:>8.4f} {:>8.2f} {:>8.3f} {:>9.3f} {:>9.3f}\n",
               f.columns, f.substeps, angle(f.alongEdge[0]), angle(f.alongEdge[1]), angle(f.toEdge[0]),
               angle(f.toEdge[1]), f.stretch, f.strained, f.reach, f.height, f.kinetic);
    std::fflush(stdout);
  }
  const auto spread = [&](std::array<Mean, 2> Flag::*angles, std::size_t chords) {
    const auto [minimum, maximum] =
        std::minmax_element(flags.begin(), flags.end(), [&](const Flag& a, const Flag& b) {
          return (a.*angles)[chords].rms() < (b.*angles)[chords].rms();
        });
    return 100 * (((*maximum).*angles)[chords].rms() / ((*minimum).*angles)[chords].rms() - 1);
  };
  fmt::print("spread: {:.1f}% and {:.1f}% along the fly edge, bar 20%; {:.1f}% and {:.1f}% in the rows\n",
             spread(&Flag::alongEdge, 0), spread(&Flag::alongEdge, 1), spread(&Flag::toEdge, 0),
             spread(&Flag::toEdge, 1));
  return spread(&Flag::alongEdge, 0) <= 20 && spread(&Flag::alongEdge, 1) <= 20;
}

/// The device simulates, so that the study may be long and use fine grids.
bool energy(int seconds) {
  fmt::print("{:<20} {:>8} {:>8} {:>9} {:>11} {:>11}   of the energy of the swing, {} s\n", "", "degrees",
             "spacing", "substeps", "drift", "rise", seconds);
  bool good = true;
  for (const double angle : {10.0, 30.0, 60.0})
    for (const double spacing : {0.1, 0.05, 0.025})
      for (const auto& given :
           {swing::springs(angle, spacing), swing::fabric(angle, spacing), swing::strip(angle, spacing)}) {
        const auto cloth = bench::onDevice("cloth", given.parameters);
        int frame = 0;
        const auto course = swing::courseOf(given, seconds, [&] {
          cloth->step(frame++ * bench::frameSeconds, {});
          return cloth->measure()[5];
        });
        const bool fine = std::abs(course.drift()) < 0.01 && course.rise < 1e-3;
        fmt::print("{:<20} {:>8} {:>8} {:>9} {:>10.3f}% {:>10.4f}%{}\n", given.name, angle, spacing,
                   cloth->stepsPerFrame(), 100 * course.drift(), 100 * course.rise, fine ? "" : "  beyond");
        std::fflush(stdout);
        good = good && fine;
      }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view study = argc > 1 ? argv[1] : "";
  const int seconds = argc > 2 ? std::atoi(argv[2]) : 0;
  std::vector<scene::Override> more;
  for (int i = 3; i < argc; ++i) more.push_back(scene::parseOverride(argv[i]));
  if ((study != "resolution" && study != "energy") || seconds < 0) {
    fmt::print(stderr, "usage: bench_studies resolution|energy [SECONDS [PATH=VALUE...]]\n");
    return 2;
  }
  const gl::Context context;
  fmt::print("device: {}\n", context.device().name);
  return (study == "energy" ? energy(seconds > 0 ? seconds : 60)
                            : resolution(seconds > 0 ? seconds : 16, more))
             ? 0
             : 1;
}
