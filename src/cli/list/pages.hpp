#pragma once
#include "scene/texts/help_page.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::cli {

/// Returns the description of a parameter such as "cloth.pins". It consists of a full sentence, default,
/// range, unit and an example. The description of a group also has its members. Throws UserError(usage)
/// with a suggestion for an unknown name.
[[nodiscard]] std::string parameterText(std::string_view path, std::size_t width);
/// Returns all parameters and measured quantities whose name or description contains all of the words.
[[nodiscard]] std::string searchText(const std::string& words, std::size_t width);
/// Value that a shipped scene gives to a parameter.
struct ShippedValue {
  std::string text;   ///< value as JSON
  std::string scene;  ///< name of the scene, such as "flag"
};
/// Returns the shortest value that a shipped scene gives to a parameter, or nullopt if no scene sets it.
[[nodiscard]] std::optional<ShippedValue> shippedValue(const scene::HelpPage& page,
                                                       std::string_view parameter);

/// These functions return all pages, or one page, as JSON for `simreel list --format json`.
[[nodiscard]] std::string listJson();
[[nodiscard]] std::string pageJson(std::string_view name);
/// These functions return all pages, or one page, as Markdown for `simreel list --format markdown`.
[[nodiscard]] std::string listMarkdown();
[[nodiscard]] std::string pageMarkdown(std::string_view name);

/// Returns the commented scene that `simreel new KIND` prints. Throws UserError for an unknown kind.
[[nodiscard]] std::string starterText(std::string_view kind);

}  // namespace simreel::cli
