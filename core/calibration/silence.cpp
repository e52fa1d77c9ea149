#include "core/calibration/silence.hpp"

#include <openturns/Log.hxx>

namespace asperity {

Silence::Silence() : flags_(OT::Log::Flags()) { OT::Log::Show(OT::Log::NONE); }

Silence::~Silence() { OT::Log::Show(flags_); }

}  // namespace asperity
