#pragma once
#include "serve/net/guard.hpp"
#include "serve/net/hub.hpp"

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace simreel::serve {

/// What a path below the token leads to.
struct Content {
  std::string type;  ///< media type
  std::shared_ptr<const std::string> bytes;
};

/// HTTP and WebSocket on one port, on a thread of its own: files by name, and "live", where viewers hear
/// what the hub has for them and say what they want. Each request must have the token in its path and a
/// Host that is this machine's, each WebSocket this page's Origin.
class Server {
 public:
  struct Options {
    std::string address = "127.0.0.1";
    int port = 0;  ///< 0: any that is free
    /// Null: there is no such thing. Called on the server's thread; must not throw.
    std::function<std::unique_ptr<Content>(std::string_view name)> find;
  };
  static constexpr int mostConnections = 1000;
  static constexpr int mostViewers = 64;
  static constexpr std::size_t mostBytesAsked = std::size_t{64} << 10;  ///< of one message of a viewer

  /// Listens. Throws UserError(inputOutput) where it cannot.
  Server(Options options, const Guard& guard, Hub& hub);
  /// Stops the hub.
  ~Server();
  Server(Server&&) = delete;
  Server(const Server&) = delete;
  Server& operator=(Server&&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] int port() const;

  struct State;  ///< what the library's callbacks know

 private:
  std::unique_ptr<State> state_;
};

}  // namespace simreel::serve
