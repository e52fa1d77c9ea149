// Debian's libGLEW asks GLX where the OpenGL functions are. These four definitions stand in the executable, so the
// dynamic linker finds them before libGLX's, and answer with libOSMesa's functions: no X server is ever asked.
#include <GL/osmesa.h>

#include <cstring>

#define ASPERITY_EXPORT extern "C" __attribute__((visibility("default"), used))

namespace {
int display_stand_in;
}

ASPERITY_EXPORT void* glXGetCurrentDisplay() { return OSMesaGetCurrentContext() ? &display_stand_in : nullptr; }

ASPERITY_EXPORT int glXQueryVersion(void* /*display*/, int* major, int* minor) {
  if (major) *major = 1;
  if (minor) *minor = 4;
  return 1;
}

ASPERITY_EXPORT const char* glXGetClientString(void* /*display*/, int /*name*/) { return ""; }

/// OSMesa answers a non-null address for any name at all, so the GLX names are turned away here.
ASPERITY_EXPORT OSMESAproc glXGetProcAddressARB(const unsigned char* name) {
  const char* text = reinterpret_cast<const char*>(name);
  if (std::strcmp(text, "glXGetCurrentDisplay") == 0) return reinterpret_cast<OSMESAproc>(&glXGetCurrentDisplay);
  if (std::strncmp(text, "glX", 3) == 0) return nullptr;
  return OSMesaGetProcAddress(text);
}

ASPERITY_EXPORT OSMESAproc glXGetProcAddress(const unsigned char* name) { return glXGetProcAddressARB(name); }
