#pragma once
#include "scene/scene.hpp"
#include "scene/value/help.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::scene {

/// Content of the page that `simreel list NAME` prints for one kind of object or one section of a scene.
struct HelpPage {
  std::string name, doc;
  bool isKind = false;  ///< true for a kind of object
  std::vector<HelpRow> rows;
  std::vector<Quantity> quantities;
  std::string appendix;  ///< text after the parameters; empty if none exists

  /// Returns the parameters at `path` ("pins", "pins[].rows", "pins.rows") and below that path. The
  /// brackets of lists may be left out.
  [[nodiscard]] std::vector<HelpRow> rowsAt(std::string_view path) const;
};

/// Name of a help page, and a sentence that describes it.
struct HelpTitle {
  std::string name, doc;
};
[[nodiscard]] std::vector<HelpTitle> kindTitles(std::span<const Kind> kinds);
/// Returns titles of "scene" and of all sections of a scene.
[[nodiscard]] std::vector<HelpTitle> sectionTitles();

/// Returns the page of a kind or section. Throws UserError(usage), with a suggestion, for an unknown name.
[[nodiscard]] HelpPage helpPage(std::string_view name, std::span<const Kind> kinds);

/// Returns the page as text in lines of at most `width` columns.
[[nodiscard]] std::string helpText(std::string_view name, std::span<const Kind> kinds, std::size_t width);
/// Returns the rows of a page as text.
[[nodiscard]] std::string rowsText(std::span<const HelpRow> rows, std::size_t width);
/// Returns the overview: one entry for each kind of object and each section of a scene.
[[nodiscard]] std::string listText(std::span<const Kind> kinds, std::size_t width);
/// Returns `path` without the brackets of lists.
[[nodiscard]] std::string withoutBrackets(std::string_view path);

}  // namespace simreel::scene
