#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::sim {

/// What a scene's text says, with places for numbers that change: {frame}, {time} (s) and
/// {OBJECT.QUANTITY}, each with a number of digits after the point if it has one: {time:2}. "{{" is a
/// brace.
class TextContent {
 public:
  struct Part {
    std::string plain = {};  ///< before the number
    enum class Number { none, frame, time, quantity } number = Number::none;
    std::string object = {}, quantity = {};
    std::optional<int> digits = {};
  };

  /// Throws std::invalid_argument with what is wrong.
  explicit TextContent(std::string_view text);

  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
  [[nodiscard]] bool changes() const;
  /// Every character that numbers may be written with, and those of the plain text.
  [[nodiscard]] std::string alphabet() const;
  /// Its value now.
  using Measured = std::function<double(const std::string& object, const std::string& quantity)>;
  [[nodiscard]] std::string at(long frame, double seconds, const Measured& measured) const;

 private:
  std::vector<Part> parts_;
};

}  // namespace simreel::sim
