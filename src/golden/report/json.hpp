#pragma once
#include "golden/result.hpp"

#include <string>

namespace simreel::golden {

/// The report as JSON (report.json), pretty-printed, ending in a newline. Never throws: bytes that are no
/// UTF-8 become U+FFFD; a check's NaN or infinite numbers and an infinite PSNR become null.
[[nodiscard]] std::string reportText(const SuiteResult& suite);
/// Reads what reportText wrote. Throws UserError(usage) naming the file and the value that is wrong with it
/// ("report.json: scenes[3].frames[0].pixels must be text"): unknown, missing or repeated keys, wrong
/// types, another format, counts that are not those of the scenes, and paths of images or candidates that
/// are absolute or lead out of the report's folder.
[[nodiscard]] SuiteResult parseReport(const std::string& text, const std::string& name);

}  // namespace simreel::golden
