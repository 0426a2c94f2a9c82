// Looks at the pick area: a capture, the detection in it, and the calibration before the first.
#pragma once

#include <string>

#include <mixed_palletizing/BoxArray.h>
#include <mixed_palletizing/adapters/cell/executive_link.hpp>

namespace mixed_palletizing::cell {

/// What was seen, and the times it took.
struct CellLook {
  BoxArray seen;
  double capture_ms = 0.0;
  double detection_ms = 0.0;
};

class CellLooks {
 public:
  /// Up to `retries` further captures when one gave no usable cloud. The link must outlive this.
  CellLooks(CellLink& link, int retries) : link_(link), retries_(retries) {}

  /// Calibrates when the detector asks for it, once. Throws CellError when there is nothing to see.
  CellLook look();

 private:
  CellLook lookOnce(std::string& failure);
  void calibrate();

  CellLink& link_;
  int retries_ = 0;
  bool calibrated_ = false;
};

}  // namespace mixed_palletizing::cell
