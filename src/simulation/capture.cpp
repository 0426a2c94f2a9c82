// Thesis, appendix A, as ray casting: the objects are moved into the camera's frame (step 1), and the ray of every
// pixel finds the nearest of them (steps 2 to 4: projection, depth map, merge with occlusion).
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/pinhole.hpp>

#include "drawn_objects.hpp"
#include "parallel_rows.hpp"
#include "sensor.hpp"
#include "visibility.hpp"

namespace mixed_palletizing::simulation {
namespace {

/// Share of the light that comes from everywhere, from a lamp above, and from beside the camera.
constexpr double kAmbientLight = 0.35;
constexpr double kLampLight = 0.35;
constexpr double kCameraLight = 0.3;
const Eigen::Vector3d kTowardsLamp(0.35, -0.25, 0.9);  // in the world, of about unit length

constexpr std::uint32_t kBackground = 0x202020;

float luma(const Eigen::Vector3f& rgb) {
  return (0.299f * rgb.x() + 0.587f * rgb.y() + 0.114f * rgb.z()) / 255.0f;
}

std::uint32_t pack(const Eigen::Vector3f& rgb) {
  const auto byte = [](float value) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0f, 255.0f)));
  };
  return byte(rgb.x()) << 16 | byte(rgb.y()) << 8 | byte(rgb.z());
}

/// Casts the camera's rays.
class Renderer {
 public:
  explicit Renderer(const Scene& scene)
      : drawn_(drawnObjects(scene)),
        rays_(drawn_.meshes),
        pinhole_(scene.camera),
        projector_(scene.camera.projector_m),
        towards_lamp_(scene.camera.world_from_camera.linear().transpose() * kTowardsLamp) {}

  /// Samples of a whole row of the image.
  void renderRow(int row, int width, Sample* out) const {
    for (int first = 0; first < width; first += kPacketSize) {
      RayDirections rays;
      for (int i = 0; i < kPacketSize; ++i) {
        rays[static_cast<std::size_t>(i)] = pinhole_.ray(std::min(first + i, width - 1), row);
      }
      const RayHits hits = rays_.trace(rays);
      const RayFlags lit = areLit(hits, rays);
      const auto count = static_cast<std::size_t>(std::min(kPacketSize, width - first));
      for (std::size_t i = 0; i < count; ++i) *out++ = sample(hits[i], rays[i], lit[i]);
    }
  }

 private:
  Sample sample(const RayHit& hit, const Eigen::Vector3d& ray, bool is_lit) const {
    Sample sample;
    sample.rgb = kBackground;
    if (hit.object < 0) return sample;
    const Eigen::Vector3f albedo = drawn_.paints[static_cast<std::size_t>(hit.object)]->albedo(hit, ray);
    const double cosine = std::abs(hit.normal.dot(ray)) / ray.norm();
    sample.object = hit.object;
    sample.face = hit.face;
    sample.depth_m = hit.depth_m;
    sample.luma = luma(albedo);
    sample.cosine = static_cast<float>(cosine);
    sample.is_lit = is_lit;
    sample.rgb = pack(albedo * static_cast<float>(light(hit, cosine)));
    return sample;
  }

  double light(const RayHit& hit, double cosine) const {
    const double to_lamp = std::max(0.0, hit.normal.dot(towards_lamp_));
    return kAmbientLight + kLampLight * to_lamp + kCameraLight * cosine;
  }

  RayFlags areLit(const RayHits& hits, const RayDirections& rays) const {
    RayFlags lit;
    lit.fill(true);
    if (!projector_) return lit;
    RayDirections points;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      points[i] = hits[i].depth_m * rays[i];
      lit[i] = hits[i].object >= 0 && hits[i].normal.dot(*projector_ - points[i]) > 0.0;
    }
    const RayFlags blocked = rays_.areBlocked(points, lit, *projector_);
    for (std::size_t i = 0; i < hits.size(); ++i) lit[i] = lit[i] && !blocked[i];
    return lit;
  }

  DrawnObjects drawn_;
  RayScene rays_;
  Pinhole pinhole_;
  std::optional<Eigen::Vector3d> projector_;
  Eigen::Vector3d towards_lamp_;
};

/// Mask and visible pixels of boxes and objects; pixels of the boxes' tops.
std::vector<std::uint64_t> describeMask(const Scene& scene, const std::vector<Sample>& samples,
                                        Capture& capture) {
  const std::size_t boxes = scene.boxes.size();
  std::vector<std::uint64_t> top_pixels(boxes, 0);
  capture.mask.assign(samples.size(), 0);
  capture.visible_pixels.assign(boxes, 0);
  capture.object_visible_pixels.assign(scene.objects.size(), 0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].object < 1) continue;
    const auto thing = static_cast<std::size_t>(samples[i].object - 1);
    if (thing >= boxes + scene.objects.size()) continue;  // a surface
    capture.mask[i] = static_cast<std::uint16_t>(thing + 1);
    if (thing >= boxes) {
      ++capture.object_visible_pixels[thing - boxes];
      continue;
    }
    ++capture.visible_pixels[thing];
    if (samples[i].face == static_cast<std::uint8_t>(BoxFace::kTop)) ++top_pixels[thing];
  }
  return top_pixels;
}

void describeTops(const Scene& scene, const std::vector<std::uint64_t>& top_pixels, Capture& capture) {
  const Pinhole pinhole(scene.camera);
  const geometry::Pose camera_from_world = scene.camera.world_from_camera.inverse();
  for (std::size_t box = 0; box < scene.boxes.size(); ++box) {
    const std::uint64_t alone = projectedPixels(topCorners(scene.boxes[box], camera_from_world), pinhole);
    const double seen = alone == 0 ? 0.0 : static_cast<double>(top_pixels[box]) / static_cast<double>(alone);
    capture.top_visibility.push_back(std::min(1.0, seen));
  }
}

void checkArguments(const Scene& scene, int threads) {
  std::string text;
  for (const std::string& problem : problems(scene)) text += (text.empty() ? "" : "\n") + problem;
  if (!text.empty()) throw std::invalid_argument("capture: the scene is broken:\n" + text);
  if (threads < 1) {
    throw std::invalid_argument("capture: threads = " + std::to_string(threads) + ", at least 1 needed");
  }
}

}  // namespace

Capture capture(const Scene& scene, std::uint64_t seed, int threads) {
  checkArguments(scene, threads);
  const int width = scene.camera.width_px;
  const int height = scene.camera.height_px;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);

  const Renderer renderer(scene);
  std::vector<Sample> samples(pixels);
  forEachRow(height, threads, [&](int row) {
    renderer.renderRow(row, width, &samples[static_cast<std::size_t>(row) * static_cast<std::size_t>(width)]);
  });

  Capture capture;
  capture.cloud.width = width;
  capture.cloud.height = height;
  capture.cloud.points.resize(pixels);
  const Sensor sensor(scene.noise, width, height, seed);
  const Pinhole pinhole(scene.camera);
  forEachRow(height, threads, [&](int row) {
    const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(width);
    for (int col = 0; col < width; ++col) {
      geometry::ColoredPoint& point = capture.cloud.points[first + static_cast<std::size_t>(col)];
      point.rgba = 0xff000000u | samples[first + static_cast<std::size_t>(col)].rgb;
      const double depth = sensor.measuredDepth(samples, row, col);
      if (!std::isfinite(depth)) continue;
      const Eigen::Vector3f measured = (depth * pinhole.ray(col, row)).cast<float>();
      point.x = measured.x();
      point.y = measured.y();
      point.z = measured.z();
    }
  });
  describeTops(scene, describeMask(scene, samples, capture), capture);
  return capture;
}

}  // namespace mixed_palletizing::simulation
