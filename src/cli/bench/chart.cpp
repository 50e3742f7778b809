#include "cli/bench/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

namespace simreel::cli {

namespace {

constexpr double width = 960, top = 76, rightColumn = 190, barHeight = 20;
constexpr const char* restColor = "#e4e4e1";

/// Escapes text for XML and removes control characters, which XML does not allow.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (static_cast<unsigned char>(c) < 0x20)
      out += ' ';
    else
      out += c;
  }
  return out;
}

struct Color {
  int r, g, b;
  [[nodiscard]] std::string text(double white) const {
    const auto mixed = [white](int c) { return static_cast<int>(std::lround(c + (255 - c) * white)); };
    return fmt::format("#{:02x}{:02x}{:02x}", mixed(r), mixed(g), mixed(b));
  }
};

/// Returns the colour of a stage. Named stages have the same colour in every chart. The steps of objects
/// cycle through blues and greens. `number`: index of the step.
Color colorOf(const std::string& stage, int number) {
  struct Named {
    const char* name;
    Color color;
  };
  constexpr std::array<Named, 8> named = {{{"shadow", {90, 84, 140}},
                                           {"surfaces", {224, 140, 30}},
                                           {"instances", {200, 82, 40}},
                                           {"ground", {150, 118, 80}},
                                           {"bloom", {232, 200, 70}},
                                           {"tone map", {190, 110, 155}},
                                           {"readback", {125, 130, 138}},
                                           {"state hash", {178, 186, 196}}}};
  for (const Named& one : named)
    if (stage == one.name) return one.color;
  constexpr std::array<Color, 4> steps = {{{24, 104, 174}, {22, 150, 120}, {70, 165, 215}, {120, 170, 70}}};
  return steps[static_cast<std::size_t>(number) % steps.size()];
}

/// One coloured segment of a bar. It stands for a whole stage if `part` is empty, and otherwise for one
/// part of the stage.
struct Key {
  std::string stage, part, color;
  [[nodiscard]] std::string label() const { return part.empty() ? stage : stage + ": " + part; }
};

/// Returns the entries of the legend. These are all shown stages, each followed by its parts.
std::vector<Key> keysOf(const std::vector<RowFigures>& rows) {
  std::vector<Key> keys;
  int number = 0;
  for (const std::string& name : shownStages(rows)) {
    const Color color = colorOf(name, number++);
    keys.push_back({name, "", color.text(0)});
    int parts = 0;
    for (const RowFigures& row : rows)
      for (const StageFigures& stage : row.stages)
        for (const auto& part : stage.parts) {
          const auto same = [&](const Key& key) { return key.stage == name && key.part == part.first; };
          if (stage.name == name && std::none_of(keys.begin(), keys.end(), same))
            keys.push_back({name, part.first, color.text(std::min(0.2 + 0.2 * parts++, 0.7))});
        }
  }
  return keys;
}

/// Returns the length of a segment in ms. If a stage has parts, its own segment gets the time that the
/// parts do not account for. `side`: member that holds the CPU or the GPU time.
double lengthOf(const RowFigures& row, const Key& key, double StageFigures::*side) {
  for (const StageFigures& stage : row.stages) {
    if (stage.name != key.stage) continue;
    const bool split = stage.*side >= std::max(stage.cpu, stage.gpu);
    double parts = 0;
    for (const auto& [name, value] : stage.parts) {
      if (!key.part.empty() && split && name == key.part) return std::min(value, stage.*side);
      parts += value;
    }
    if (key.part.empty()) return split ? std::max(stage.*side - parts, 0.0) : stage.*side;
  }
  return 0;
}

/// Returns the distance of the axis ticks: 1, 2 or 5 times a power of ten, for about six ticks up to `max`.
double tickStep(double max) {
  const double rough = std::max(max, 1e-6) / 6;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough) return factor * power;
  return 10 * power;
}

class Chart {
 public:
  explicit Chart(const BenchReport& report) : report_(report) {
    std::size_t longest = 4;
    for (const BenchRow& row : report.rows) {
      rows_.push_back(figuresOf(row.times, report.timing));
      longest = std::max(longest, row.asked.name.size());
      max_ = std::max({max_, rows_.back().frame.p95, rows_.back().cpu, rows_.back().gpu});
    }
    keys_ = keysOf(rows_);
    twoBars_ = report.timing == frame::Timing::query;
    left_ = std::clamp(28 + 8.4 * static_cast<double>(longest), 90.0, 300.0) + (twoBars_ ? 34 : 0);
    rowHeight_ = twoBars_ ? 2 * barHeight + 24 : barHeight + 26;
    bottom_ = top + rowHeight_ * static_cast<double>(rows_.size());
  }

  std::string draw() {
    title();
    axis();
    for (std::size_t i = 0; i < rows_.size(); ++i) row(i);
    const double height = legend() + 18;
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
               "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" "
               "font-size=\"12\" fill=\"#26282b\">\n"
               "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
               width, height) +
           out_ + "</svg>\n";
  }

 private:
  [[nodiscard]] double x(double ms) const { return left_ + (width - rightColumn - left_) * ms / max_; }

  void text(double atX, double atY, const std::string& words, const char* more = "") {
    out_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", atX, atY, more, escaped(words));
  }
  void line(double x1, double y1, double x2, double y2, const char* style) {
    out_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x1, y1, x2,
                        y2, style);
  }
  void box(double atX, double atY, double wide, double high, const std::string& color,
           const std::string& hint) {
    out_ += fmt::format(
        "<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\" "
        "fill=\"{}\"><title>{}</title></rect>\n",
        atX, atY, wide, high, color, escaped(hint));
  }

  void title() {
    const auto& size = report_.rows.front().size;
    const bool oneSize = std::all_of(report_.rows.begin(), report_.rows.end(),
                                     [&](const BenchRow& row) { return row.size == size; });
    text(24, 30, "Time of a frame: " + std::filesystem::path(report_.scene).filename().string(),
         "font-size=\"18\" font-weight=\"bold\"");
    text(24, 52,
         fmt::format("{}{} frames each in {} round{}; median, whiskers from 5th to 95th percentile; {}",
                     oneSize ? fmt::format("{}x{}; ", size.x, size.y) : "", report_.frames, report_.rounds,
                     report_.rounds == 1 ? "" : "s", report_.device),
         "fill=\"#63676d\"");
  }

  void axis() {
    const double step = tickStep(max_);
    for (int i = 0; i * step <= max_ * 1.0001; ++i) {
      line(x(i * step), top - 6, x(i * step), bottom_, "stroke=\"#d5d7da\"");
      text(x(i * step), bottom_ + 16, fmt::format("{:.6g}", i * step),
           "text-anchor=\"middle\" fill=\"#63676d\"");
    }
    text(width - rightColumn + 14, bottom_ + 16, "ms", "fill=\"#63676d\"");
  }

  void bar(const RowFigures& row, double y, double StageFigures::*side) {
    double from = 0;
    for (const Key& key : keys_) {
      const double length = lengthOf(row, key, side);
      if (length <= 0) continue;
      box(x(from), y, x(from + length) - x(from), barHeight, key.color,
          fmt::format("{}: {:.3f} ms", key.label(), length));
      from += length;
    }
    if (from < row.frame.median)
      box(x(from), y, x(row.frame.median) - x(from), barHeight, restColor,
          fmt::format("rest: {:.3f} ms", row.frame.median - from));
  }

  void row(std::size_t i) {
    const RowFigures& figures = rows_[i];
    const double y = top + rowHeight_ * static_cast<double>(i) + 6;
    const double high = twoBars_ ? 2 * barHeight + 2 : barHeight;
    text(left_ - (twoBars_ ? 46 : 10), y + high / 2 + 4, report_.rows[i].asked.name,
         "text-anchor=\"end\" font-weight=\"bold\"");
    const double column = width - rightColumn + 14;
    if (figures.frame.count == 0) return text(column, y + high / 2 + 4, "not measured");
    if (twoBars_) {
      text(left_ - 8, y + 15, "GPU", "text-anchor=\"end\" fill=\"#63676d\"");
      text(left_ - 8, y + barHeight + 17, "CPU", "text-anchor=\"end\" fill=\"#63676d\"");
      bar(figures, y, &StageFigures::gpu);
      bar(figures, y + barHeight + 2, &StageFigures::cpu);
    } else {
      bar(figures, y, &StageFigures::cpu);
    }
    constexpr const char* ink = "stroke=\"#26282b\" stroke-width=\"1.4\"";
    const double middle = y + high / 2;
    line(x(figures.frame.p5), middle, x(figures.frame.p95), middle, ink);
    for (const double end : {figures.frame.p5, figures.frame.p95})
      line(x(end), middle - 5, x(end), middle + 5, ink);
    line(x(figures.frame.median), y - 2, x(figures.frame.median), y + high + 2, ink);
    text(column, middle - 3,
         fmt::format("{:.{}f} ms, {:.1f} frames/s", figures.frame.median, figures.frame.median < 10 ? 3 : 1,
                     figures.perSecond));
    text(column, middle + 12, figures.bound, "fill=\"#63676d\" font-size=\"11\"");
  }

  /// Draws the legend and returns the y position of its end.
  double legend() {
    double atX = 24;
    double y = bottom_ + 44;
    const auto add = [&](const std::string& label, const std::string& color) {
      const double wide = 34 + 7.4 * static_cast<double>(label.size());
      if (atX + wide > width - 24) {
        atX = 24;
        y += 22;
      }
      box(atX, y - 10, 12, 12, color, label);
      text(atX + 18, y, label);
      atX += wide;
    };
    for (const Key& key : keys_) add(key.label(), key.color);
    add(twoBars_ ? "rest: waiting" : keys_.empty() ? "frame" : "rest", restColor);
    return y;
  }

  const BenchReport& report_;
  std::vector<RowFigures> rows_;
  std::vector<Key> keys_;
  std::string out_;
  double max_ = 1e-6, left_ = 0, rowHeight_ = 0, bottom_ = 0;
  bool twoBars_ = false;
};

}  // namespace

std::string benchChart(const BenchReport& report) {
  return Chart(report).draw();
}

}  // namespace simreel::cli
