// What a recipe draws: the view, the sensor, boxes and how they stand together.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace mixed_palletizing::simulation {

/// Interval that a number is drawn from evenly, its ends included.
struct Range {
  double min = 0.0;
  double max = 0.0;
  bool contains(double value) const { return value >= min && value <= max; }
};

struct CountRange {
  int min = 1;
  int max = 1;
};

/// Where the camera stands: it looks at a point near the marker (without one: near the origin).
struct RecipeView {
  Range distance_m{1.3, 1.7};  ///< to the point on the floor it looks at
  Range tilt_rad{0.0, 0.7};    ///< of the optical axis against straight down
  Range azimuth_rad{-3.1415926535897931,
                    3.1415926535897931};  ///< from that point to the camera, against world x
  Range target_offset_m{0.0, 0.15};       ///< from the marker's centre to that point
  double border_px_ratio = 0.01;          ///< boxes and marker keep this share of the width from the border
  bool marker_in_sight = true;            ///< the whole marker is in the image, nothing stands before it
};

/// Values drawn for every scene in place of those of the scene's own noise and floor.
struct RecipeSensor {
  std::optional<Range> depth_stddev_at_1m_m;
  std::optional<Range> dropout_ratio;
  std::optional<Range> flying_pixel_ratio;
  std::vector<std::uint32_t> floor_rgb;  ///< one of them; empty: the scene's
};

/// Shape and place of a single box.
struct RecipeBoxes {
  Range size_x_m{0.12, 0.30};
  Range size_y_m{0.10, 0.22};
  Range size_z_m{0.06, 0.25};
  Range yaw_rad{-1.5707963267948966, 1.5707963267948966};
  std::optional<Range> x_m;  ///< of the centre in the world; absent: anywhere in the image
  std::optional<Range> y_m;
  double gap_m = 0.04;  ///< least distance between the footprints of groups, and to the marker's paper
};

/// What is printed on boxes.
struct RecipePaint {
  std::vector<std::uint32_t> carton_rgb{0xb08a5a, 0xc19a6b, 0x9c7a4d, 0xa9825a, 0xd0c8b8, 0x8d6b3f};
  CountRange labels{0, 0};  ///< rectangles on the top of each box
  Range label_size_m{0.03, 0.08};
  std::vector<std::uint32_t> label_rgb{0xf0f0e8, 0x7a2020, 0x204080};
  double band_ratio = 0.0;  ///< share of the boxes with a band across the top and down two sides
  Range band_width_m{0.02, 0.06};
  std::vector<std::uint32_t> band_rgb{0x181818};
};

/// How boxes depart from cuboids; not at all by default.
struct RecipeShape {
  double bulge_ratio = 0.0;  ///< share of the boxes with a bulging (or, below 0, sagging) top
  Range bulge_m{-0.008, 0.008};
  double rounding_ratio = 0.0;  ///< with rounded edges
  Range rounding_m{0.002, 0.008};
  CountRange dents{0, 0};  ///< of each box
  Range dent_radius_m{0.01, 0.04};
  Range dent_depth_m{0.003, 0.012};
  double flap_ratio = 0.0;  ///< with an open flap
  Range flap_length_m{0.04, 0.08};
  Range flap_angle_rad{2.2689280275926285, 2.8797932657906435};  ///< 0 lies on the top, pi is level outwards
};

enum class Arrangement : std::uint8_t {
  kApart,     ///< one box
  kTouching,  ///< boxes face to face
  kHidden,    ///< a box and a taller one that hides a part of its top
  kCut,       ///< one box partly outside the image
  kStack,     ///< layers of boxes
};

/// Boxes that are placed together.
struct RecipeGroup {
  Arrangement arrangement = Arrangement::kApart;
  CountRange count{1, 5};          ///< groups of this kind in a scene
  Range top_visibility{0.0, 1.0};  ///< measurable share of every top of the group, see docs/datasets.md
  CountRange boxes{2, 3};          ///< touching: boxes of a group
  Range gap_m{0.0, 0.002};         ///< touching, hidden, stack: between faces
  Range contact_ratio{0.4, 1.0};   ///< touching: share of the shorter of two faces that stand face to face
  Range height_step_m{0.0, 0.0};  ///< touching: up or down to the first box's height; hidden: how much taller
  Range bearing_rad{-0.6, 0.6};   ///< hidden: of the taller box against the direction to the camera
  Range length_x_m{0.4, 0.6};     ///< stack: footprint
  Range length_y_m{0.3, 0.4};
  CountRange layers{2, 4};
  Range pallet_height_m{0.0, 0.0};  ///< stack: of a slab with its footprint below it; 0: none
  Range fill_ratio{0.3, 0.9};       ///< stack: share of the top layer's places that are taken
};

}  // namespace mixed_palletizing::simulation
