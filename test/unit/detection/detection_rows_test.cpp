// The rows of the target table at a small number of scenes and half the resolution; run_experiments measures them in
// full.
#include <gtest/gtest.h>

#include <mixed_palletizing/experiments/detection_summary.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

namespace mixed_palletizing::detection {
namespace {

/// Bounds on one row; half the pixels make twice the error.
struct Row {
  const char* recipe;
  std::uint64_t scenes;
  double recall, precision;
  double position_mm, yaw_deg, side_rms_mm, height_mm;
};

void PrintTo(const Row& row, std::ostream* out) { *out << row.recipe; }

class DetectionRows : public testing::TestWithParam<Row> {};

TEST_P(DetectionRows, holdWithMargins) {
  const Row& row = GetParam();
  constexpr std::uint64_t kSeed = 4711;
  const auto recipe = simulation::loadRecipe(std::string(MIXED_PALLETIZING_SOURCE_DIR) + "/config/recipes/" +
                                             row.recipe + ".yaml");
  experiments::SceneSource source = experiments::recipeSource(recipe, kSeed);
  const auto full = source.scene;
  source.scene = [full](std::uint64_t index) {
    simulation::Scene scene = full(index);
    scene.camera.width_px /= 2;
    scene.camera.height_px /= 2;
    return scene;
  };
  experiments::MeasurementOptions options;
  options.base = experiments::BaseSource::kTruth;
  const auto summary = experiments::summarize(measureScenes(source, 0, row.scenes, options, 1));
  SCOPED_TRACE("seed 4711\n" + experiments::summaryText(summary));
  EXPECT_GE(summary.recall(), row.recall);
  EXPECT_GE(summary.precision(), row.precision);
  EXPECT_LE(summary.position_mm.mean, row.position_mm);
  EXPECT_LE(summary.yaw_deg.mean, row.yaw_deg);
  EXPECT_LE(summary.side_mm.rms, row.side_rms_mm);
  EXPECT_LE(summary.height_mm.mean, row.height_mm);
  EXPECT_EQ(summary.truncated_flagged, summary.truncated_found);
  EXPECT_EQ(summary.confident_wrong_sizes, 0u);
}

INSTANTIATE_TEST_SUITE_P(Recipes, DetectionRows,
                         testing::Values(Row{"separated_depth_noise", 3, 1.0, 1.0, 0.3, 0.05, 0.4, 0.1},
                                         Row{"separated_noise_x4", 3, 1.0, 1.0, 0.5, 0.05, 1.0, 0.3},
                                         Row{"separated_all_effects", 3, 1.0, 1.0, 0.5, 0.05, 0.7, 0.1},
                                         Row{"touching_equal", 4, 0.95, 0.97, 1.0, 0.1, 2.0, 0.2},
                                         Row{"touching_stepped", 4, 0.95, 0.97, 1.0, 0.1, 2.0, 0.2},
                                         Row{"banded", 3, 0.98, 0.98, 1.0, 0.1, 1.5, 0.1},
                                         Row{"hidden", 4, 0.95, 0.97, 2.0, 0.1, 2.0, 0.2},
                                         Row{"uneven", 3, 0.99, 0.99, 3.0, 0.1, 3.5, 0.5},
                                         Row{"truncated", 3, 0.9, 0.9, 1.0, 0.1, 2.0, 0.5},
                                         Row{"everything", 4, 0.85, 0.9, 3.0, 0.15, 5.0, 1.0}));

}  // namespace
}  // namespace mixed_palletizing::detection
