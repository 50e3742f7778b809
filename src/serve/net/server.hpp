#pragma once
#include "serve/net/guard.hpp"
#include "serve/net/hub.hpp"

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace simreel::serve {

/// Response for a name below the token in the path.
struct Content {
  std::string type;  ///< media type, such as "text/css"
  std::shared_ptr<const std::string> bytes;
};

/// HTTP and WebSocket server on one port, with its own thread. HTTP delivers files by name. The WebSocket
/// "live" sends the hub's messages to viewers and receives their requests. Every request must have the
/// token in its path and a Host header that names this machine. A WebSocket must also have the page's
/// Origin.
class Server {
 public:
  struct Options {
    std::string address = "127.0.0.1";
    int port = 0;        ///< TCP port; 0 to use any free port
    bool embed = false;  ///< true if other pages may show the page in a frame; false: browsers refuse it
    /// Returns the content for a name, or null if the name is unknown. Called on the server's thread. Must
    /// not throw.
    std::function<std::unique_ptr<Content>(std::string_view name)> find;
  };
  static constexpr int maxConnections = 1000;
  static constexpr int maxViewers = 64;
  /// Max size in bytes of one message from a viewer.
  static constexpr std::size_t maxBytesAsked = std::size_t{64} << 10;

  /// Starts to listen. Throws UserError(inputOutput) on failure.
  Server(Options options, const Guard& guard, Hub& hub);
  /// Stops the server and the hub.
  ~Server();
  Server(Server&&) = delete;
  Server(const Server&) = delete;
  Server& operator=(Server&&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] int port() const;

  struct State;  ///< members that the callbacks of libwebsockets use

 private:
  std::unique_ptr<State> state_;
};

}  // namespace simreel::serve
