#include "gl/shader_source.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "gl/context.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <sstream>
#include <utility>
#include <vector>

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

/// Pastes a shader and its includes into one text. The compiler may skip an include inside an #if.
/// Therefore later includes of the same file paste it again, inside an include guard, and the first
/// compiled copy takes effect.
class Paster {
 public:
  explicit Paster(ShaderSource& source) : source_(source) {}

  void paste(const std::string& path, const std::string& asker) {
    pasteText(path, asker, [&] { return shaderText(path, asker); });
  }

  void pasteText(const std::string& path, const std::string& asker,
                 const std::function<std::string()>& text) {
    if (std::find(open_.begin(), open_.end(), path) != open_.end())
      fail(ExitCode::device, "{}: {} includes itself", asker, path);
    const std::size_t number = numberOf(path);
    if (certain_[number]) return;
    certain_[number] = conditions_ == 0;
    open_.push_back(path);
    source_.text += fmt::format("#ifndef PASTED_{0}\n#define PASTED_{0}\n#line 1 {0}\n", number);
    pasteLines(path, number, text());
    source_.text += "#endif\n";
    open_.pop_back();
  }

 private:
  std::size_t numberOf(const std::string& path) {
    const auto found = std::find(source_.files.begin(), source_.files.end(), path);
    if (found != source_.files.end()) return static_cast<std::size_t>(found - source_.files.begin());
    source_.files.push_back(path);
    certain_.push_back(false);
    return source_.files.size() - 1;
  }

  void pasteLines(const std::string& path, std::size_t number, const std::string& text) {
    std::istringstream lines(text);
    int lineNumber = 0;
    for (std::string line; std::getline(lines, line);) {
      ++lineNumber;
      constexpr std::string_view directive = "#include \"";
      if (!line.starts_with(directive)) {
        if (line.starts_with("#if")) ++conditions_;
        if (line.starts_with("#endif")) --conditions_;
        source_.text += line + '\n';
        continue;
      }
      const auto close = line.find('"', directive.size());
      const std::string here = fmt::format("{}:{}", path, lineNumber);
      if (close == std::string::npos) fail(ExitCode::device, "{}: the include has no closing quote", here);
      paste(line.substr(directive.size(), close - directive.size()), here);
      source_.text += fmt::format("#line {} {}\n", lineNumber + 1, number);
    }
  }

  ShaderSource& source_;
  std::vector<bool> certain_;  ///< for each file, true if a pasted copy is outside all conditions, so that
                               ///< it is always compiled
  std::vector<std::string> open_;  ///< files that are being pasted
  int conditions_ = 0;             ///< number of enclosing #if
};

bool partOfName(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

}  // namespace

bool mentions(std::string_view text, std::string_view name) {
  for (auto at = text.find(name); at != std::string_view::npos; at = text.find(name, at + name.size())) {
    const auto end = at + name.size();
    if ((at > 0 && partOfName(text[at - 1])) || (end < text.size() && partOfName(text[end]))) continue;
    const auto lineBegin = text.rfind('\n', at) + 1;  // 0 in the first line, where rfind() returns npos
    if (text.substr(lineBegin, at - lineBegin).find("//") == std::string_view::npos) return true;
  }
  return false;
}

namespace {

/// Returns only the defines that the files mention. The shader's text is the key of a driver's cache, so an
/// unused define would cause needless compilations.
Defines mentioned(const std::string& files, const Defines& defines) {
  Defines result;
  const auto matches = [](const std::string& name) {
    return [&name](const auto& define) { return mentions(define.second, name); };
  };
  for (const auto& define : defines)
    if (define.first != extensionDefine &&
        (mentions(files, define.first) || std::ranges::any_of(defines, matches(define.first))))
      result.push_back(define);
  return result;
}

/// Returns the source with the version line, extensions and defines at its start.
ShaderSource headed(ShaderSource source, const Defines& defines) {
  std::string head = "#version 450 core\n";
  for (const auto& [name, value] : defines)
    if (name == extensionDefine) head += fmt::format("#extension {} : require\n", value);
  // Macros for files that are also compiled as C++ (glsl/common/cpp.hpp).
  head += "#define FUNCTION\n#define STD140\n#define DEFAULT(value)\n";
  // A branch. Software drivers execute both sides of a branch, but skip a loop. NVIDIA's compiler takes up
  // to a minute for a kernel whose branches are loops.
  if (mentions(source.text, "IF_ANY"))
    head += softwareDriver()
                ? "#define IF_ANY(condition) for (int if_ = (condition) ? 0 : 1; if_ < 1; ++if_)\n"
                : "#define IF_ANY(condition) if (condition)\n";
  for (const auto& [name, value] : mentioned(source.text, defines))
    head += fmt::format("#define {} {}\n", name, value);
  source.text.insert(0, head);
  return source;
}

}  // namespace

std::string ShaderSource::explain(std::string_view log) const {
  std::string result;
  std::istringstream lines{std::string(log)};
  for (std::string line; std::getline(lines, line);) {
    std::size_t digits = 0;
    while (digits < line.size() && std::isdigit(static_cast<unsigned char>(line[digits])) != 0) ++digits;
    // Mesa writes "string:line(column): ", NVIDIA writes "string(line) : ".
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
  Paster(source).paste(path, "the program");
  return headed(std::move(source), defines);
}

ShaderSource loadShaderText(const std::string& name, const std::string& text, const Defines& defines) {
  ShaderSource source;
  Paster(source).pasteText(name, "the program", [&] { return text; });
  return headed(std::move(source), defines);
}

}  // namespace simreel::gl
