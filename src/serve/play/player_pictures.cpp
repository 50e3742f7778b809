#include "golden/compare/difference_image.hpp"
#include "serve/play/jpeg.hpp"
#include "serve/play/player.hpp"

#include <algorithm>
#include <utility>

namespace simreel::serve {

namespace {

constexpr double maxMilliseconds = 85;  ///< time limit of a picture during motion, in milliseconds
constexpr double maxToMeasure = 6;      ///< time limit in milliseconds for measuring quantities while
                                        ///< something moves
constexpr int jpegQuality = 87;

std::string encoded(const frame::Image& image, bool draft) {
  if (draft) return encodeJpeg(image, jpegQuality);
  const auto png = frame::encodePng(image, {});
  return {reinterpret_cast<const char*>(png.data()), png.size()};
}

}  // namespace

void Player::drawPicture(bool draft) {
  const std::size_t level = draft ? level_ : 0;
  Drawn drawn;
  drawn.number = ++pictures_;
  drawn.draft = draft;
  drawn.image = stage_->draw(level);
  if (other_.stage() != nullptr) drawn.other = other_.stage()->draw(level);
  const auto begun = Clock::now();
  drawn.files.push_back(encoded(drawn.image, draft));
  if (drawn.other) {
    drawn.files.push_back(encoded(*drawn.other, draft));
    if (!draft && drawn.image.width == drawn.other->width && drawn.image.height == drawn.other->height) {
      drawn.different = differingPixels(drawn.image, *drawn.other);
      if (difference_)
        drawn.files.push_back(encoded(golden::differenceImage(drawn.image, *drawn.other), false));
    }
  }
  encodeMs_ = 1000 * secondsSince(begun);
  if (draft) adaptDetail(took().draw + took().readBack + encodeMs_);
  if (!draft || measureMs_ < maxToMeasure) {
    const auto before = Clock::now();
    stage_->measure();
    if (other_.stage() != nullptr) other_.stage()->measure();
    measureMs_ = 1000 * secondsSince(before);
  }
  times_.push_back(Clock::now());
  while (times_.size() > 20) times_.pop_front();
  // The wait restarts, because the user sees the picture and can react only now.
  if (draft && !playing_ && restSeconds_ > 0) moved_ = Clock::now();
  pictureUpToDate_ = true;
  fullPictureShown_ = !draft;
  Picture picture;
  picture.number = drawn.number;
  picture.message = describe(drawn) + "\n";
  for (const std::string& file : drawn.files) picture.message += file;
  hub_.publish(std::move(picture));
  sendStatus();
  if (!draft || secondsSince(statusSentAt_) > 0.25) sendSeries();
  compareWithBaseline();
}

/// Compares the full picture with its baseline.
void Player::compareWithBaseline() {
  if (beside_.right() && other_.stage() == nullptr) beside_.choose(options_.source, false);
  if (fullPictureShown_ && stage_ != nullptr && isAtTarget() && !compared().carried() &&
      !compared().origin())
    beside_.look(compared());
}

/// Returns the side whose baseline is shown.
Stage& Player::compared() {
  return beside_.right() && other_.stage() != nullptr ? *other_.stage() : *stage_;
}

/// Chooses the finest detail level whose pictures stay within the time limit. If no level stays within it,
/// chooses the finest level that costs little more than the cheapest level. A coarser level would gain
/// little, because fixed costs do not shrink with the number of pixels.
void Player::adaptDetail(double milliseconds) {
  if (fresh_ != level_) {
    fresh_ = level_;
    return;
  }
  constexpr double newest = 0.4, hardlyMore = 1.25, sure = 0.8, minForPicture = 20;
  double& known = costs_[level_];
  known = known > 0 ? (1 - newest) * known + newest * milliseconds : milliseconds;
  const double simulated = playing_ || isCarried() ? took().simulate : 0;
  const double budget = std::max(minForPicture, maxMilliseconds - simulated);
  const auto pixels = [&](std::size_t level) {
    const DetailLevel& detail = detailLevels[level];
    const int samples = detail.samples > 0 ? detail.samples : stage_->script().scene.render.samples;
    return static_cast<double>(detail.scale * detail.scale * static_cast<float>(samples));
  };
  const auto cost = [&](std::size_t level) {
    return costs_[level] > 0 ? costs_[level] : costs_[level_] * pixels(level) / pixels(level_);
  };
  double minimum = cost(0);
  for (std::size_t level = 1; level < detailLevels.size(); ++level)
    minimum = std::min(minimum, cost(level));
  const double maximum = std::max(budget, hardlyMore * minimum);
  std::size_t best = level_;
  for (std::size_t level = detailLevels.size(); level-- > 0;)
    if (cost(level) <= (level < level_ ? sure : 1.0) * maximum) best = level;
  // The level changes by one at a time, because the costs of untried levels are estimates.
  if (best > level_) ++level_;
  quick_ = best < level_ ? quick_ + 1 : 0;
  constexpr int picturesToBelieve = 5;
  if (quick_ < picturesToBelieve) return;
  quick_ = 0;
  --level_;
}

}  // namespace simreel::serve
