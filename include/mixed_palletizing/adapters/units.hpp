// The one place where metres become whole millimetres and back.
#pragma once

namespace mixed_palletizing::adapters {

constexpr double kMillimetersPerMeter = 1000.0;

/// Lengths up to this many metres can be converted: more is a unit mistake.
constexpr double kMaxLengthM = 1000.0;

/// Share of a millimetre that counts as noise of a decimal number: 0.3 m is 300 mm, although
/// 0.3 * 1000 may be a little more in floating point.
constexpr double kUnitNoiseMm = 1e-3;

/// True for a finite length that can be converted, of either sign.
bool isLength(double meters);

/// Whole millimetres that are not smaller than the length: sizes of boxes, gaps. All three throw
/// std::invalid_argument unless isLength(meters).
int millimetersUp(double meters);

/// Whole millimetres that are not larger than the length: sizes of pallets.
int millimetersDown(double meters);

/// Nearest whole millimetres: positions.
int millimetersNearest(double meters);

/// Metres of a length in millimetres.
inline double toMeters(double millimeters) { return millimeters / kMillimetersPerMeter; }

}  // namespace mixed_palletizing::adapters
