#include "render/offscreen/gl_context.hpp"

#include <GL/gl.h>
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <string>

#include "core/base/error.hpp"

namespace asperity::render {
namespace {

constexpr int kBufferSide = 16;

using BlendFuncSeparate = void (*)(GLenum, GLenum, GLenum, GLenum);

/// With libGL before libOSMesa, VTK fails much later and with a message that misleads.
void require_osmesa_first() {
  Dl_info info{};
  void* clear = dlsym(RTLD_DEFAULT, "glClear");
  const bool known = clear && dladdr(clear, &info) && info.dli_fname;
  if (known && std::string(info.dli_fname).find("libOSMesa") != std::string::npos) return;
  throw Error(ErrorKind::unexpected, std::string("pictures need libOSMesa linked before VTK, but glClear comes from ") +
                                         (known ? info.dli_fname : "nowhere"));
}

void require_own_glx() {
  Dl_info shim{}, own{};
  void* found = dlsym(RTLD_DEFAULT, "glXGetProcAddressARB");
  const bool known = found && dladdr(found, &shim) && dladdr(reinterpret_cast<void*>(&require_osmesa_first), &own);
  if (known && shim.dli_fbase == own.dli_fbase) return;
  throw Error(ErrorKind::unexpected,
              "pictures need glXGetProcAddressARB of render/offscreen in the executable's dynamic symbol table");
}

void set_state_expected_by_vtk() {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_BLEND);
  const auto blend = reinterpret_cast<BlendFuncSeparate>(OSMesaGetProcAddress("glBlendFuncSeparate"));
  blend(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

}  // namespace

GlContext::GlContext() : buffer_(kBufferSide * kBufferSide * 4) {
  require_osmesa_first();
  require_own_glx();
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_STENCIL_BITS,
                            8,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            2,
                            0};
  context_ = OSMesaCreateContextAttribs(attributes, nullptr);
  if (!context_) throw Error(ErrorKind::unexpected, "libOSMesa could not make an OpenGL 3.2 context");
}

GlContext::~GlContext() {
  release();
  OSMesaDestroyContext(context_);
}

void GlContext::make_current() {
  if (!OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, kBufferSide, kBufferSide))
    throw Error(ErrorKind::unexpected, "libOSMesa could not make its OpenGL context current");
  set_state_expected_by_vtk();
}

void GlContext::release() { OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0); }

}  // namespace asperity::render
