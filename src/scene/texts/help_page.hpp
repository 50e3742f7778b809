#pragma once
#include "scene/scene.hpp"
#include "scene/value/help.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::scene {

/// Facts for `simreel list NAME` about one kind of object or one section of a scene.
struct HelpPage {
  std::string name, doc;
  bool isKind = false;  ///< whether it is a kind of object
  std::vector<HelpRow> rows;
  std::vector<Quantity> quantities;
  std::string appendix;  ///< text after the parameters; empty: none

  /// The parameters at `path` ("pins", "pins[].rows", "pins.rows") and in it; brackets may be left out.
  [[nodiscard]] std::vector<HelpRow> rowsAt(std::string_view path) const;
};

/// A name and its sentence.
struct HelpTitle {
  std::string name, doc;
};
[[nodiscard]] std::vector<HelpTitle> kindTitles(std::span<const Kind> kinds);
/// "scene" and all sections of a scene.
[[nodiscard]] std::vector<HelpTitle> sectionTitles();

/// Throws UserError(usage), with a suggestion, for an unknown name.
[[nodiscard]] HelpPage helpPage(std::string_view name, std::span<const Kind> kinds);

/// The page as text in lines of at most `width` columns.
[[nodiscard]] std::string helpText(std::string_view name, std::span<const Kind> kinds, std::size_t width);
/// The rows of a page alone.
[[nodiscard]] std::string rowsText(std::span<const HelpRow> rows, std::size_t width);
/// One entry for each kind and each scene section.
[[nodiscard]] std::string listText(std::span<const Kind> kinds, std::size_t width);
/// `path` without the brackets of lists.
[[nodiscard]] std::string withoutBrackets(std::string_view path);

}  // namespace simreel::scene
