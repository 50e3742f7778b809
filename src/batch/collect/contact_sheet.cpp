#include "batch/collect/contact_sheet.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "draw/overlay/text_boxes.hpp"
#include "golden/files/picture.hpp"
#include "golden/report/thumbnail.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <tbb/parallel_for.h>

namespace simreel::batch {

namespace {

using Color = std::array<std::uint8_t, 4>;
constexpr Color paper{24, 24, 27, 255}, ink{235, 235, 235, 255}, nothing{60, 60, 66, 255},
    bad{255, 120, 100, 255};
constexpr int maxSide = 8192;  ///< pixels along a side
constexpr int gap = 6, lineHeight = 13;

void fill(frame::Image& image, int left, int top, int right, int bottom, const Color& color) {
  for (int y = std::max(0, top); y < std::min(bottom, image.height); ++y)
    for (int x = std::max(0, left); x < std::min(right, image.width); ++x)
      std::copy(color.begin(), color.end(),
                image.bytes.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + x));
}

/// As much of it as fits.
void write(frame::Image& image, std::string text, int left, int top, int width, const Color& color) {
  if (draw::textSize(text, 1).x > width) {
    while (text.size() > 1 && draw::textSize(text + "..", 1).x > width) text.pop_back();
    text += "..";
  }
  for (const glm::vec4& box : draw::textBoxes(text, {left, top}, 1))
    fill(image, static_cast<int>(box.x), static_cast<int>(box.y), static_cast<int>(box.z),
         static_cast<int>(box.w), color);
}

void paste(frame::Image& image, const frame::Image& small, int left, int top) {
  for (int y = 0; y < small.height; ++y)
    std::copy_n(small.bytes.begin() + 4 * static_cast<std::ptrdiff_t>(y) * small.width, 4 * small.width,
                image.bytes.begin() + 4 * (static_cast<std::ptrdiff_t>(top + y) * image.width + left));
}

/// Values of the last parameter, where every other combination has each of them.
std::size_t columnsOf(const SweepPlan& plan) {
  const std::size_t count = plan.jobs.size();
  std::set<std::string> last;
  for (const PlannedJob& job : plan.jobs) last.insert(job.values.back().value);
  bool grid = plan.varied.size() > 1 && count % last.size() == 0;
  for (std::size_t i = 0; grid && i < count; ++i)
    grid = plan.jobs[i].values.back().value == plan.jobs[i % last.size()].values.back().value;
  if (grid && last.size() <= 64) return last.size();
  return static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
}

std::vector<std::string> labelLines(const CollectedSweep& sweep, std::size_t job) {
  const std::vector<std::string> names = shortNames(sweep.plan.varied);
  std::vector<std::string> lines;
  for (std::size_t v = 0; v < names.size(); ++v)
    lines.push_back(names[v] + "=" + sweep.plan.jobs[job].values[v].value);
  return lines;
}

}  // namespace

frame::Image contactSheet(const CollectedSweep& sweep, std::optional<int> frame) {
  const auto count = static_cast<int>(sweep.jobs.size());
  const auto columns = static_cast<int>(columnsOf(sweep.plan));
  const int rows = (count + columns - 1) / columns;
  const auto lines = static_cast<int>(sweep.plan.varied.size());
  const int side =
      std::clamp(std::min(maxSide / columns, maxSide / rows) - gap - lines * lineHeight, 24, 320);
  std::vector<frame::Image> small(sweep.jobs.size());
  tbb::parallel_for(std::size_t{0}, small.size(), [&](std::size_t i) {
    const auto file = sweep.pictureOf(i, frame);
    if (file.empty() || !pathExists(file)) return;
    try {
      small[i] = golden::thumbnail(golden::readPicture(file, "picture").image, side);
    } catch (const UserError&) {  // NOLINT(bugprone-empty-catch): it is grey then.
    }
  });
  int width = 24, height = 24;
  for (const frame::Image& image : small) {
    width = std::max(width, image.width);
    height = std::max(height, image.height);
  }
  if (width == 24) width = side;
  const int cellHeight = lines * lineHeight + height + gap;
  frame::Image sheet{columns * (width + gap) + gap, rows * cellHeight + gap, {}};
  if (static_cast<long>(sheet.width) * sheet.height > static_cast<long>(maxSide) * maxSide)
    fail(ExitCode::device,
         "a contact sheet of {} jobs would have {}x{} pixels; the page (index.html) has "
         "them all",
         count, sheet.width, sheet.height);
  sheet.bytes.resize(4 * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height));
  fill(sheet, 0, 0, sheet.width, sheet.height, paper);
  for (int i = 0; i < count; ++i) {
    const auto job = static_cast<std::size_t>(i);
    const int left = gap + i % columns * (width + gap);
    int top = gap + i / columns * cellHeight;
    const JobStatus& status = sweep.jobs[job];
    const bool failed =
        status.state == JobState::failed || (status.result && !status.result->checksPassed());
    for (const std::string& line : labelLines(sweep, job)) {
      write(sheet, line, left, top, width, failed ? bad : ink);
      top += lineHeight;
    }
    if (!small[job].bytes.empty()) {
      paste(sheet, small[job], left, top);
    } else {
      fill(sheet, left, top, left + width, top + height, nothing);
      write(sheet, stateName(status.state), left + 4, top + 4, width - 8, ink);
    }
  }
  return sheet;
}

}  // namespace simreel::batch
