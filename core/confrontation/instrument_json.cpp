#include "core/confrontation/instrument_json.hpp"

namespace asperity {

nlohmann::ordered_json instrument_json(const Instrument& i) {
  return {{"load_noise_percent", i.load_noise_percent},
          {"displacement_noise_percent", i.displacement_noise_percent},
          {"transverse_noise_percent", i.transverse_noise_percent},
          {"load_scale_percent", i.load_scale_percent},
          {"displacement_scale_percent", i.displacement_scale_percent},
          {"load_zero_percent", i.load_zero_percent},
          {"displacement_zero_mm", i.displacement_zero_mm}};
}

}  // namespace asperity
