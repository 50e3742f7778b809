#pragma once
#include "scene/texts/help_page.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::cli {

/// "cloth.pins" with its full sentence, default, range, unit and an example; a group with what lies in it.
/// Throws UserError(usage), with a suggestion, for an unknown name.
[[nodiscard]] std::string parameterText(std::string_view path, std::size_t width);
/// Every parameter and measured quantity whose name or sentence has all of the words.
[[nodiscard]] std::string searchText(const std::string& words, std::size_t width);
/// A shipped value of a parameter, as its scene writes it.
struct ShippedValue {
  std::string text;   ///< JSON
  std::string scene;  ///< "flag"
};
/// The shortest that a shipped scene has; none: no scene gives it.
[[nodiscard]] std::optional<ShippedValue> shippedValue(const scene::HelpPage& page,
                                                       std::string_view parameter);

/// All pages as JSON: `simreel list --format json`.
[[nodiscard]] std::string listJson();
[[nodiscard]] std::string pageJson(std::string_view name);
/// All pages as Markdown: `simreel list --format markdown`.
[[nodiscard]] std::string listMarkdown();
[[nodiscard]] std::string pageMarkdown(std::string_view name);

/// The commented scene that `simreel new KIND` prints. Throws UserError for an unknown kind.
[[nodiscard]] std::string starterText(std::string_view kind);

}  // namespace simreel::cli
