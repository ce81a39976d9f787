#include "render/session.h"

#include "io/error.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>

namespace weft::render {
namespace {

[[noreturn]] void fail_display(const std::string& what) {
  throw io::UnavailableError(
      "pictures cannot be made (" + what +
      ") install a driver with EGL, for example apt-get install libegl1 libgl1-mesa-dri, or write "
      "obj, ply or pc2");
}

/// A display of this platform, initialised; null when there is none.
EGLDisplay display_of(EGLenum platform, void* native) {
  EGLDisplay display = eglGetPlatformDisplayEXT(platform, native, nullptr);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return EGL_NO_DISPLAY;
  return display;
}

/// The first of the machine's EGL devices that works: NVIDIA's driver has no surfaceless platform.
EGLDisplay device_display() {
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (!eglQueryDevicesEXT(EGLint(devices.size()), devices.data(), &count)) return EGL_NO_DISPLAY;
  for (EGLint i = 0; i < count; ++i) {
    const EGLDisplay display = display_of(EGL_PLATFORM_DEVICE_EXT, devices[size_t(i)]);
    if (display != EGL_NO_DISPLAY) return display;
  }
  return EGL_NO_DISPLAY;
}

bool client_has(const char* extension) {
  return epoxy_has_egl_extension(EGL_NO_DISPLAY, extension);
}

EGLDisplay open_display() {
  EGLDisplay display = EGL_NO_DISPLAY;
  if (!client_has("EGL_EXT_platform_base")) return display;
  if (client_has("EGL_MESA_platform_surfaceless")) {
    display = display_of(EGL_PLATFORM_SURFACELESS_MESA, nullptr);
  }
  const bool devices =
      client_has("EGL_EXT_platform_device") &&
      (client_has("EGL_EXT_device_enumeration") || client_has("EGL_EXT_device_base"));
  if (display == EGL_NO_DISPLAY && devices) display = device_display();
  return display;
}

EGLContext make_context(EGLDisplay display) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                           EGL_NONE};
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) return EGL_NO_CONTEXT;
  return eglCreateContext(display, config, EGL_NO_CONTEXT, version);
}

}  // namespace

Session::Session() {
  // Without the library the first call of EGL would end the program.
  if (!epoxy_has_egl()) fail_display("there is no libEGL on this machine");
  display_ = open_display();
  if (display_ == EGL_NO_DISPLAY) fail_display("EGL has no display that works without a screen");
  context_ = make_context(display_);
  if (context_ == EGL_NO_CONTEXT) {
    eglTerminate(display_);
    fail_display("the driver has no OpenGL 3.3");
  }
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
    fail_display("the driver needs a window");
  }
  renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

Session::~Session() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

}  // namespace weft::render
