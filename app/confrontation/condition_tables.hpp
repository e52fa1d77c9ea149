#pragma once
#include "app/confrontation/chapters.hpp"
#include "app/confrontation/confrontation_data.hpp"

namespace asperity::app {

/// Test by test: specimens, sizes, stress, the laboratory's rate beside the simulated one, particles, plane condition.
PlainTable conditions_table(const ConfrontationData& data);

/// Standard deviations of the instruments, a row for all tests that have them alike.
PlainTable instruments_table(const ConfrontationData& data);

/// What each compared feature is.
PlainTable features_table(const ConfrontationData& data);

}  // namespace asperity::app
