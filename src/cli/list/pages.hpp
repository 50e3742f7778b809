#pragma once
#include "scene/texts/help_page.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::cli {

/// Returns the description of "cloth.pins": full sentence, default, range, unit and an example; for a group
/// also its members. Throws UserError(usage) with a suggestion for an unknown name.
[[nodiscard]] std::string parameterText(std::string_view path, std::size_t width);
/// Returns every parameter and measured quantity whose name or description contains all of the words.
[[nodiscard]] std::string searchText(const std::string& words, std::size_t width);
/// Value of a parameter as a shipped scene writes it.
struct ShippedValue {
  std::string text;   ///< value as JSON
  std::string scene;  ///< name of the scene, such as "flag"
};
/// Returns the shortest value of a parameter in the shipped scenes; nothing if no scene sets it.
[[nodiscard]] std::optional<ShippedValue> shippedValue(const scene::HelpPage& page,
                                                       std::string_view parameter);

/// Returns all pages as JSON: `simreel list --format json`.
[[nodiscard]] std::string listJson();
[[nodiscard]] std::string pageJson(std::string_view name);
/// Returns all pages as Markdown: `simreel list --format markdown`.
[[nodiscard]] std::string listMarkdown();
[[nodiscard]] std::string pageMarkdown(std::string_view name);

/// Returns the commented scene that `simreel new KIND` prints. Throws UserError for an unknown kind.
[[nodiscard]] std::string starterText(std::string_view kind);

}  // namespace simreel::cli
