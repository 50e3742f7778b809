#include "golden/trace/pass_difference.hpp"

#include "base/error.hpp"
#include "draw/exact/pass_list.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

namespace simreel::golden {

namespace {

using draw::PassArray;
using draw::PassPicture;

const PassArray* find(const PassPicture& picture, const std::string& pass, const std::string& part) {
  for (const PassArray& array : picture.arrays)
    if (array.pass == pass && array.part == part) return &array;
  return nullptr;
}

bool sameShape(const PassArray& a, const PassArray& b) {
  return a.width == b.width && a.height == b.height && a.each == b.each;
}

PicturePlace placeOf(const PassArray& array, std::size_t item) {
  const auto width = static_cast<std::size_t>(array.width);
  return {static_cast<int>(item % width), static_cast<int>(item / width)};
}

/// Differences between two arrays of equal shape.
struct Found {
  /// index of the first differing item that is preferred; if there is none, of the first differing item
  std::size_t first = 0;
  std::int64_t count = 0;  ///< number of differing items
};

template <class Preferred>
Found compareItems(const PassArray& a, const PassArray& b, const Preferred& preferred) {
  const auto each = static_cast<std::size_t>(a.each);
  Found found;
  bool chosen = false;
  for (std::size_t at = 0; at + each <= a.words.size(); at += each) {
    if (std::equal(&a.words[at], &a.words[at] + each, &b.words[at])) continue;
    const std::size_t item = at / each;
    if (found.count++ == 0) found.first = item;
    if (chosen || !preferred(placeOf(a, item))) continue;
    found.first = item;
    chosen = true;
  }
  return found;
}

class Comparison {
 public:
  Comparison(const PassDump& here, const PassDump& there) : here_(here.picture), there_(there.picture) {
    result_.frame = here.frame;
  }

  std::optional<PassDifference> run() {
    for (const std::string& pass : draw::passNames())
      if (differs(pass)) return result_;
    return std::nullopt;
  }

 private:
  bool differs(const std::string& pass) {
    for (const PassPicture* picture : {&here_, &there_})
      for (const PassArray& array : picture->arrays)
        if (array.pass == pass && differs(pass, array.part)) return true;
    return false;
  }

  bool differs(const std::string& pass, const std::string& part) {
    const PassArray* a = find(here_, pass, part);
    const PassArray* b = find(there_, pass, part);
    result_.pass = pass;
    result_.part = part;
    if (a == nullptr || b == nullptr) return true;
    if (!sameShape(*a, *b))
      fail(ExitCode::usage,
           "the two sides draw pictures of different sizes: {} has {}x{} with {} words per pixel here and "
           "{}x{} "
           "with {} there",
           part.empty() ? pass : pass + " (" + part + ")", a->width, a->height, a->each, b->width,
           b->height, b->each);
    if (a->words == b->words) return false;
    if (pass == "visibility")
      describeSample();
    else
      describeItem(*a, *b);
    return true;
  }

  /// Describes the first sample whose key or primitive number differs.
  void describeSample() {
    const PassArray* keys[] = {find(here_, "visibility", "keys"), find(there_, "visibility", "keys")};
    const PassArray* numbers[] = {find(here_, "visibility", "numbers"),
                                  find(there_, "visibility", "numbers")};
    if (keys[0] == nullptr || keys[1] == nullptr || numbers[0] == nullptr || numbers[1] == nullptr) return;
    const auto each = static_cast<std::size_t>(keys[0]->each);
    std::size_t first = keys[0]->words.size();
    for (std::size_t i = keys[0]->words.size(); i-- > 0;) {
      if (keys[0]->words[i] == keys[1]->words[i] && numbers[0]->words[i] == numbers[1]->words[i]) continue;
      first = i;
      ++result_.differing;
    }
    result_.all = static_cast<std::int64_t>(keys[0]->words.size());
    result_.pixel = placeOf(*keys[0], first / each);
    result_.sample = static_cast<int>(first % each);
    result_.here = thingOfNumber(here_, numbers[0]->words[first]);
    result_.there = thingOfNumber(there_, numbers[1]->words[first]);
    result_.values = 1;
    result_.hereValues[0] = keys[0]->words[first];
    result_.thereValues[0] = keys[1]->words[first];
  }

  void describeItem(const PassArray& a, const PassArray& b) {
    const auto each = static_cast<std::size_t>(a.each);
    const bool map = result_.pass == "shadow" || result_.pass == "bloom";
    const Found found = compareItems(a, b, [&](PicturePlace at) { return !map && alone(at); });
    const PicturePlace place = placeOf(a, found.first);
    result_.differing = found.count;
    result_.all = static_cast<std::int64_t>(a.words.size() / each);
    result_.values = std::min(a.each, 4);
    result_.light = a.light;
    std::copy_n(&a.words[found.first * each], result_.values, result_.hereValues.begin());
    std::copy_n(&b.words[found.first * each], result_.values, result_.thereValues.begin());
    if (result_.pass == "shadow") {
      result_.texel = place;
      result_.pixel = firstLight();
    } else if (result_.pass == "bloom") {
      result_.texel = place;
      result_.pixel = {2 * place.x, 2 * place.y};
    } else {
      result_.pixel = place;
    }
    if (!result_.pixel) return;
    result_.here = thingAt(here_, result_.pixel->x, result_.pixel->y);
    result_.there = thingAt(there_, result_.pixel->x, result_.pixel->y);
  }

  [[nodiscard]] bool alone(PicturePlace at) const { return showsOneThing(here_, at.x, at.y); }

  /// Returns the first pixel whose light differs, for a difference in a shadow map.
  [[nodiscard]] std::optional<PicturePlace> firstLight() const {
    const PassArray* a = find(here_, "light", "");
    const PassArray* b = find(there_, "light", "");
    if (a == nullptr || b == nullptr || !sameShape(*a, *b)) return std::nullopt;
    const Found found = compareItems(*a, *b, [&](PicturePlace at) { return alone(at); });
    if (found.count == 0) return std::nullopt;
    return placeOf(*a, found.first);
  }

  const PassPicture& here_;
  const PassPicture& there_;
  PassDifference result_;
};

}  // namespace

std::optional<float> nearnessOf(std::uint32_t key) {
  constexpr std::uint32_t maximum = 0x7fffffffU;  // constant of nearKey() in
                                                  // glsl/draw/exact/triangles/triangle.glsl
  if (key > maximum) return std::nullopt;
  return std::bit_cast<float>(maximum - key);
}

std::optional<PassDifference> comparePasses(const PassDump& here, const PassDump& there) {
  return Comparison(here, there).run();
}

}  // namespace simreel::golden
