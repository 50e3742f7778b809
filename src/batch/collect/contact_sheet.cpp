#include "batch/collect/contact_sheet.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "batch/sweep/sweep_run.hpp"
#include "draw/overlay/text_boxes.hpp"
#include "golden/files/picture.hpp"
#include "golden/report/thumbnail.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <tbb/parallel_for.h>

namespace simreel::batch {

namespace {

using Color = std::array<std::uint8_t, 4>;
constexpr Color paper{24, 24, 27, 255}, ink{235, 235, 235, 255}, nothing{60, 60, 66, 255},
    bad{255, 120, 100, 255};
constexpr int maxSide = 8192;  ///< max width and height of the sheet in pixels
constexpr int gap = 12, border = 2;

void fill(frame::Image& image, int left, int top, int right, int bottom, const Color& color) {
  for (int y = std::max(0, top); y < std::min(bottom, image.height); ++y)
    for (int x = std::max(0, left); x < std::min(right, image.width); ++x)
      std::copy(color.begin(), color.end(),
                image.bytes.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + x));
}

/// Draws the text. Text wider than `width` pixels is shortened and ends with "..".
void write(frame::Image& image, std::string text, int left, int top, int width, int scale,
           const Color& color) {
  const auto widthOf = [scale](const std::string& part) { return draw::textSize(part, scale).x; };
  if (widthOf(text) > width) {
    while (text.size() > 1 && widthOf(text + "..") > width) text.pop_back();
    text += "..";
  }
  for (const glm::vec4& box : draw::textBoxes(text, {left, top}, scale))
    fill(image, static_cast<int>(box.x), static_cast<int>(box.y), static_cast<int>(box.z),
         static_cast<int>(box.w), color);
}

void paste(frame::Image& image, const frame::Image& small, int left, int top) {
  for (int y = 0; y < small.height; ++y)
    std::copy_n(small.bytes.begin() + 4 * static_cast<std::ptrdiff_t>(y) * small.width, 4 * small.width,
                image.bytes.begin() + 4 * (static_cast<std::ptrdiff_t>(top + y) * image.width + left));
}

/// Returns the number of values of the last parameter if the jobs form a full grid in which that parameter
/// varies fastest. Otherwise returns 0.
std::size_t gridColumns(const SweepPlan& plan) {
  const auto& jobs = plan.jobs;
  std::set<std::string> last;
  for (const PlannedJob& job : jobs) last.insert(job.values.back().value);
  const std::size_t columns = last.size();
  if (plan.varied.size() < 2 || columns < 2 || columns > 64 || jobs.size() % columns != 0) return 0;
  for (std::size_t i = 0; i < jobs.size(); ++i)
    for (std::size_t v = 0; v < plan.varied.size(); ++v) {
      const std::size_t like = v + 1 == plan.varied.size() ? i % columns : i - i % columns;
      if (jobs[i].values[v].value != jobs[like].values[v].value) return 0;
    }
  return columns;
}

/// Computes the layout of a sheet in pixels and draws it.
class Sheet {
 public:
  explicit Sheet(const CollectedSweep& sweep, std::optional<int> number)
      : sweep_(sweep), names_(shortNames(sweep.plan.varied)), small_(sweep.jobs.size()) {
    const auto count = static_cast<int>(sweep.jobs.size());
    grid_ = static_cast<int>(gridColumns(sweep.plan));
    columns_ = grid_ > 0 ? grid_ : static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
    rows_ = (count + columns_ - 1) / columns_;
    const auto lines = static_cast<int>(names_.size());
    const int side = std::clamp(std::min(maxSide / columns_, maxSide / rows_) - gap - lines * 13, 24, 320);
    readPictures(number, side);
    scale_ = width_ >= 160 ? 2 : 1;
    line_ = 13 * scale_;
    above_ = grid_ > 0 ? 0 : lines * line_;
    left_ = gap + (grid_ > 0 ? rowHeadWidth() + gap : 0);
    top_ = gap + line_ + gap + (grid_ > 0 ? line_ : 0);
  }

  frame::Image draw() {
    image_ = {left_ + columns_ * (width_ + gap), top_ + rows_ * (above_ + height_ + gap), {}};
    if (static_cast<long>(image_.width) * image_.height > static_cast<long>(maxSide) * maxSide)
      fail(ExitCode::device,
           "a contact sheet of {} jobs would have {}x{} pixels, which is too large; the page (index.html) "
           "shows all jobs",
           small_.size(), image_.width, image_.height);
    image_.bytes.resize(4 * static_cast<std::size_t>(image_.width) *
                        static_cast<std::size_t>(image_.height));
    fill(image_, 0, 0, image_.width, image_.height, paper);
    SweepTally tally;
    for (const JobStatus& job : sweep_.jobs) tally.add(job);
    write(image_, tally.text(), gap, gap, image_.width - 2 * gap, scale_, ink);
    if (grid_ > 0) drawHeads();
    for (std::size_t job = 0; job < small_.size(); ++job) drawJob(job);
    return std::move(image_);
  }

 private:
  void readPictures(std::optional<int> number, int side) {
    tbb::parallel_for(std::size_t{0}, small_.size(), [&](std::size_t i) {
      const auto file = sweep_.pictureOf(i, number);
      if (file.empty() || !pathExists(file)) return;
      try {
        small_[i] = golden::thumbnail(golden::readPicture(file, "picture").image, side);
      } catch (const UserError&) {  // NOLINT(bugprone-empty-catch): the job is drawn grey.
      }
    });
    for (const frame::Image& image : small_) {
      width_ = std::max(width_, image.width);
      height_ = std::max(height_, image.height);
    }
    if (width_ == 24) width_ = side;
  }

  [[nodiscard]] std::string label(std::size_t job, std::size_t parameter) const {
    return names_[parameter] + "=" + sweep_.plan.jobs[job].values[parameter].value;
  }

  [[nodiscard]] int rowHeadWidth() const {
    int width = 0;
    for (std::size_t job = 0; job < small_.size(); job += static_cast<std::size_t>(columns_))
      for (std::size_t v = 0; v + 1 < names_.size(); ++v)
        width = std::max(width, static_cast<int>(draw::textSize(label(job, v), scale_).x));
    return std::min(width, 400);
  }

  [[nodiscard]] int cellLeft(int column) const { return left_ + column * (width_ + gap); }
  [[nodiscard]] int cellTop(int row) const { return top_ + row * (above_ + height_ + gap); }

  void drawHeads() {
    for (int column = 0; column < columns_; ++column)
      write(image_, label(static_cast<std::size_t>(column), names_.size() - 1), cellLeft(column),
            top_ - line_, width_, scale_, ink);
    for (int row = 0; row < rows_; ++row)
      for (std::size_t v = 0; v + 1 < names_.size(); ++v)
        write(image_, label(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_), v), gap,
              cellTop(row) + static_cast<int>(v) * line_, left_ - 2 * gap, scale_, ink);
  }

  void drawJob(std::size_t job) {
    const int left = cellLeft(static_cast<int>(job) % columns_);
    int top = cellTop(static_cast<int>(job) / columns_);
    const JobStatus& status = sweep_.jobs[job];
    const bool failed =
        status.state == JobState::failed || (status.result && !status.result->checksPassed());
    for (std::size_t v = 0; grid_ == 0 && v < names_.size(); ++v) {
      write(image_, label(job, v), left, top, width_, scale_, failed ? bad : ink);
      top += line_;
    }
    const frame::Image& small = small_[job];
    const bool drawn = !small.bytes.empty();
    const int right = left + (drawn ? small.width : width_),
              bottom = top + (drawn ? small.height : height_);
    if (failed) fill(image_, left - border, top - border, right + border, bottom + border, bad);
    if (drawn) return paste(image_, small, left, top);
    fill(image_, left, top, right, bottom, nothing);
    write(image_, stateName(status.state), left + 4, top + 4, width_ - 8, scale_, ink);
  }

  const CollectedSweep& sweep_;
  std::vector<std::string> names_;
  std::vector<frame::Image> small_;
  int grid_ = 0;  ///< number of columns of a grid, which have headings; 0 if each job has a label instead
  int columns_ = 1, rows_ = 1;
  int width_ = 24, height_ = 24;  ///< size of the largest reduced picture in pixels
  int scale_ = 1, line_ = 13;     ///< scale factor of the letters, and height of a line in pixels
  int above_ = 0;                 ///< height in pixels of the label above a picture
  int left_ = 0, top_ = 0;        ///< position of the first cell in pixels
  frame::Image image_;
};

}  // namespace

frame::Image contactSheet(const CollectedSweep& sweep, std::optional<int> frame) {
  return Sheet(sweep, frame).draw();
}

}  // namespace simreel::batch
