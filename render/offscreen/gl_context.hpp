#pragma once
#include <vector>

struct osmesa_context;

namespace asperity::render {

/// A software OpenGL context (OSMesa, core profile) that needs no display and no environment variable. It must be made
/// before the first VTK window and outlive the last one. Errors: Error(unexpected) if libOSMesa was not linked before
/// VTK, or cannot make a context.
class GlContext {
 public:
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Makes it current on the calling thread, with the OpenGL state that VTK's generic window expects of its host.
  void make_current();
  /// Lets another thread make it current.
  void release();

 private:
  osmesa_context* context_ = nullptr;
  std::vector<unsigned char> buffer_;  ///< OSMesa wants one; VTK draws in framebuffers of its own.
};

}  // namespace asperity::render
