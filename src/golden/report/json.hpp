#pragma once
#include "golden/result.hpp"

#include <string>

namespace simreel::golden {

/// Returns the report as indented JSON (report.json) with a final newline. Never throws. Invalid UTF-8
/// becomes U+FFFD. NaN and infinite numbers of checks and an infinite PSNR become null.
[[nodiscard]] std::string reportText(const SuiteResult& suite);
/// Parses the output of reportText. Throws UserError(usage) with the file's name and the wrong value
/// ("report.json: scenes[3].frames[0].pixels must be text"). The errors are: unknown, missing or repeated
/// keys, wrong types, another format, counts that do not match the scenes, and paths of images or
/// candidates that are absolute or leave the report's folder.
[[nodiscard]] SuiteResult parseReport(const std::string& text, const std::string& name);

}  // namespace simreel::golden
