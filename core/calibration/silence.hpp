#pragma once
#include <cstddef>

namespace asperity {

/// While it lives OpenTURNS writes nothing to the terminal: what it says of its own defaults and of evaluations used up
/// is handled where it is called.
class Silence {
 public:
  Silence();
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  std::size_t flags_;
};

}  // namespace asperity
