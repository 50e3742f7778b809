#include "scene/choices.hpp"

namespace simreel::scene {

namespace {

/// Looks at one choice and passes over everything else.
class ChoiceFinder final : public Fields {
 public:
  explicit ChoiceFinder(std::string_view wanted) : wanted_(wanted) {}
  std::vector<std::string> words;

  void oneOf(const char* name, int& /*value*/, const std::vector<const char*>& names,
             const char* /*doc*/) override {
    if (name == wanted_) words.assign(names.begin(), names.end());
  }

  void boolean(const char*, bool&, const char*) override {}
  void integer(const char*, int&, Range, const char*, const char*) override {}
  void number(const char*, float&, Range, const char*, const char*) override {}
  void number(const char*, double&, Range, const char*, const char*) override {}
  void number(const char*, Animated<float>&, Range, const char*, const char*) override {}
  void optionalNumber(const char*, std::optional<double>&, Range, const char*, const char*) override {}
  void vector(const char*, glm::vec3&, Range, const char*, const char*) override {}
  void vector(const char*, Animated<glm::vec3>&, Range, const char*, const char*) override {}
  void pair(const char*, glm::ivec2&, Range, const char*, const char*) override {}
  void pairs(const char*, std::vector<glm::ivec2>&, Range, const char*, const char*) override {}
  void text(const char*, std::string&, const char*) override {}
  void integerOr(const char*, std::optional<int>&, const char*, Range, const char*, const char*) override {}
  void integers(const char*, std::vector<int>&, Range, const char*, const char*) override {}
  void someOf(const char*, std::vector<int>&, const std::vector<const char*>&, const char*) override {}
  void asset(const char*, std::filesystem::path&, const char*) override {}
  void group(const char*, const char*, const std::function<void(Fields&)>&) override {}
  void optionalGroup(const char*, bool&, const char*, const std::function<void(Fields&)>&) override {}
  void listOf(const char*, const char*, std::size_t, std::size_t, const std::function<void(std::size_t)>&,
              const std::function<void(Fields&, std::size_t)>&) override {}
  void leftOut(const char*, const char*) override {}
  void error(const char*, const std::string&) override {}
  [[nodiscard]] bool given(const char*) const override { return false; }

 private:
  std::string_view wanted_;
};

}  // namespace

std::vector<std::string> choicesOf(const Kind& kind, std::string_view name) {
  ChoiceFinder finder(name);
  kind.makeParameters()->describe(finder);
  return finder.words;
}

}  // namespace simreel::scene
