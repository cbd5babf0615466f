#include "sketch/sketch.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sketch/tracer.hpp"

namespace mien {

namespace {

constexpr int kTile = 4;               // the cloth of a lamp is sampled at 4 x 4 places, one a pixel
constexpr int kFineShadows = 4;        // places of a cloth for a ray that has no neighbours
constexpr int kLayers = 8;             // of things that let light through, one behind the other
constexpr float kEdge = 0.05f;         // difference of neighbours, as the eye sees it, that asks for finer rays
constexpr float kFaint = 0.004f;       // light that comes through less than this is not followed

// Where rays go within a pixel that is traced finer: no two in one row or column.
constexpr auto kFiner = std::to_array<std::array<float, 2>>(
    {{-0.375f, -0.125f}, {0.125f, -0.375f}, {0.375f, 0.125f}, {-0.125f, 0.375f}});

// The order in which the places of a cloth go to neighbouring pixels (Bayer's).
constexpr std::array<int, kTile * kTile> kOrder{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};

constexpr std::uint8_t kNotAsked = 2;

// One pixel of the first pass.
struct SketchPixel {
  SketchHit hit;
  glm::vec3 normal{0};
};

struct SketchPage {
  const SketchStage& stage;
  SketchTracer& tracer;
  PictureSize size;
  std::vector<SketchPixel> pixels;
  std::vector<std::vector<std::uint8_t>> hidden;  // of each lamp: 1 hidden, 0 seen, kNotAsked
  std::vector<glm::vec3> light;                   // linear

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width_px) + static_cast<std::size_t>(x);
  }
};

// Through a place of the picture, in pixels from its upper left corner.
SketchRay build_ray(const SketchPage& page, float x, float y) {
  const SketchCamera& camera = page.stage.camera;
  const float u = x / static_cast<float>(page.size.width_px) - 0.5f,
              v = 0.5f - y / static_cast<float>(page.size.height_px);
  if (camera.is_orthographic)
    return {camera.at + u * camera.right + v * camera.up, glm::normalize(camera.forward), 0};
  return {camera.at, glm::normalize(camera.forward + u * camera.right + v * camera.up), 0};
}

bool is_cloth(const SketchLamp& lamp) { return glm::dot(lamp.side, lamp.side) > 0; }

// One of kTile x kTile places of a cloth.
glm::vec3 find_lamp_place(const SketchLamp& lamp, int number) {
  const auto share = [](int i) { return (static_cast<float>(i) + 0.5f) / kTile - 0.5f; };
  return lamp.at + share(number % kTile) * lamp.side + share(number / kTile) * lamp.other_side;
}

// How much of each lamp a surface sees that is asked for alone; `turn` varies the places among neighbours.
void measure_visible(SketchPage& page, const SketchSurface& surface, int turn) {
  std::vector<float>& visible = page.tracer.visible;
  visible.assign(page.stage.lamps.size(), 1);
  for (std::size_t i = 0; i < visible.size(); ++i) {
    const SketchLamp& lamp = page.stage.lamps[i];
    if (!lamp.has_shadow || !faces_lamp(lamp, surface)) continue;
    if (!is_cloth(lamp)) {
      visible[i] = is_hidden(page.tracer, surface, lamp.at) ? 0.0f : 1.0f;
      continue;
    }
    int seen = 0;
    for (int k = 0; k < kFineShadows; ++k) {
      const int place = kOrder[static_cast<std::size_t>((turn + k * kTile) % (kTile * kTile))];
      seen += is_hidden(page.tracer, surface, find_lamp_place(lamp, place)) ? 0 : 1;
    }
    visible[i] = static_cast<float>(seen) / kFineShadows;
  }
}

// What a surface lets through of what lies behind it.
glm::vec3 find_through(const SketchSurface& surface) {
  return surface.colour.transmit + surface.colour.filter * surface.colour.rgb;
}

// What a wet surface mirrors: cards, else what lies behind the stage.
glm::vec3 find_mirrored(const SketchPage& page, const SketchSurface& surface, const SketchRay& ray) {
  if (surface.finish.reflection <= 0) return glm::vec3(0);
  const glm::vec3 direction = glm::reflect(ray.direction, surface.normal);
  return surface.finish.reflection * sample_cards(page.stage, surface.at, direction);
}

// All that a ray brings, however many clear things it passes.
glm::vec3 trace_ray(SketchPage& page, SketchRay ray, int turn) {
  constexpr float kBehind_mm = 0.001f;
  glm::vec3 sum(0), through(1);
  for (int layer = 0; layer < kLayers; ++layer) {
    const SketchHit hit = find_hit(page.tracer, ray);
    if (hit.part == SketchHit::kNone) return sum + through * sample_sky(page.stage, ray.direction);
    const SketchSurface surface = find_surface(page.tracer, ray, hit);
    measure_visible(page, surface, turn);
    sum += through * (light_surface(page.stage, surface, -ray.direction, page.tracer.visible) +
                      find_mirrored(page, surface, ray));
    through *= find_through(surface);
    if (std::max({through.r, through.g, through.b}) < kFaint) break;
    ray.near = hit.along_mm + kBehind_mm;
  }
  return sum;
}

// First pass: what each pixel meets.
void find_pixels(SketchPage& page) {
  constexpr int kWide = 4, kHigh = 2;
  std::array<SketchRay, kWide * kHigh> rays;
  std::array<SketchHit, kWide * kHigh> hits;
  for (int top = 0; top < page.size.height_px; top += kHigh)
    for (int left = 0; left < page.size.width_px; left += kWide) {
      for (int i = 0; i < kWide * kHigh; ++i)
        rays[static_cast<std::size_t>(i)] =
            build_ray(page, static_cast<float>(left + i % kWide) + 0.5f, static_cast<float>(top + i / kWide) + 0.5f);
      find_hits(page.tracer, rays.data(), hits.data());
      for (int i = 0; i < kWide * kHigh; ++i) {
        const int x = left + i % kWide, y = top + i / kWide;
        if (x >= page.size.width_px || y >= page.size.height_px) continue;
        page.pixels[page.index(x, y)].hit = hits[static_cast<std::size_t>(i)];
      }
    }
}

bool is_simple(const SketchPage& page, const SketchHit& hit) {
  return hit.part != SketchHit::kNone && !page.tracer.parts[hit.part].look->is_clear;
}

// Second pass: of each lamp one place is asked for, another one in each pixel of a tile.
void find_shadows(SketchPage& page) {
  page.hidden.resize(page.stage.lamps.size());
  for (auto& hidden : page.hidden) hidden.assign(page.pixels.size(), kNotAsked);
  for (int y = 0; y < page.size.height_px; ++y)
    for (int x = 0; x < page.size.width_px; ++x) {
      SketchPixel& pixel = page.pixels[page.index(x, y)];
      if (!is_simple(page, pixel.hit)) continue;
      const SketchRay ray = build_ray(page, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      SketchSurface surface = find_shape(page.tracer, ray, pixel.hit);
      if (glm::dot(surface.normal, ray.direction) > 0) surface.normal = -surface.normal;
      pixel.normal = surface.normal;
      const int place = kOrder[static_cast<std::size_t>((y % kTile) * kTile + x % kTile)];
      for (std::size_t i = 0; i < page.stage.lamps.size(); ++i) {
        const SketchLamp& lamp = page.stage.lamps[i];
        if (!lamp.has_shadow || !faces_lamp(lamp, surface)) continue;
        const glm::vec3 at = is_cloth(lamp) ? find_lamp_place(lamp, place) : lamp.at;
        page.hidden[i][page.index(x, y)] = is_hidden(page.tracer, surface, at) ? 1 : 0;
      }
    }
}

// How much of a lamp a pixel sees: the mean of its tile, as far as neighbours lie on the same surface.
float find_visible(const SketchPage& page, std::size_t lamp, int x, int y) {
  constexpr float kSameWay = 0.85f;  // cosine between normals
  constexpr float kSameDepth = 0.012f;
  const std::vector<std::uint8_t>& hidden = page.hidden[lamp];
  const std::size_t here = page.index(x, y);
  if (hidden[here] == kNotAsked) return 1;
  if (!is_cloth(page.stage.lamps[lamp])) return hidden[here] == 0 ? 1.0f : 0.0f;
  const SketchPixel& pixel = page.pixels[here];
  int seen = 0, all = 0;
  const int left = std::max(x - kTile / 2, 0), right = std::min(x + kTile / 2, page.size.width_px),
            top = std::max(y - kTile / 2, 0), bottom = std::min(y + kTile / 2, page.size.height_px);
  for (int ny = top; ny < bottom; ++ny)
    for (int nx = left; nx < right; ++nx) {
      const std::size_t there = page.index(nx, ny);
      const SketchPixel& other = page.pixels[there];
      if (hidden[there] == kNotAsked || glm::dot(other.normal, pixel.normal) < kSameWay ||
          std::abs(other.hit.along_mm - pixel.hit.along_mm) > kSameDepth * pixel.hit.along_mm)
        continue;
      ++all;
      seen += hidden[there] == 0 ? 1 : 0;
    }
  return static_cast<float>(seen) / static_cast<float>(all);
}

// Third pass: light.
void light_pixels(SketchPage& page) {
  std::vector<float>& visible = page.tracer.visible;
  for (int y = 0; y < page.size.height_px; ++y)
    for (int x = 0; x < page.size.width_px; ++x) {
      const SketchPixel& pixel = page.pixels[page.index(x, y)];
      const SketchRay ray = build_ray(page, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      glm::vec3& light = page.light[page.index(x, y)];
      if (pixel.hit.part == SketchHit::kNone) {
        light = sample_sky(page.stage, ray.direction);
        continue;
      }
      if (!is_simple(page, pixel.hit)) {
        light = trace_ray(page, ray, (y % kTile) * kTile + x % kTile);
        continue;
      }
      const SketchSurface surface = find_surface(page.tracer, ray, pixel.hit);
      visible.assign(page.stage.lamps.size(), 1);
      for (std::size_t i = 0; i < visible.size(); ++i)
        if (page.stage.lamps[i].has_shadow) visible[i] = find_visible(page, i, x, y);
      light = light_surface(page.stage, surface, -ray.direction, visible) + find_mirrored(page, surface, ray);
    }
}

// As the eye sees it, nearly.
glm::vec3 find_tone(const glm::vec3& light) { return glm::sqrt(glm::clamp(light, 0.0f, 1.0f)); }

// Fourth pass: pixels that differ from a neighbour are the mean of several rays.
void smooth_edges(SketchPage& page) {
  std::vector<glm::vec3> tones(page.light.size());
  std::ranges::transform(page.light, tones.begin(), find_tone);
  std::vector<std::uint8_t> is_edge(page.light.size(), 0);
  const auto compare = [&](std::size_t a, std::size_t b) {
    const glm::vec3 apart = glm::abs(tones[a] - tones[b]);
    if (std::max({apart.r, apart.g, apart.b}) > kEdge) is_edge[a] = is_edge[b] = 1;
  };
  for (int y = 0; y < page.size.height_px; ++y)
    for (int x = 0; x < page.size.width_px; ++x) {
      if (x + 1 < page.size.width_px) compare(page.index(x, y), page.index(x + 1, y));
      if (y + 1 < page.size.height_px) compare(page.index(x, y), page.index(x, y + 1));
    }
  for (int y = 0; y < page.size.height_px; ++y)
    for (int x = 0; x < page.size.width_px; ++x) {
      if (is_edge[page.index(x, y)] == 0) continue;
      glm::vec3 sum = glm::clamp(page.light[page.index(x, y)], 0.0f, 1.0f);
      int turn = (y % kTile) * kTile + x % kTile;
      for (const auto& [dx, dy] : kFiner) {
        const SketchRay ray =
            build_ray(page, static_cast<float>(x) + 0.5f + dx, static_cast<float>(y) + 0.5f + dy);
        sum += glm::clamp(trace_ray(page, ray, ++turn), 0.0f, 1.0f);
      }
      page.light[page.index(x, y)] = sum / static_cast<float>(kFiner.size() + 1);
    }
}

float encode_srgb(float value) {
  return value <= 0.0031308f ? 12.92f * value : 1.055f * std::pow(value, 1 / 2.4f) - 0.055f;
}

// Light of 0..1 as bytes, by table: fine enough that no byte is left out.
struct SrgbTable {
  static constexpr int kSteps = 16384;
  std::array<float, kSteps + 1> bytes;
  SrgbTable() {
    for (int i = 0; i <= kSteps; ++i)
      bytes[static_cast<std::size_t>(i)] = 255 * encode_srgb(static_cast<float>(i) / kSteps);
  }
};

// Rounded up or down by a pattern, so that a dark ground shows no bands.
void write_pixels(const SketchPage& page, Pixels& picture) {
  static const SrgbTable table;
  picture.size = page.size;
  picture.rgb.resize(3 * page.light.size());
  for (int y = 0; y < page.size.height_px; ++y)
    for (int x = 0; x < page.size.width_px; ++x) {
      const float up =
          (static_cast<float>(kOrder[static_cast<std::size_t>((y % kTile) * kTile + x % kTile)]) + 0.5f) /
          (kTile * kTile);
      const std::size_t at = page.index(x, y);
      for (int c = 0; c < 3; ++c) {
        const float light = std::clamp(page.light[at][c], 0.0f, 1.0f) * SrgbTable::kSteps;
        const float byte = table.bytes[static_cast<std::size_t>(light)];
        picture.rgb[3 * at + static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(std::min(byte + up, 255.0f));
      }
    }
}

}  // namespace

SketchDesk::SketchDesk() : tracer(std::make_unique<SketchTracer>()) {}
SketchDesk::SketchDesk(SketchDesk&&) noexcept = default;
SketchDesk& SketchDesk::operator=(SketchDesk&&) noexcept = default;
SketchDesk::~SketchDesk() = default;

Pixels trace_sketch(const SketchStage& stage, const std::vector<SketchFigure>& figures,
                    const PictureSize& size, SketchDesk& desk) {
  set_figures(*desk.tracer, figures);
  const std::size_t count =
      static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px);
  SketchPage page{stage, *desk.tracer, size, {}, {}, {}};
  page.pixels.resize(count);
  page.light.resize(count);
  find_pixels(page);
  find_shadows(page);
  light_pixels(page);
  smooth_edges(page);
  Pixels picture;
  write_pixels(page, picture);
  return picture;
}

}  // namespace mien
