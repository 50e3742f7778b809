#include "golden/suite/check.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::golden {

namespace {

/// Min standard deviation of luma, equal to one step of 8 bits. A picture with a smaller deviation counts
/// as blank.
constexpr double minDeviation = 1.0 / 255.0;
/// Lower limit of |first value| in the drift condition, because drift is relative to the first value.
constexpr double tiny = 1e-12;

constexpr const char* statisticNames[] = {"mean", "min", "max", "sum"};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> arrayNames(const sim::Simulation& simulation) {
  std::vector<std::string> names;
  for (const sim::StateArray& array : simulation.state()) names.emplace_back(array.name);
  return names;
}

}  // namespace

/// Resolves the names in a check to objects, arrays and quantities.
class Checker::Resolver {
 public:
  Resolver(const scene::Scene& scene, const sim::World& world, std::span<const int> tested)
      : scene_(scene), world_(world), tested_(tested) {}

  [[nodiscard]] Item resolve(std::size_t number) const {
    const scene::Check& check = scene_.checks[number];
    const std::string where = fmt::format("checks[{}]", number);
    Item item{.check = check, .label = check.what, .objects = {}, .frames = check.frames};
    if (item.frames.empty()) item.frames.assign(tested_.begin(), tested_.end());
    if (check.what == "not-blank") {
      item.kind = Item::Kind::notBlank;
      requirePictures(where, item.frames);
    } else if (check.what == "no-nan") {
      item.kind = Item::Kind::noNan;
      item.objects = withState(where, check);
      if (!check.object.empty()) item.label += " of " + check.object;
    } else if (check.isStatistic()) {
      resolveStatistic(where, item);
    } else {
      resolveQuantity(item);
    }
    return item;
  }

 private:
  void requirePictures(const std::string& where, const std::vector<int>& frames) const {
    for (const int frame : frames)
      if (!std::binary_search(tested_.begin(), tested_.end(), frame))
        fail(ExitCode::usage,
             "{}: \"not-blank\" needs a picture of frame {}, which is not tested; tested: {}", where, frame,
             fmt::join(tested_, ", "));
  }

  /// Returns the indices of the objects to which a check may refer. This is the named object, or all
  /// objects.
  [[nodiscard]] std::vector<std::size_t> candidates(const std::string& where,
                                                    const scene::Check& check) const {
    std::vector<std::size_t> found;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
      names.push_back(scene_.objects[i].name);
      if (check.object.empty() || names.back() == check.object) found.push_back(i);
    }
    if (found.empty() && !check.object.empty())
      fail(ExitCode::usage, "{}: no object is named {}; {}", where, scene::inQuotes(check.object),
           scene::suggestion(check.object, names));
    return found;
  }

  [[nodiscard]] std::vector<std::size_t> withState(const std::string& where,
                                                   const scene::Check& check) const {
    std::vector<std::size_t> found = candidates(where, check);
    std::erase_if(found, [&](std::size_t i) { return world_.object(i).state().empty(); });
    if (found.empty() && check.object.empty())
      fail(ExitCode::usage,
           "{}: \"no-nan\" checks the state of simulations, but no object of the scene has state", where);
    if (found.empty())
      fail(ExitCode::usage, "{}: object \"{}\" is a {}, which has no state to check", where, check.object,
           kindOf(check.object));
    return found;
  }

  [[nodiscard]] std::string kindOf(const std::string& object) const {
    for (const scene::Object& candidate : scene_.objects)
      if (candidate.name == object) return candidate.kind;
    return {};
  }

  /// Returns the only object that has a state array of that name. Throws UserError(usage) if no object or
  /// several objects have one.
  [[nodiscard]] std::size_t owner(const std::string& where, const scene::Check& check,
                                  const std::string& name) const {
    std::set<std::string> known;
    std::vector<std::size_t> owners;
    std::vector<std::string> ownerNames;
    for (const std::size_t i : candidates(where, check)) {
      const std::vector<std::string> names = arrayNames(world_.object(i));
      known.insert(names.begin(), names.end());
      if (!contains(names, name)) continue;
      owners.push_back(i);
      ownerNames.push_back(scene_.objects[i].name);
    }
    if (owners.empty()) {
      const std::string holder =
          check.object.empty()
              ? "no object of the scene has"
              : fmt::format("object \"{}\" is a {} and does not have", check.object, kindOf(check.object));
      const std::vector<std::string> names(known.begin(), known.end());
      fail(ExitCode::usage, "{}: {} an array named {}; {}", where, holder, scene::inQuotes(name),
           scene::suggestion(name, names));
    }
    if (owners.size() > 1)
      fail(ExitCode::usage, "{}: several objects have {}: {}; name one of them with \"object\"", where,
           scene::inQuotes(name), fmt::join(ownerNames, ", "));
    return owners.front();
  }

  void resolveStatistic(const std::string& where, Item& item) const {
    const scene::Check& check = item.check;
    item.kind = Item::Kind::statistic;
    const auto* name = std::find(std::begin(statisticNames), std::end(statisticNames), check.what);
    item.statistic = static_cast<Statistic>(name - std::begin(statisticNames));
    const std::size_t dot = std::min(check.of.rfind('.'), check.of.size());
    const std::string array = check.of.substr(0, dot);
    const std::string component = dot < check.of.size() ? check.of.substr(dot + 1) : "";
    const auto known = componentOf(component);
    if (!known)
      fail(ExitCode::usage, "{}: {} has no component {}; known here: x, y, z, w, length", where,
           scene::inQuotes(check.of), scene::inQuotes(component));
    item.component = *known;
    const std::size_t object = owner(where, check, array);
    const auto names = arrayNames(world_.object(object));
    item.index = static_cast<std::size_t>(std::find(names.begin(), names.end(), array) - names.begin());
    item.objects = {object};
    item.label = fmt::format("{} of {} {}", check.what, scene_.objects[object].name, check.of);
  }

  void resolveQuantity(Item& item) const {
    const std::string& what = item.check.what;
    const std::vector<std::size_t> owners = scene_.owners(item.check);
    SIMREEL_CHECK_EQ(owners.size(), 1U);  // The scene reader has already checked that there is one owner.
    const scene::Object& object = scene_.objects[owners.front()];
    const auto table = object.parameters->quantities();
    item.index = static_cast<std::size_t>(
        std::find_if(table.begin(), table.end(), [&](const auto& q) { return what == q.name; }) -
        table.begin());
    item.objects = owners;
    item.label = fmt::format("{} of {}", what, object.name);
  }

  const scene::Scene& scene_;
  const sim::World& world_;
  std::span<const int> tested_;
};

/// State of one frame, read back from the GPU. Each array and each object's quantities are read only once.
class Checker::StateOfFrame {
 public:
  explicit StateOfFrame(const sim::World& world) : world_(world) {}

  [[nodiscard]] const std::vector<glm::vec4>& array(std::size_t object, std::size_t index) {
    auto [place, isNew] = arrays_.try_emplace({object, index});
    if (!isNew) return place->second;
    const sim::StateArray array = world_.object(object).state().at(index);
    if (array.integers)
      for (const glm::uvec4& words : array.readAll<glm::uvec4>()) place->second.emplace_back(words);
    else
      place->second = array.readAll<glm::vec4>();
    return place->second;
  }
  [[nodiscard]] double quantity(std::size_t object, std::size_t index) {
    auto [place, isNew] = quantities_.try_emplace(object);
    if (isNew) place->second = world_.object(object).measure();
    return place->second.at(index);
  }
  [[nodiscard]] std::vector<sim::StateArray> arraysOf(std::size_t object) const {
    return world_.object(object).state();
  }

 private:
  const sim::World& world_;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<glm::vec4>> arrays_;
  std::map<std::size_t, std::vector<double>> quantities_;
};

Checker::Checker(const scene::Scene& scene, const sim::World& world, std::span<const int> testedFrames)
    : tested_(testedFrames.begin(), testedFrames.end()) {
  SIMREEL_CHECK(std::is_sorted(tested_.begin(), tested_.end()));
  for (const scene::Object& object : scene.objects) names_.push_back(object.name);
  const Resolver resolver(scene, world, tested_);
  for (std::size_t i = 0; i < scene.checks.size(); ++i) items_.push_back(resolver.resolve(i));
}

std::vector<int> Checker::frames() const {
  std::set<int> wanted;
  for (const Item& item : items_) wanted.insert(item.frames.begin(), item.frames.end());
  for (const int frame : tested_) wanted.erase(frame);
  return {wanted.begin(), wanted.end()};
}

void Checker::state(int frame, const sim::World& world) {
  SIMREEL_CHECK(frame > lastFrame_);
  SIMREEL_CHECK_EQ(frame, world.frame());
  lastFrame_ = frame;
  StateOfFrame state(world);
  evaluate(frame, [&](Item& item, CheckResult& result) {
    switch (item.kind) {
      case Item::Kind::notBlank:
        return false;
      case Item::Kind::noNan:
        checkFinite(item, state, result);
        break;
      case Item::Kind::statistic:
        return checkBounds(
            item, statistic(item.statistic, item.component, state.array(item.objects.front(), item.index)),
            result);
      case Item::Kind::quantity:
        return checkBounds(item, state.quantity(item.objects.front(), item.index), result);
    }
    return true;
  });
}

void Checker::picture(int frame, const frame::Image& image) {
  evaluate(frame, [&](const Item& item, CheckResult& result) {
    if (item.kind != Item::Kind::notBlank) return false;
    checkContrast(image, result);
    return true;
  });
}

/// Calls `look` for each check of this frame and stores the result if `look` returns true.
template <class Look>
void Checker::evaluate(int frame, const Look& look) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (!std::binary_search(items_[i].frames.begin(), items_[i].frames.end(), frame)) continue;
    CheckResult result;
    result.what = items_[i].label;
    result.frame = frame;
    if (!look(items_[i], result)) continue;
    result.passed = result.message.empty();
    results_[{frame, i}] = std::move(result);
  }
}

void Checker::resume(const std::vector<CheckResult>& earlier) {
  for (const CheckResult& result : earlier)
    for (std::size_t i = 0; i < items_.size(); ++i) {
      Item& item = items_[i];
      const bool isOf = item.label == result.what &&
                        std::binary_search(item.frames.begin(), item.frames.end(), result.frame) &&
                        !results_.contains({result.frame, i});
      if (!isOf) continue;
      if (!item.first && result.frame == item.frames.front()) item.first = result.value;
      results_[{result.frame, i}] = result;
      break;
    }
}

std::vector<CheckResult> Checker::results() const {
  std::vector<CheckResult> all;
  all.reserve(results_.size());
  for (const auto& [place, result] : results_) all.push_back(result);
  return all;
}

void Checker::checkContrast(const frame::Image& image, CheckResult& result) {
  const Contrast contrast = contrastOf(image);
  result.value = contrast.lumaDeviation;
  result.min = minDeviation;
  if (contrast.oneColour)
    result.message = fmt::format("frame {}: the picture is one colour", result.frame);
  else if (contrast.lumaDeviation < minDeviation)
    result.message = fmt::format(
        "frame {}: the picture is nearly one colour: the standard deviation of its luma is {:.3g}, below "
        "{:.3g}",
        result.frame, contrast.lumaDeviation, minDeviation);
}

void Checker::checkFinite(const Item& item, StateOfFrame& state, CheckResult& result) const {
  std::size_t count = 0;
  std::string first;
  for (const std::size_t object : item.objects) {
    const auto arrays = state.arraysOf(object);
    for (std::size_t a = 0; a < arrays.size(); ++a) {
      const auto& items = state.array(object, a);
      const NotFinite found = findNotFinite(items);
      if (found.count > 0 && first.empty())
        first = fmt::format("{}[{}].{} of {} is {}", arrays[a].name, found.element, "xyzw"[found.component],
                            names_[object],
                            std::isnan(items[found.element][found.component]) ? "NaN" : "infinite");
      count += found.count;
    }
  }
  result.value = static_cast<double>(count);
  result.max = 0;
  if (count == 0) return;
  result.message = fmt::format("frame {}: {}", result.frame, first);
  if (count > 1)
    result.message +=
        fmt::format(", and {} more number{} not finite", count - 1, count > 2 ? "s are" : " is");
}

bool Checker::checkBounds(Item& item, double value, CheckResult& result) {
  const scene::Check& check = item.check;
  const int since = item.frames.front();
  if (!item.first && check.drift && result.frame != since) {
    if (!item.reported)
      warn("drift of {} was not checked: this run did not begin before frame {}, from which it is counted",
           item.label, since);
    item.reported = true;
    return false;
  }
  if (!item.first) item.first = value;
  result.value = value;
  result.min = check.min;
  result.max = check.max;
  const std::string head = fmt::format("frame {}: {} is ", result.frame, item.label);
  const double first = *item.first;
  if (!std::isfinite(value))
    result.message = head + "not a finite number";
  else if (check.min && value < *check.min)
    result.message = fmt::format("{}{:.9g}, below {}", head, value, *check.min);
  else if (check.max && value > *check.max)
    result.message = fmt::format("{}{:.9g}, above {}", head, value, *check.max);
  if (!check.drift) return true;
  // The drift condition is |v - v0| <= drift max(|v0|, tiny).
  const double room = *check.drift * std::max(std::abs(first), tiny);
  if (result.message.empty() && !(std::abs(value - first) <= room))
    result.message = fmt::format("{}{:.9g}, {:.3g} away from {:.9g} at frame {}; drift {} allows {:.3g}",
                                 head, value, std::abs(value - first), first, since, *check.drift, room);
  result.min = std::max(first - room, check.min.value_or(first - room));
  result.max = std::min(first + room, check.max.value_or(first + room));
  return true;
}

}  // namespace simreel::golden
