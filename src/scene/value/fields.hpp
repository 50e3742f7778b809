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

/// Versions of the scene format that this program reads.
inline constexpr int oldestSceneVersion = 1, sceneVersion = 2;

/// Closed interval of allowed values.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};
inline constexpr Range positive{1e-9, 1e9};
inline constexpr Range notNegative{0.0, 1e9};
inline constexpr Range fraction{0.0, 1.0};
inline constexpr Range anyNumber{-1e9, 1e9};

/// Pointer to the struct member that holds a field's value. If the field has words, an int is the index of
/// a word, or -1 for none, and a std::vector<int> holds several such indices. If the first two words are
/// "false" and "true", a scene gives them as JSON booleans.
using Member =
    std::variant<bool*, int*, float*, double*, std::string*, std::filesystem::path*, glm::vec3*,
                 glm::ivec2*, Animated<float>*, Animated<glm::vec3>*, std::optional<int>*,
                 std::optional<double>*, std::vector<int>*, std::vector<glm::ivec2>*, Formula*, Formulas*>;

/// Spec of a three-component value. If the object is flat, a scene may give the value as two numbers. The
/// number for `axis` is then left out.
struct Flat {
  int axis = -1;  ///< axis whose number may be left out; -1 if all three numbers are needed
  float value = 0;
};

/// Properties of a field, in addition to its name.
struct Spec {
  const char* doc = "";   ///< description in one sentence
  const char* unit = "";  ///< unit of measurement; "" for numbers without a unit
  Range range = {};       ///< allowed range of a number, or of each component of a vector
  std::span<const char* const> words = {};
  const char* none = nullptr;  ///< word in scenes that stands for the empty value of a std::optional<int>
  bool color = false;          ///< true if the vector is a linear RGB colour, which a scene may also give
                               ///< as text (colorOf)
  Flat flat = {};

  /// True if the first two words are "false" and "true".
  [[nodiscard]] bool isSwitch() const {
    return words.size() > 1 && std::string_view(words[0]) == "false" &&
           std::string_view(words[1]) == "true";
  }
};

/// Interface through which parameters are declared. `describe(Fields&)` of a struct declares each member
/// with its default (the current value), range, unit and a one-sentence description. Depending on the
/// Fields it receives, the same call reads a scene, writes the JSON Schema or prints the help.
class Fields {
 public:
  virtual ~Fields() = default;

  virtual void field(const char* name, Member member, const Spec& spec) = 0;
  /// Declares a group of fields. `present`: a flag that is set to true if the scene gives the group. It is
  /// null unless the group switches a feature on.
  virtual void section(const char* name, bool* present, const char* doc,
                       const std::function<void(Fields&)>& describe) = 0;
  /// Declares a list of groups. `items`: number of groups before the call. `resize(n)` replaces the groups
  /// by n groups with defaults. Then `describe(fields, i)` is called for each group.
  virtual void listOf(const char* name, const char* doc, std::size_t maxItems, std::size_t items,
                      const std::function<void(std::size_t)>& resize,
                      const std::function<void(Fields&, std::size_t)>& describe) = 0;
  /// Declares an object whose members are groups with names that the scene chooses. `names`: the current
  /// names. When a scene is read, `rename(n)` is called with the names in the scene and must replace the
  /// groups by one group with defaults for each name. Then `describe(fields, i)` is called for each group.
  /// `one`: word for one group in messages.
  virtual void namedGroups(const char* name, const char* doc, const char* one, std::size_t maxItems,
                           const std::vector<std::string>& names,
                           const std::function<void(const std::vector<std::string>&)>& rename,
                           const std::function<void(Fields&, std::size_t)>& describe) = 0;
  /// Gives the former name of the field that is declared next. Scenes may still use the former name; a
  /// warning then states the new name.
  virtual void formerly(const char* /*old*/, const char* /*name*/) {}
  /// Allows the scene to give the group declared next as a single word, which sets its field `field`. In
  /// lists and named groups, each group may be given as the value of that field: a word, a number or
  /// keyframes.
  virtual void shorthand(const char* /*group*/, const char* /*field*/) {}
  /// Allows the scene to give the optional group declared next as true (the group with its defaults) or
  /// false.
  virtual void switchable(const char* /*group*/) {}
  /// Describes in words the default of the field that was declared last, if that default is not constant
  /// ("the preset's"). Schema and help show these words as the default.
  virtual void leftOut(const char* /*name*/, const char* /*what*/) {}
  /// Reports an error that involves several values, at the place of field `name`. Has an effect only while
  /// a scene is read.
  virtual void error(const char* /*name*/, const std::string& /*message*/) {}
  /// Reports an error in the string value at `path`, in the byte range from `begin` to before `end`. If the
  /// scene does not give that value, the error is reported at this group. Has an effect only while a scene
  /// is read.
  virtual void errorIn(const std::vector<std::string>& /*path*/, std::size_t /*begin*/, std::size_t /*end*/,
                       const std::string& /*message*/) {}
  /// Warns that field `name`, which the scene gives, has no effect because of field `ruler`. This is only a
  /// warning, so that users can try one field without removing the other. Does not warn if only `ruler`
  /// comes from the command line. Both names may be paths such as "group.name".
  virtual void idle(const char* /*name*/, const char* /*ruler*/, const std::string& /*message*/) {}
  /// Calls idle() for each of `names` unless `used` is true. `what`: purpose of the fields, for the
  /// message.
  void idleUnless(bool used, const char* ruler, std::initializer_list<const char*> names,
                  const std::string& what) {
    if (used) return;
    for (const char* name : names)
      idle(name, ruler,
           "\"" + std::string(name).substr(std::string(name).rfind('.') + 1) + "\" is for " + what +
               "; here it does nothing");
  }
  /// True if the scene gives this field. False while the schema or the help is written.
  [[nodiscard]] virtual bool given(const char* /*name*/) const { return false; }
  /// Returns the version of the scene that is read. Returns the newest version while the schema or the help
  /// is written.
  [[nodiscard]] virtual int version() const { return sceneVersion; }
  /// Allows the scene to give the group declared next as a number or as keyframes, which set its field
  /// `field`.
  virtual void shortNumber(const char* /*group*/, const char* /*field*/) {}

  void boolean(const char* name, bool& value, const char* doc) { field(name, &value, {doc}); }
  void integer(const char* name, int& value, Range range, const char* unit, const char* doc) {
    field(name, &value, {doc, unit, range});
  }
  /// Declares a float or double, or an Animated of one of them.
  template <class Number>
  void number(const char* name, Number& value, Range range, const char* unit, const char* doc) {
    field(name, &value, {doc, unit, range});
  }
  /// Declares a number that is nullopt unless the scene gives it.
  void optionalNumber(const char* name, std::optional<double>& value, Range range, const char* unit,
                      const char* doc) {
    field(name, &value, {doc, unit, range});
  }
  /// Declares a vector of three numbers, which may be Animated.
  template <class Vector>
  void vector(const char* name, Vector& value, Range range, const char* unit, const char* doc) {
    field(name, &value, {doc, unit, range});
  }
  /// Declares a vector of three numbers that a scene may give as two if the object is flat.
  template <class Vector>
  void flatVector(const char* name, Vector& value, Range range, const char* unit, const char* doc,
                  Flat flat) {
    Spec spec{doc, unit, range};
    spec.flat = flat;
    field(name, &value, spec);
  }
  /// Declares a linear RGB colour, which keyframes may change if `Vector` is Animated. A scene may also
  /// give it as "#rrggbb" or by name.
  template <class Vector>
  void color(const char* name, Vector& value, Range range, const char* doc) {
    Spec spec{doc, "", range};
    spec.color = true;
    field(name, &value, spec);
  }
  /// Declares two integers, for example a grid's [width, height].
  void pair(const char* name, glm::ivec2& value, Range range, const char* unit, const char* doc) {
    field(name, &value, {doc, unit, range});
  }
  void pairs(const char* name, std::vector<glm::ivec2>& value, Range range, const char* unit,
             const char* doc) {
    field(name, &value, {doc, unit, range});
  }
  void text(const char* name, std::string& value, const char* doc) { field(name, &value, {doc}); }
  /// Declares an integer or one word, for example 4 or "auto". The word stands for nullopt.
  void integerOr(const char* name, std::optional<int>& value, const char* word, Range range,
                 const char* unit, const char* doc) {
    field(name, &value, {doc, unit, range, {}, word});
  }
  void integers(const char* name, std::vector<int>& value, Range range, const char* unit, const char* doc) {
    field(name, &value, {doc, unit, range});
  }
  /// Declares the index of one of `words`. For an enum, use `choice` below.
  void oneOf(const char* name, int& value, const std::vector<const char*>& words, const char* doc) {
    field(name, &value, {doc, "", {}, words});
  }
  /// Declares a field that is false, true or `word`. true sets `value`, `word` sets `other`, and false sets
  /// neither of the two.
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
  /// Declares a value of one or more components. A scene gives it as numbers and expressions, or as
  /// keyframes of numbers.
  void formula(const char* name, Formula& value, const char* unit, const char* doc) {
    field(name, &value, {doc, unit});
  }
  /// Declares several formulas with names that the scene chooses, or one formula without a name.
  void formulas(const char* name, Formulas& value, const char* doc) { field(name, &value, {doc}); }
  /// Declares a file below the scene's folder or the asset folder. The value becomes the full path, or
  /// empty if the scene names no file.
  void asset(const char* name, std::filesystem::path& value, const char* doc) {
    field(name, &value, {doc});
  }
  void group(const char* name, const char* doc, const std::function<void(Fields&)>& describe) {
    section(name, nullptr, doc, describe);
  }
  /// Declares a group that switches a feature on if the scene gives it.
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
  /// Declares a value that is nullopt unless the scene gives it. The help shows `shown` as its default.
  template <class Value, class Declare>
  void optionalValue(const char* name, std::optional<Value>& value, const Value& shown,
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
          // Uses a constant because of a bug of GCC 12, which named() below describes.
          const auto standard = Item();
          items.assign(count, standard);
        },
        [&](Fields& fields, std::size_t i) { describe(fields, items[i]); });
  }
  /// Declares named items. In the scene, an item's key is its name, which the member `name` holds.
  template <class Item, class Describe>
  void named(const char* name, std::vector<Item>& items, const char* doc, const char* one,
             Describe describe, std::size_t maxItems) {
    std::vector<std::string> names;
    names.reserve(items.size());
    for (const Item& item : items) names.push_back(item.name);
    namedGroups(
        name, doc, one, maxItems, names,
        [&](const std::vector<std::string>& wanted) {
          // Does not pass Item{} directly: if memory runs out, code of GCC 12 destroys the members of such
          // an aggregate twice.
          const auto standard = Item();
          items.assign(wanted.size(), standard);
          for (std::size_t i = 0; i < wanted.size(); ++i) items[i].name = wanted[i];
        },
        [&](Fields& fields, std::size_t i) { describe(fields, items[i]); });
  }
};

/// Number that a simulation measures from its state. Checks and charts use it.
struct Quantity {
  const char* name;
  const char* unit;  ///< unit of measurement; "" for numbers without a unit
  const char* doc;
};

/// Axis-aligned box.
struct Box {
  glm::vec3 min{0}, max{0};  ///< opposite corners in metres
  bool round = false;        ///< true if the content does not fill the box's corners, as for a ball
};

/// Extends the box to contain the point. An empty box becomes the point.
inline void include(std::optional<Box>& box, const glm::vec3& point) {
  if (!box) box = Box{point, point};
  box = Box{glm::min(box->min, point), glm::max(box->max, point)};
}

/// Parameters of one kind of object. Each simulation derives a class from it.
struct Parameters {
  virtual ~Parameters() = default;
  virtual void describe(Fields& fields) = 0;
  /// Returns the quantities that this kind of simulation measures. They are available only if measures() is
  /// true.
  [[nodiscard]] virtual std::span<const Quantity> quantities() const { return {}; }
  /// True if the simulation measures its quantities with the current parameters.
  [[nodiscard]] virtual bool measures() const { return !quantities().empty(); }
  /// Returns the extent that an automatically placed camera must show. Returns nullopt if the camera need
  /// not show the object. May read files that the parameters name; ignores files that cannot be read.
  [[nodiscard]] virtual std::optional<Box> framed() const { return std::nullopt; }
  /// Returns the extent that the camera shows if framed() is nullopt for every object. Returns nullopt if
  /// the object has no such extent.
  [[nodiscard]] virtual std::optional<Box> framedAlone() const { return std::nullopt; }
  /// Returns the default height in metres of the ground below the object. nullopt means the lowest point of
  /// framed(). Infinity means that only other objects determine the height.
  [[nodiscard]] virtual std::optional<float> supportHeight() const { return std::nullopt; }
  /// Type of stage that suits the object if it has no material (stage.hpp). Shining objects need dark
  /// surroundings. A landscape needs no stage.
  enum class Looks { solid, cloth, shining, landscape };
  [[nodiscard]] virtual Looks looks() const { return Looks::solid; }
  /// Returns a phrase that names the source of the object's colours if the object ignores its material.
  /// Returns null if the object uses the material.
  [[nodiscard]] virtual const char* drawnWith() const { return nullptr; }
};

/// Entry of the list of simulations, with the name in scenes, a description in one sentence, and a factory
/// for the parameters.
struct Kind {
  const char* name;
  const char* doc;
  std::function<std::unique_ptr<Parameters>()> makeParameters;
  /// Returns the text of a scene that uses a file in a format of this kind (such as a cell pattern), so
  /// that the file can be rendered like a scene. Returns an empty string for other files. Throws UserError
  /// if the file cannot be read.
  std::function<std::string(const std::filesystem::path& file)> sceneAround = {};
  /// Returns text that `simreel list` prints after the kind's table of parameters. Returns an empty string
  /// if none exists.
  std::function<std::string()> appendix = {};
};

}  // namespace simreel::scene
