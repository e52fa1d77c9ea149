#include "core/measurement/curve.hpp"

#include "core/measurement/line_fit.hpp"

namespace asperity {

Curve select_rows(const Curve& curve, const std::vector<std::size_t>& rows) {
  const auto chosen = [&](const std::vector<double>& column) {
    return column.empty() ? std::vector<double>{} : gather(column, rows);
  };
  return {chosen(curve.path),
          chosen(curve.load),
          chosen(curve.gauge_strain),
          chosen(curve.lateral_strain),
          chosen(curve.dilation_mm),
          chosen(curve.dilation_front_mm),
          chosen(curve.dilation_rear_mm),
          chosen(curve.events)};
}

}  // namespace asperity
