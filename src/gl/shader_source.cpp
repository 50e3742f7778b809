#include "gl/shader_source.hpp"

#include "base/error.hpp"
#include "base/file.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace simreel::gl {

namespace {

std::filesystem::path shaderFolder() {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment is only read.
  if (const char* chosen = std::getenv("SIMREEL_GLSL")) return chosen;
  const auto installed = programFolder() / "../share/simreel/glsl";
  std::error_code error;
  return std::filesystem::is_directory(installed, error) ? installed : std::filesystem::path();
}

std::string shaderText(const std::string& path, const std::string& asker) {
  const auto folder = shaderFolder();
  std::error_code error;
  if (!folder.empty() && std::filesystem::exists(folder / path, error))
    return readFile(folder / path, "shader");
  for (const EmbeddedShader& shader : embeddedShaders())
    if (folder.empty() && path == shader.path) return shader.text;
  fail(ExitCode::device, "{} asks for the shader file {}, which does not exist", asker, path);
}

void paste(ShaderSource& source, const std::string& path, const std::string& asker) {
  if (std::find(source.files.begin(), source.files.end(), path) != source.files.end()) return;
  const auto number = source.files.size();
  source.files.push_back(path);
  source.text += fmt::format("#line 1 {}\n", number);
  std::istringstream lines(shaderText(path, asker));
  int lineNumber = 0;
  for (std::string line; std::getline(lines, line);) {
    ++lineNumber;
    constexpr std::string_view directive = "#include \"";
    if (!line.starts_with(directive)) {
      source.text += line + '\n';
      continue;
    }
    const auto close = line.find('"', directive.size());
    const std::string here = fmt::format("{}:{}", path, lineNumber);
    if (close == std::string::npos) fail(ExitCode::device, "{}: the include has no closing quote", here);
    paste(source, line.substr(directive.size(), close - directive.size()), here);
    source.text += fmt::format("#line {} {}\n", lineNumber + 1, number);
  }
}

}  // namespace

std::string ShaderSource::explain(std::string_view log) const {
  std::string result;
  std::istringstream lines{std::string(log)};
  for (std::string line; std::getline(lines, line);) {
    std::size_t digits = 0;
    while (digits < line.size() && std::isdigit(static_cast<unsigned char>(line[digits])) != 0) ++digits;
    // Mesa writes "string:line(column): ", NVIDIA "string(line) : ".
    if (digits > 0 && digits < 6 && digits < line.size() && (line[digits] == ':' || line[digits] == '(')) {
      const auto file = static_cast<std::size_t>(std::stoi(line.substr(0, digits)));
      auto end = digits + 1;
      while (end < line.size() && std::isdigit(static_cast<unsigned char>(line[end])) != 0) ++end;
      if (file < files.size() && end > digits + 1) {
        const auto rest = line[digits] == '(' && end < line.size() ? end + 1 : end;
        line = fmt::format("glsl/{}:{}{}", files[file], line.substr(digits + 1, end - digits - 1),
                           line.substr(rest));
      }
    }
    result += line + '\n';
  }
  return result;
}

ShaderSource loadShader(const std::string& path, const Defines& defines) {
  ShaderSource source;
  // What the files that are C++, too, mark for it (glsl/common/cpp.hpp).
  source.text = "#version 450 core\n#define FUNCTION\n#define STD140\n#define DEFAULT(value)\n";
  for (const auto& [name, value] : defines) source.text += fmt::format("#define {} {}\n", name, value);
  paste(source, path, "the program");
  return source;
}

}  // namespace simreel::gl
