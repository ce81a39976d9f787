// OpenGL without a window.
#pragma once

#include <string>

namespace weft::render {

/// An OpenGL 3.3 core context that is current on this thread while the session lives.
/// UnavailableError where there is none. A software renderer is enough.
class Session {
 public:
  Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();

  const std::string& renderer() const { return renderer_; }  ///< as the driver calls itself

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
  std::string renderer_;
};

}  // namespace weft::render
