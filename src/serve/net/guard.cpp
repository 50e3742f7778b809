#include "serve/net/guard.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <cstring>
#include <sys/random.h>
#include <utility>

#include <fmt/format.h>

namespace simreel::serve {

namespace {

bool isAddress(const std::string& text, bool bracketed) {
  std::array<unsigned char, 16> bytes{};
  if (!bracketed) return ::inet_pton(AF_INET, text.c_str(), bytes.data()) == 1;
  return ::inet_pton(AF_INET6, text.c_str(), bytes.data()) == 1;
}

bool isPort(std::string_view text) {
  return !text.empty() && text.size() <= 5 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

std::string randomToken() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    fail(ExitCode::inputOutput, "the system gives no random numbers: {}", std::strerror(errno));
  std::string text;
  for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

Guard::Guard(std::string token, std::string address)
    : token_(std::move(token)), everywhere_(!address.starts_with("127.")) {}

bool Guard::allowsHost(std::string_view host) const {
  const bool bracketed = host.starts_with('[');
  std::string_view name = host;
  if (bracketed) {
    const std::size_t close = host.find(']');
    if (close == std::string_view::npos) return false;
    name = host.substr(1, close - 1);
    host.remove_prefix(close + 1);
  } else {
    name = host.substr(0, host.find(':'));
    host.remove_prefix(name.size());
  }
  // Any port is allowed, because a tunnel may use any port on the viewer's machine.
  if (!host.empty() && (host.front() != ':' || !isPort(host.substr(1)))) return false;
  if (name == "localhost" && !bracketed) return true;
  const std::string text(name);
  if (everywhere_) return isAddress(text, bracketed);
  return bracketed ? text == "::1" : text.starts_with("127.") && isAddress(text, false);
}

bool Guard::allowsOrigin(std::string_view origin, std::string_view host) {
  constexpr std::string_view scheme = "http://";
  return !host.empty() && origin.starts_with(scheme) && origin.substr(scheme.size()) == host;
}

bool Guard::splitPath(std::string_view path, std::string_view& rest) const {
  if (path.size() < token_.size() + 2 || path.front() != '/' || path[token_.size() + 1] != '/')
    return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < token_.size(); ++i)
    difference |= static_cast<unsigned>(static_cast<unsigned char>(path[i + 1]) ^
                                        static_cast<unsigned char>(token_[i]));
  rest = path.substr(token_.size() + 2);
  return difference == 0;
}

namespace {

/// Returns an address with which this machine can connect to the server.
std::string reachedAt(const std::string& address) {
  return address == "0.0.0.0" ? "127.0.0.1" : address;
}

}  // namespace

std::string pageAddress(const std::string& address, int port, const std::string& token) {
  return fmt::format("http://{}:{}/{}/", reachedAt(address), port, token);
}

std::string tunnelCommand(const std::string& address, int port, const std::string& machine) {
  return fmt::format("ssh -N -L {0}:{1}:{0} {2}", port, reachedAt(address), machine);
}

}  // namespace simreel::serve
