// Tables of parameters for people, written by the same declarations that read them.
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "scene/describe.hpp"
#include "scene/diagnostics.hpp"

namespace simreel::scene {

namespace {

struct Row {
  std::string name, standard, range, unit, doc;
};

std::string rangeText(Range range) {
  return fmt::format("{:g}..{:g}", range.least, range.most);
}
std::string vectorText(const glm::vec3& v) {
  return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

/// Collects one row a parameter; groups become dotted names.
class HelpWriter : public Fields {
 public:
  HelpWriter(std::vector<Row>& rows, std::string prefix) : rows_(rows), prefix_(std::move(prefix)) {}

  void boolean(const char* name, bool& value, const char* doc) override { add(name, value ? "true" : "false", "", "", doc); }
  void integer(const char* name, int& value, Range range, const char* unit, const char* doc) override {
    add(name, std::to_string(value), rangeText(range), unit, doc);
  }
  void number(const char* name, float& value, Range range, const char* unit, const char* doc) override {
    add(name, fmt::format("{}", value), rangeText(range), unit, doc);
  }
  void number(const char* name, double& value, Range range, const char* unit, const char* doc) override {
    add(name, fmt::format("{}", value), rangeText(range), unit, doc);
  }
  void number(const char* name, Animated<float>& value, Range range, const char* unit, const char* doc) override {
    add(name, fmt::format("{}", value.at(0)), rangeText(range) + " *", unit, doc);
  }
  void vector(const char* name, glm::vec3& value, Range range, const char* unit, const char* doc) override {
    add(name, vectorText(value), rangeText(range), unit, doc);
  }
  void vector(const char* name, Animated<glm::vec3>& value, Range range, const char* unit, const char* doc) override {
    add(name, vectorText(value.at(0)), rangeText(range) + " *", unit, doc);
  }
  void pair(const char* name, glm::ivec2& value, Range range, const char* unit, const char* doc) override {
    add(name, fmt::format("[{}, {}]", value.x, value.y), rangeText(range), unit, doc);
  }
  void pairs(const char* name, std::vector<glm::ivec2>& /*value*/, Range range, const char* unit,
             const char* doc) override {
    add(name, "[]", rangeText(range), unit, doc);
  }
  void text(const char* name, std::string& value, const char* doc) override {
    add(name, fmt::format("\"{}\"", value), "text", "", doc);
  }
  void integerOr(const char* name, std::optional<int>& value, const char* word, Range range, const char* unit,
                 const char* doc) override {
    add(name, value ? std::to_string(*value) : word, fmt::format("{} or \"{}\"", rangeText(range), word), unit, doc);
  }
  void integers(const char* name, std::vector<int>& value, Range range, const char* unit, const char* doc) override {
    add(name, fmt::format("{}", value), rangeText(range), unit, doc);
  }
  void oneOf(const char* name, int& value, const std::vector<const char*>& names, const char* doc) override {
    add(name, names[static_cast<std::size_t>(value)], fmt::format("{}", fmt::join(names, "|")), "", doc);
  }
  void someOf(const char* name, std::vector<int>& /*value*/, const std::vector<const char*>& names,
              const char* doc) override {
    add(name, "[]", fmt::format("{}", fmt::join(names, ", ")), "", doc);
  }
  void asset(const char* name, std::filesystem::path& /*value*/, const char* doc) override {
    add(name, "none", "file", "", doc);
  }
  void group(const char* name, const char* doc, const std::function<void(Fields&)>& describe) override {
    add(name, "", "group", "", doc);
    nested(std::string(name) + ".", describe);
  }
  void optionalGroup(const char* name, bool& /*present*/, const char* doc,
                     const std::function<void(Fields&)>& describe) override {
    add(name, "absent", "group", "", doc);
    nested(std::string(name) + ".", describe);
  }
  void listOf(const char* name, const char* doc, std::size_t mostItems,
              const std::function<void(std::size_t)>& resize,
              const std::function<void(Fields&, std::size_t)>& describe) override {
    add(name, "", fmt::format("list, at most {}", mostItems), "", doc);
    resize(1);
    nested(std::string(name) + "[].", [&](Fields& fields) { describe(fields, 0); });
  }
  void error(const char* /*name*/, const std::string& /*message*/) override {}
  [[nodiscard]] bool given(const char* /*name*/) const override { return false; }

 private:
  void nested(const std::string& step, const std::function<void(Fields&)>& describe) {
    HelpWriter inner(rows_, prefix_ + step);
    describe(inner);
  }
  void add(const char* name, std::string standard, std::string range, const char* unit, const char* doc) {
    rows_.push_back({prefix_ + name, std::move(standard), std::move(range), unit, doc});
  }
  std::vector<Row>& rows_;
  std::string prefix_;
};

std::string table(const std::vector<Row>& rows) {
  std::size_t name = 4;
  std::size_t standard = 7;
  std::size_t range = 5;
  std::size_t unit = 4;
  for (const Row& row : rows) {
    name = std::max(name, row.name.size());
    standard = std::max(standard, row.standard.size());
    range = std::max(range, row.range.size());
    unit = std::max(unit, row.unit.size());
  }
  std::string text;
  const auto line = [&](const Row& row) {
    text += fmt::format("{:<{}}  {:<{}}  {:<{}}  {:<{}}  {}\n", row.name, name, row.standard, standard, row.range, range,
                        row.unit, unit, row.doc);
  };
  line({"name", "default", "range", "unit", "meaning"});
  for (const Row& row : rows) line(row);
  return text + "\n* may move: {\"keys\": [[time, value], ...], \"ease\": \"linear\" or \"smooth\"}\n";
}

struct Section {
  const char* name;
  const char* doc;
  std::function<void(Fields&)> describe;
};

const std::vector<Section>& sections() {
  static const std::vector<Section> list = {
      {"scene", "Every section of a scene but its objects.",
       [](Fields& f) {
         Scene scene;
         describeScene(f, scene);
       }},
      {"render", "The picture.", [](Fields& f) { Render().describe(f); }},
      {"time", "Frame rate and length.", [](Fields& f) { Time().describe(f); }},
      {"camera", "Where the picture is taken from.", [](Fields& f) { Camera().describe(f); }},
      {"sun", "The directional light.", [](Fields& f) { Sun().describe(f); }},
      {"sky", "Ambient light and background.", [](Fields& f) { Sky().describe(f); }},
      {"ground", "The ground plane.", [](Fields& f) { Ground().describe(f); }},
      {"material", "How an object's surface looks.", [](Fields& f) { Material().describe(f); }},
  };
  return list;
}

}  // namespace

std::string helpText(std::string_view name, std::span<const Kind> kinds) {
  std::vector<Row> rows;
  std::vector<std::string> names;
  for (const Kind& kind : kinds) {
    names.emplace_back(kind.name);
    if (name != kind.name) continue;
    HelpWriter writer(rows, "");
    kind.makeParameters()->describe(writer);
    return fmt::format("{}: {}\n\n{}", kind.name, kind.doc, table(rows));
  }
  for (const Section& section : sections()) {
    names.emplace_back(section.name);
    if (name != section.name) continue;
    HelpWriter writer(rows, "");
    section.describe(writer);
    return fmt::format("{}: {}\n\n{}", section.name, section.doc, table(rows));
  }
  fail(ExitCode::usage, "there is no \"{}\" to list; {}", name, suggestion(name, names));
}

std::string listText(std::span<const Kind> kinds) {
  std::string text = "Objects:\n";
  for (const Kind& kind : kinds) text += fmt::format("  {:<10} {}\n", kind.name, kind.doc);
  text += "Sections of a scene:\n";
  for (const Section& section : sections()) text += fmt::format("  {:<10} {}\n", section.name, section.doc);
  return text + "`simreel list NAME` shows every parameter with default, range and unit.\n";
}

}  // namespace simreel::scene
