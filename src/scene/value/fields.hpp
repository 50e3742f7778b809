#pragma once
#include "scene/value/animated.hpp"
#include "scene/value/formula.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::scene {

/// Closed interval of allowed values.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};
inline constexpr Range positive{1e-9, 1e9};
inline constexpr Range notNegative{0.0, 1e9};
inline constexpr Range fraction{0.0, 1.0};
inline constexpr Range anyNumber{-1e9, 1e9};

/// What a field holds: the member of a parameter struct. An int with words is the index of one of them, or
/// -1 where none applies unless one is given; a std::vector<int> with words some of them. Where the first
/// words are "false" and "true", a scene says those two without quotes.
using Member =
    std::variant<bool*, int*, float*, double*, std::string*, std::filesystem::path*, glm::vec3*,
                 glm::ivec2*, Animated<float>*, Animated<glm::vec3>*, std::optional<int>*,
                 std::optional<double>*, std::vector<int>*, std::vector<glm::ivec2>*, Formula*, Formulas*>;

/// What is said of a field beside its name.
struct Spec {
  const char* doc = "";   ///< one sentence
  const char* unit = "";  ///< "" when there is none
  Range range = {};       ///< holds for each number of several
  std::span<const char* const> words = {};
  const char* none = nullptr;  ///< word for the empty value of a std::optional<int>

  /// Whether the words begin with the two of JSON.
  [[nodiscard]] bool isSwitch() const {
    return words.size() > 1 && std::string_view(words[0]) == "false" &&
           std::string_view(words[1]) == "true";
  }
};

/// Where parameters are declared, once. A struct's `describe(Fields&)` names each of its members with
/// default (the value it has then), range, unit and one sentence; the same call reads a scene, writes
/// the JSON Schema or prints the help, whichever Fields it is given.
class Fields {
 public:
  virtual ~Fields() = default;

  virtual void field(const char* name, Member member, const Spec& spec) = 0;
  /// A group of fields. `present`: null, or of a group that switches a feature on by being there.
  virtual void section(const char* name, bool* present, const char* doc,
                       const std::function<void(Fields&)>& describe) = 0;
  /// A list of groups, which has `items` of them now: `resize(n)` makes n fresh ones, then
  /// `describe(fields, i)` is called for each element.
  virtual void listOf(const char* name, const char* doc, std::size_t maxItems, std::size_t items,
                      const std::function<void(std::size_t)>& resize,
                      const std::function<void(Fields&, std::size_t)>& describe) = 0;
  /// Groups under names that the scene chooses, now `names`: `rename(n)` makes a fresh one for each of the
  /// names n, then `describe(fields, i)` is called for each. `one`: what a message calls one of them.
  virtual void namedGroups(const char* name, const char* doc, const char* one, std::size_t maxItems,
                           const std::vector<std::string>& names,
                           const std::function<void(const std::vector<std::string>&)>& rename,
                           const std::function<void(Fields&, std::size_t)>& describe) = 0;
  /// What the field declared next was called before: still read, with a warning that says the name.
  virtual void formerly(const char* /*old*/, const char* /*name*/) {}
  /// The group declared next may be given as one word, which is the value of its field `field` then. Of
  /// groups under names, and of lists, each may be given as that value: a word, a number, keyframes.
  virtual void shorthand(const char* /*group*/, const char* /*field*/) {}
  /// The optional group declared next may be given as true, which is the group without fields, or false.
  virtual void switchable(const char* /*group*/) {}
  /// What stands for the field just declared where a scene leaves it out, when that is no constant
  /// ("the preset's"): shown in place of the value.
  virtual void leftOut(const char* /*name*/, const char* /*what*/) {}
  /// Reports a mistake that involves several values, at the place of field `name`. Nothing happens
  /// unless a scene is being read.
  virtual void error(const char* /*name*/, const std::string& /*message*/) {}
  /// The same at bytes begin to end of a text, which the members of `path` lead to from here. Where the
  /// scene does not give that text: at this group.
  virtual void errorIn(const std::vector<std::string>& /*path*/, std::size_t /*begin*/, std::size_t /*end*/,
                       const std::string& /*message*/) {}
  /// Remarks that field `name`, which the scene gives, does nothing because of what field `ruler` says: a
  /// warning and no mistake, so that one may be tried without leaving out the other. Not said where it is
  /// only the ruling value that comes from the command line. Both may be paths, "group.name".
  virtual void idle(const char* /*name*/, const char* /*ruler*/, const std::string& /*message*/) {}
  /// The same of each of `names` unless they are `used`; "what" they are for.
  void idleUnless(bool used, const char* ruler, std::initializer_list<const char*> names,
                  const std::string& what) {
    if (used) return;
    for (const char* name : names)
      idle(name, ruler,
           "\"" + std::string(name).substr(std::string(name).rfind('.') + 1) + "\" is for " + what +
               "; here it does nothing");
  }
  /// Whether the scene gives this field itself (false while writing schema or help).
  [[nodiscard]] virtual bool given(const char* /*name*/) const { return false; }

  void boolean(const char* name, bool& value, const char* doc) { field(name, &value, {doc}); }
  void integer(const char* name, int& value, Range range, const char* unit, const char* doc) {
    field(name, &value, {doc, unit, range});
  }
  /// A float, a double, or one of them that may move (Animated).
  template <class Number>
  void number(const char* name, Number& value, Range range, const char* unit, const char* doc) {
    field(name, &value, {doc, unit, range});
  }
  /// A number that has no value unless it is given.
  void optionalNumber(const char* name, std::optional<double>& value, Range range, const char* unit,
                      const char* doc) {
    field(name, &value, {doc, unit, range});
  }
  /// Three numbers, which may move.
  template <class Vector>
  void vector(const char* name, Vector& value, Range range, const char* unit, const char* doc) {
    field(name, &value, {doc, unit, range});
  }
  /// Two integers, for example a grid's [width, height].
  void pair(const char* name, glm::ivec2& value, Range range, const char* unit, const char* doc) {
    field(name, &value, {doc, unit, range});
  }
  void pairs(const char* name, std::vector<glm::ivec2>& value, Range range, const char* unit,
             const char* doc) {
    field(name, &value, {doc, unit, range});
  }
  void text(const char* name, std::string& value, const char* doc) { field(name, &value, {doc}); }
  /// An integer or one word, for example 4 or "auto" (empty value).
  void integerOr(const char* name, std::optional<int>& value, const char* word, Range range,
                 const char* unit, const char* doc) {
    field(name, &value, {doc, unit, range, {}, word});
  }
  void integers(const char* name, std::vector<int>& value, Range range, const char* unit, const char* doc) {
    field(name, &value, {doc, unit, range});
  }
  /// One of `words`, by its index. Use `choice` below for an enum.
  void oneOf(const char* name, int& value, const std::vector<const char*>& words, const char* doc) {
    field(name, &value, {doc, "", {}, words});
  }
  /// false, true or `word`: `value` or `other`, or neither.
  void booleanOr(const char* name, bool& value, bool& other, const char* word, const char* doc) {
    int index = other ? 2 : value ? 1 : 0;
    oneOf(name, index, {"false", "true", word}, doc);
    value = index == 1;
    other = index == 2;
  }
  void someOf(const char* name, std::vector<int>& value, const std::vector<const char*>& words,
              const char* doc) {
    field(name, &value, {doc, "", {}, words});
  }
  /// A value of one or more components: numbers, expressions, or numbers that move.
  void formula(const char* name, Formula& value, const char* unit, const char* doc) {
    field(name, &value, {doc, unit});
  }
  /// The same under names that the scene chooses, or one without a name.
  void formulas(const char* name, Formulas& value, const char* doc) { field(name, &value, {doc}); }
  /// A file of the scene's folder or the asset folder; the value becomes its full path. Empty: none.
  void asset(const char* name, std::filesystem::path& value, const char* doc) {
    field(name, &value, {doc});
  }
  void group(const char* name, const char* doc, const std::function<void(Fields&)>& describe) {
    section(name, nullptr, doc, describe);
  }
  /// A group that switches a feature on by being there.
  void optionalGroup(const char* name, bool& present, const char* doc,
                     const std::function<void(Fields&)>& describe) {
    section(name, &present, doc, describe);
  }
  template <class Group, class Describe>
  void optionalGroup(const char* name, std::optional<Group>& group, const char* doc,
                     const Describe& describe) {
    bool present = group.has_value();
    if (!present) group.emplace();
    section(name, &present, doc, [&](Fields& inner) { describe(inner, *group); });
    if (!present) group.reset();
  }
  template <class Group>
  void optionalGroup(const char* name, std::optional<Group>& group, const char* doc) {
    optionalGroup(name, group, doc, [](Fields& inner, Group& value) { value.describe(inner); });
  }
  /// A value that there is only where it is given; help shows `shown` for it.
  template <class Value, class Declare>
  void onlyGiven(const char* name, std::optional<Value>& value, const Value& shown,
                 const Declare& declare) {
    Value read = value.value_or(shown);
    declare(read);
    value = given(name) ? std::optional(std::move(read)) : std::nullopt;
  }
  template <class Enum>
  void choice(const char* name, Enum& value, const std::vector<const char*>& words, const char* doc) {
    int index = static_cast<int>(value);
    oneOf(name, index, words, doc);
    value = static_cast<Enum>(index);
  }
  template <class Item, class Describe>
  void list(const char* name, std::vector<Item>& items, const char* doc, Describe describe,
            std::size_t maxItems = 256) {
    listOf(
        name, doc, maxItems, items.size(),
        [&](std::size_t count) {
          const auto standard = Item();  // as below
          items.assign(count, standard);
        },
        [&](Fields& fields, std::size_t i) { describe(fields, items[i]); });
  }
  /// Items that have a `name`, which is their key in the scene.
  template <class Item, class Describe>
  void named(const char* name, std::vector<Item>& items, const char* doc, const char* one,
             Describe describe, std::size_t maxItems) {
    std::vector<std::string> names;
    names.reserve(items.size());
    for (const Item& item : items) names.push_back(item.name);
    namedGroups(
        name, doc, one, maxItems, names,
        [&](const std::vector<std::string>& wanted) {
          // Not of Item{}: where memory is short GCC 12 ends the members of such an aggregate twice.
          const auto standard = Item();
          items.assign(wanted.size(), standard);
          for (std::size_t i = 0; i < wanted.size(); ++i) items[i].name = wanted[i];
        },
        [&](Fields& fields, std::size_t i) { describe(fields, items[i]); });
  }
};

/// One number that a simulation measures of its state, for checks of tests.
struct Quantity {
  const char* name;
  const char* unit;  ///< "" when there is none
  const char* doc;
};

/// A box along the axes of the scene.
struct Box {
  glm::vec3 min{0}, max{0};  ///< m
  bool round = false;        ///< what is in it has none of its corners, as a ball
};

/// The least box that has the point, too.
inline void include(std::optional<Box>& box, const glm::vec3& point) {
  if (!box) box = Box{point, point};
  box = Box{glm::min(box->min, point), glm::max(box->max, point)};
}

/// Parameters of one kind of object; each simulation derives its own.
struct Parameters {
  virtual ~Parameters() = default;
  virtual void describe(Fields& fields) = 0;
  /// What this kind of simulation measures of its state, if measures().
  [[nodiscard]] virtual std::span<const Quantity> quantities() const { return {}; }
  /// Whether it does with these values.
  [[nodiscard]] virtual bool measures() const { return !quantities().empty(); }
  /// What a camera has in view that the scene places nowhere; nothing of kinds that leave it alone. May
  /// read the files that they name, and says nothing of those that cannot be read.
  [[nodiscard]] virtual std::optional<Box> framed() const { return std::nullopt; }
  /// How it looks where nobody says so (stage.hpp): what shines wants darkness around it, a landscape is
  /// surroundings itself.
  enum class Looks { solid, cloth, shining, landscape };
  [[nodiscard]] virtual Looks looks() const { return Looks::solid; }
  /// What it is drawn with in place of the object's material; null: that.
  [[nodiscard]] virtual const char* drawnWith() const { return nullptr; }
};

/// One line of the list of simulations: what a scene calls it, one sentence, and how to make its
/// parameters.
struct Kind {
  const char* name;
  const char* doc;
  std::function<std::unique_ptr<Parameters>()> makeParameters;
  /// The text of a scene around a file of this kind's own format (a pattern of cells), which may be
  /// rendered like a scene; empty for other files. Throws UserError for one that cannot be read.
  std::function<std::string(const std::filesystem::path& file)> sceneAround = {};
  /// What follows the table of its parameters on its page of `simreel list`; empty: nothing.
  std::function<std::string()> appendix = {};
};

}  // namespace simreel::scene
