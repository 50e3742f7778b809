#include "draw/exact/scene/share_keeper.hpp"

#include <algorithm>

namespace simreel::draw {

namespace {

constexpr unsigned groundObject = 0xfffffffeU, noObject = 0xffffffffU;  // special ids for the ground and
                                                                        // for empty samples, as in
                                                                        // tile_lists.glsl

constexpr std::uint32_t quarters = 4;  // unit in which samples are counted: 1 / quarters

}  // namespace

CoverageCounter::CoverageCounter(glm::ivec2 size, int samples, bool shifted)
    : samples_(static_cast<std::size_t>(samples)),
      shifted_(shifted),
      first_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) {
  if (shifted_) view_.assign(first_.size() * samples_, noObject);
}

std::uint32_t CoverageCounter::numbered(const std::string& name) {
  const auto found = std::find(objects_.begin(), objects_.end(), name);
  if (found != objects_.end()) return static_cast<std::uint32_t>(found - objects_.begin());
  objects_.push_back(name);
  return static_cast<std::uint32_t>(objects_.size() - 1);
}

void CoverageCounter::count(std::size_t pixel, std::uint32_t object, std::uint32_t samples) {
  Count& first = first_[pixel];
  if (first.samples == 0) first.object = object;
  if (first.object == object) {
    first.samples += samples;
    return;
  }
  std::vector<Count>& others = more_[pixel];
  const auto same =
      std::find_if(others.begin(), others.end(), [&](const Count& one) { return one.object == object; });
  if (same == others.end())
    others.push_back({object, samples});
  else
    same->samples += samples;
}

void CoverageCounter::add(std::span<const unsigned> numbers, const shader::ExactView& view,
                          std::span<const DrawnThing> things) {
  const std::size_t begin = static_cast<std::size_t>(view.rows.x) * static_cast<std::size_t>(view.size.x);
  const std::size_t held =
      static_cast<std::size_t>(view.rows.y) * static_cast<std::size_t>(view.size.x) - begin;
  numbers = numbers.first(std::min(numbers.size(), held * samples_));
  unsigned last = noObject;  // last id that was looked up; neighbouring samples mostly show the same object
  std::uint32_t object = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const unsigned number = numbers[i];
    if (number == noObject) continue;
    if (number != last) {
      const auto after =
          std::upper_bound(things.begin(), things.end(), number,
                           [](unsigned n, const DrawnThing& thing) { return n < thing.firstId; });
      if (number == groundObject)
        object = numbered("ground");
      else if (after == things.begin() || (after - 1)->object.empty())
        object = numbered("unnamed");
      else
        object = numbered((after - 1)->object);
      last = number;
    }
    if (shifted_)
      view_[begin * samples_ + i] = object;
    else
      count(begin + i / samples_, object, quarters);
  }
}

void CoverageCounter::countView(std::span<const glm::uvec4> from) {
  for (std::size_t pixel = 0; pixel < from.size(); ++pixel)
    for (int part = 0; part < static_cast<int>(quarters); ++part) {
      const auto shown = std::span(view_).subspan(from[pixel][part] * samples_, samples_);
      for (std::size_t i = 0; i < samples_;) {
        std::size_t end = i + 1;
        while (end < samples_ && shown[end] == shown[i]) ++end;
        if (shown[i] != noObject) count(pixel, shown[i], static_cast<std::uint32_t>(end - i));
        i = end;
      }
    }
  std::fill(view_.begin(), view_.end(), noObject);
}

void CoverageCounter::finish(PictureLayers& into, int pictures) const {
  const std::size_t all = samples_ * static_cast<std::size_t>(pictures);
  const std::size_t ranks = std::min(shifted_ ? quarters * all : all,
                                     static_cast<std::size_t>(PictureLayers::maxCoveragesPerPixel));
  into.objects = objects_;
  into.ranks = static_cast<int>(ranks);
  into.shares.assign(first_.size() * ranks, {});
  std::vector<Count> found;
  for (std::size_t pixel = 0; pixel < first_.size(); ++pixel) {
    if (first_[pixel].samples == 0) continue;
    found.assign(1, first_[pixel]);
    if (const auto others = more_.find(pixel); others != more_.end())
      found.insert(found.end(), others->second.begin(), others->second.end());
    std::stable_sort(found.begin(), found.end(),
                     [](const Count& a, const Count& b) { return a.samples > b.samples; });
    for (std::size_t rank = 0; rank < std::min(found.size(), ranks); ++rank)
      into.shares[pixel * ranks + rank] = {
          found[rank].object, static_cast<float>(found[rank].samples) / static_cast<float>(quarters * all)};
  }
}

}  // namespace simreel::draw
