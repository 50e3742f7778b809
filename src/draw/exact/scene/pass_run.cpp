#include "draw/exact/scene/pass_run.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace simreel::draw {

PassRun::PassRun(ExactFrame& frame) : frame_(frame) {
  for (const PassEntry& entry : exactPasses) passes_.push_back(entry.make(frame));
}

void PassRun::asked() {
  for (const auto& pass : passes_) pass->asked();
}

/// Draws max(moments, lens points) views, so that each moment and each lens point has at least one view.
/// The lens points of one moment are spread evenly over the lens.
void PassRun::draw(const ExactScene::StageCallback& watch) {
  ExactFrame& f = frame_;
  watch_ = &watch;
  const ExactScene::Exposure& exposure = *f.asked.exposure;
  const int points = f.scene.camera.lens ? f.scene.camera.lens->samples : 1;
  f.views = std::max(exposure.moments, points);
  f.number = 0;
  f.shines = false;
  const Range before{0, endOf(0, Each::picture)};
  const Range moment{before.second, endOf(before.second, Each::moment)};
  std::size_t viewEnd = moment.second;
  while (viewEnd < passes_.size() && exactPasses[viewEnd].each != Each::picture) ++viewEnd;
  runOnce(before);
  for (int m = 0; m < exposure.moments; ++m) {
    f.moment = exposure.at(m);
    runOnce(moment);
    const std::vector<LensPoint> opening = lensPoints(f.scene.camera, f.seen, f.moment.seconds);
    for (int i = m; i < f.views; i += exposure.moments, ++f.number) {
      f.point = opening[static_cast<std::size_t>(i % points)];
      runView({moment.second, viewEnd});
    }
  }
  if (exposure.close) exposure.close();
  runOnce({viewEnd, passes_.size()});
}

std::size_t PassRun::endOf(std::size_t first, Each each) const {
  while (first < passes_.size() && exactPasses[first].each == each) ++first;
  return first;
}

void PassRun::runOnce(Range group) {
  for (std::size_t i = group.first; i < group.second; ++i) run(i);
  endStage();
}

/// Runs consecutive band passes together, band by band, up to the next pass that needs the whole view.
void PassRun::runView(Range group) {
  for (std::size_t i = group.first; i < group.second;) {
    if (exactPasses[i].each == Each::view || !passes_[i]->on()) {
      run(i++);
      continue;
    }
    std::size_t end = i;
    while (end < group.second && (exactPasses[end].each == Each::band || !passes_[end]->on())) ++end;
    runBands({i, end}, group.first);
    i = end;
  }
  endStage();
}

void PassRun::runBands(Range group, std::size_t firstOfView) {
  ExactFrame& f = frame_;
  std::vector<std::size_t> lost;
  if (f.bandRows < f.size.y) lost = lostBefore(group, firstOfView);
  for (int row = 0; row < f.size.y; row += f.bandRows) {
    const glm::ivec2 rows(row, std::min(row + f.bandRows, f.size.y));
    if (rows != std::exchange(f.values.rows, rows)) f.tellView();
    for (const std::size_t pass : lost) run(pass, true);
    for (std::size_t i = group.first; i < group.second; ++i) run(i);
  }
}

/// Returns the earlier passes that must run again because the group reads band resources that now hold
/// another band.
std::vector<std::size_t> PassRun::lostBefore(Range group, std::size_t firstOfView) const {
  std::vector<std::string_view> needed;
  const auto need = [&](std::size_t pass) {
    for (const std::string_view name : exactPasses[pass].reads)
      if (ofBands.has(name)) needed.push_back(name);
  };
  for (std::size_t i = group.first; i < group.second; ++i)
    if (passes_[i]->on()) need(i);
  std::vector<std::size_t> lost;
  for (std::size_t i = group.first; i-- > firstOfView;) {
    const Names& writes = exactPasses[i].writes;
    if (exactPasses[i].each != Each::band || !passes_[i]->on() ||
        std::none_of(needed.begin(), needed.end(), [&](std::string_view name) { return writes.has(name); }))
      continue;
    lost.insert(lost.begin(), i);
    need(i);
  }
  return lost;
}

void PassRun::run(std::size_t pass, bool restoreBand) {
  if (!passes_[pass]->on()) return;
  const char* const stage = exactPasses[pass].stage;
  if (stage_ != nullptr && (stage == nullptr || std::string_view(stage) != stage_)) endStage();
  if (stage != nullptr) stage_ = stage;
  if (restoreBand)
    passes_[pass]->restoreBand();
  else
    passes_[pass]->run();
}

void PassRun::endStage() {
  if (stage_ != nullptr && *watch_) (*watch_)(stage_);
  stage_ = nullptr;
}

}  // namespace simreel::draw
