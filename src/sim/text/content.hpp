#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::sim {

/// Text of a scene with the placeholders {frame}, {time} (in seconds) and {OBJECT.QUANTITY}. Each may have
/// a number of decimals, for example {time:2}. "{{" stands for a literal brace.
class TextContent {
 public:
  struct Part {
    std::string plain = {};  ///< plain text before the placeholder
    enum class Number { none, frame, time, quantity } number = Number::none;
    std::string object = {}, quantity = {};
    std::optional<int> digits = {};
  };

  /// Throws std::invalid_argument with a description of the error.
  explicit TextContent(std::string_view text);

  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
  [[nodiscard]] bool changes() const;
  /// Returns all characters of the plain text and all characters that numbers can contain.
  [[nodiscard]] std::string alphabet() const;
  /// Callback that returns the current value of a quantity.
  using Measured = std::function<double(const std::string& object, const std::string& quantity)>;
  [[nodiscard]] std::string at(long frame, double seconds, const Measured& measured) const;

 private:
  std::vector<Part> parts_;
};

}  // namespace simreel::sim
