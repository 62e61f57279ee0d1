#pragma once

namespace springcheck::dynamics {

/// The precision of the numbers that explicit steps are made in.
enum class Precision { double_precision, single_precision };

}  // namespace springcheck::dynamics
