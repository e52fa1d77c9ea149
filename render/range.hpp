#pragma once
#include <vector>

namespace asperity::render {

/// An interval of a quantity, in the quantity's unit.
struct Range {
  double low = 0, high = 1;
};

/// The interval of all finite values; [0, 0] if there is none.
Range range_of(const std::vector<double>& values);
Range united(Range a, Range b);
/// The interval with `margin` times its length added at both ends, and a little even if it is empty.
Range widened(Range range, double margin);
/// The interval with zero as an end if that lengthens it by no more than 35 %.
Range reaching_zero(Range range);
/// The interval with 4 % of its length added at both ends, but not beyond an end that is zero.
Range with_headroom(Range range);
/// The interval between the two percentiles (0 to 1) of the finite values; [0, 0] if there is none.
Range percentiles(std::vector<double> values, double low, double high);

/// A step of 1, 2 or 5 times a power of ten that divides `length` in about `parts` parts; length and parts above 0.
double round_step(double length, int parts);

}  // namespace asperity::render
