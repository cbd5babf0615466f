#include "sketch/sketch.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sketch/light.hpp"
#include "sketch/tracer.hpp"

namespace mien {

namespace {

constexpr int kTile = 4;         // the cloth of a lamp is sampled at 4 x 4 places, one a pixel
constexpr int kFineShadows = 4;  // places of a cloth for a ray that has no neighbours
constexpr int kLayers = 8;       // of things that let light through, one behind the other
// Difference of neighbours that asks for finer rays: of light, not of what the eye makes of it, else every
// dark hair asks for them.
constexpr float kEdge = 0.08f;
constexpr float kFaint = 0.004f;  // light that comes through less than this is not followed

// Where rays go within a pixel that is traced finer: no two in one row or column.
constexpr auto kFiner = std::to_array<std::array<float, 2>>(
    {{-0.375f, -0.125f}, {0.125f, -0.375f}, {0.375f, 0.125f}, {-0.125f, 0.375f}});

// The order in which the places of a cloth go to neighbouring pixels (Bayer's).
constexpr std::array<int, std::size_t{kTile} * kTile> kOrder{0, 8,  2, 10, 12, 4, 14, 6,
                                                             3, 11, 1, 9,  15, 7, 13, 5};

constexpr float kBehind_mm = 0.001f;  // a ray goes on so far behind what it met

constexpr std::uint8_t kNotAsked = 2;
constexpr glm::vec4 kUnknown{-1};

struct SketchPage {
  const SketchStage& stage;
  SketchTracer& tracer;
  std::vector<glm::vec4>& sky;
  PictureSize size;
  std::vector<SketchPixel>& pixels;
  std::vector<std::vector<std::uint8_t>>& hidden;
  std::vector<std::vector<float>>& visible;
  std::vector<glm::vec4>& light;

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width_px) +
           static_cast<std::size_t>(x);
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

// Through the middle of a pixel.
SketchRay build_pixel_ray(const SketchPage& page, int x, int y) {
  return build_ray(page, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
}

bool is_cloth(const SketchLamp& lamp) { return glm::dot(lamp.side, lamp.side) > 0; }

// One of kTile x kTile places of a cloth.
glm::vec3 find_lamp_place(const SketchLamp& lamp, int number) {
  const auto share = [](int i) { return (static_cast<float>(i) + 0.5f) / kTile - 0.5f; };
  return lamp.at + share(number % kTile) * lamp.side + share(number / kTile) * lamp.other_side;
}

bool is_clear(const SketchPage& page, const SketchHit& hit) {
  return page.tracer.parts[hit.part].look->is_clear;
}

// Whether a pixel shows the surface that was met beside it.
bool is_beside(const SketchPixel& pixel, const glm::vec3& normal, float along_mm) {
  constexpr float kSameWay = 0.85f;  // cosine between normals
  constexpr float kSameDepth = 0.012f;
  return pixel.base.part != SketchHit::kNone && glm::dot(pixel.normal, normal) > kSameWay &&
         std::abs(pixel.base.along_mm - along_mm) < kSameDepth * along_mm;
}

// The pixel at `near` or one beside it that shows the surface which a ray met; kNowhere if none does. A clear
// thing, such as a hair of the brow, sees of the lamps what lies close behind it sees.
constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
std::size_t find_beside(const SketchPage& page, const SketchSurface& surface, const SketchHit& hit,
                        std::size_t near) {
  constexpr float kClose = 0.005f;  // of the distance
  const SketchPixel& here = page.pixels[near];
  if (is_clear(page, hit) && here.base.part != SketchHit::kNone &&
      std::abs(here.base.along_mm - hit.along_mm) < kClose * hit.along_mm)
    return near;
  const auto width = static_cast<std::size_t>(page.size.width_px);
  for (const std::size_t other : {near, near - 1, near + 1, near - width, near + width})
    if (other < page.pixels.size() && is_beside(page.pixels[other], surface.normal, hit.along_mm))
      return other;
  return kNowhere;
}

// How much of each lamp a surface sees that a ray through the pixel at `near` met: what a pixel there sees of
// it if one shows the same surface, else what rays tell; `turn` varies their places among neighbours.
void measure_visible(SketchPage& page, const SketchSurface& surface, const SketchHit& hit, std::size_t near,
                     int turn) {
  std::vector<float>& visible = page.tracer.seen;
  visible.assign(page.stage.lamps.size(), 1);
  if (hit == page.pixels[near].base) {  // it is asked already
    for (std::size_t i = 0; i < visible.size(); ++i)
      if (page.stage.lamps[i].has_shadow) visible[i] = page.visible[i][near];
    return;
  }
  const std::size_t beside = find_beside(page, surface, hit, near);
  for (std::size_t i = 0; i < visible.size(); ++i) {
    const SketchLamp& lamp = page.stage.lamps[i];
    if (!lamp.has_shadow || !faces_lamp(lamp, surface)) continue;
    if (!is_cloth(lamp)) {
      visible[i] = is_hidden(page.tracer, surface, lamp.at) ? 0.0f : 1.0f;
      continue;
    }
    if (beside != kNowhere && page.hidden[i][beside] != kNotAsked) {
      visible[i] = page.visible[i][beside];
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

// Between the strands of a lock's tip there is nothing, and a strand is whole: what POV-Ray blends is one or
// the other here. Returns whether there is something.
bool is_there(const SketchPage& page, const SketchHit& hit, SketchSurface& surface) {
  const float clear = surface.colour.transmit;
  if (clear <= 0 || page.tracer.parts[hit.part].look->is_veil) return true;
  constexpr float kHalf = 0.5f;
  if (clear >= kHalf) return false;
  surface.colour.rgb /= 1 - clear;  // it was blended with black
  surface.colour.transmit = 0;
  return true;
}

// What a wet surface mirrors: cards, else what lies behind the stage.
glm::vec3 find_mirrored(const SketchPage& page, const SketchSurface& surface, const SketchRay& ray) {
  if (surface.finish.reflection <= 0) return glm::vec3(0);
  const glm::vec3 direction = glm::reflect(ray.direction, surface.normal);
  return surface.finish.reflection * sample_cards(page.stage, surface.at, direction);
}

// All that a ray through the pixel at `near` brings, `hit` first, however many clear things it passes.
glm::vec4 trace_ray(SketchPage& page, SketchRay ray, SketchHit hit, std::size_t near, int turn) {
  glm::vec3 sum(0), through(1);
  for (int layer = 0; layer < kLayers; ++layer) {
    if (hit.part == SketchHit::kNone) {
      const glm::vec4 sky = sample_sky(page.stage, ray.direction);
      const float clear = (through.r + through.g + through.b) / 3 * (1 - sky.a);
      return {sum + through * glm::vec3(sky), 1 - clear};
    }
    SketchSurface surface = find_surface(page.tracer, ray, hit);
    if (is_there(page, hit, surface)) {
      measure_visible(page, surface, hit, near, turn);
      sum += through * (light_surface(page.stage, surface, -ray.direction, page.tracer.seen) +
                        find_mirrored(page, surface, ray));
      through *= find_through(surface);
      if (std::max({through.r, through.g, through.b}) < kFaint) break;
    }
    ray.near = hit.along_mm + kBehind_mm;
    hit = find_hit(page.tracer, ray);
  }
  return {sum, 1};
}

// Pixels are met in tiles of kPacket.
constexpr int kWide = 4, kHigh = 4;

// Goes on from `hit` through what lets light through everywhere: a hair of the brow is not what a pixel
// shows, a lock of the head is, though its tip is clear.
void find_base(const SketchPage& page, SketchRay ray, SketchHit& hit) {
  const auto is_veil = [&] { return page.tracer.parts[hit.part].look->is_veil; };
  for (int layer = 0; layer < kLayers && hit.part != SketchHit::kNone && is_veil(); ++layer) {
    ray.near = hit.along_mm + kBehind_mm;
    hit = find_hit(page.tracer, ray);
  }
}

// First pass: what each pixel meets.
void find_pixels(SketchPage& page) {
  std::array<SketchRay, kPacket> rays;
  std::array<SketchHit, kPacket> hits;
  for (int top = 0; top < page.size.height_px; top += kHigh)
    for (int left = 0; left < page.size.width_px; left += kWide) {
      for (int i = 0; i < kWide * kHigh; ++i)
        rays[static_cast<std::size_t>(i)] = build_pixel_ray(page, left + i % kWide, top + i / kWide);
      find_hits(page.tracer, rays.data(), hits.data());
      for (int i = 0; i < kWide * kHigh; ++i) {
        const int x = left + i % kWide, y = top + i / kWide;
        if (x >= page.size.width_px || y >= page.size.height_px) continue;
        SketchPixel& pixel = page.pixels[page.index(x, y)];
        pixel.hit = pixel.base = hits[static_cast<std::size_t>(i)];
        find_base(page, rays[static_cast<std::size_t>(i)], pixel.base);
      }
    }
}

// Second pass: of each lamp one place is asked for, another one in each pixel of a tile.
void find_shadows(SketchPage& page) {
  const std::vector<SketchLamp>& lamps = page.stage.lamps;
  page.hidden.resize(lamps.size());
  page.visible.resize(lamps.size());
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    page.hidden[i].assign(lamps[i].has_shadow ? page.pixels.size() : 0, kNotAsked);
    page.visible[i].resize(page.hidden[i].size());
  }
  SketchShadows shadows;
  std::array<std::size_t, kPacket> index{};
  std::array<int, kPacket> place{};
  for (int top = 0; top < page.size.height_px; top += kHigh)
    for (int left = 0; left < page.size.width_px; left += kWide) {
      std::array<bool, kPacket> is_met{};
      for (std::size_t i = 0; i < kPacket; ++i) {
        const int x = left + static_cast<int>(i) % kWide, y = top + static_cast<int>(i) / kWide;
        if (x >= page.size.width_px || y >= page.size.height_px) continue;
        index[i] = page.index(x, y);
        SketchPixel& pixel = page.pixels[index[i]];
        if (pixel.base.part == SketchHit::kNone) continue;
        const SketchRay ray = build_pixel_ray(page, x, y);
        const SketchSurface surface = find_shape(page.tracer, ray, pixel.base);
        is_met[i] = true;
        pixel.normal = glm::dot(surface.normal, ray.direction) > 0 ? -surface.normal : surface.normal;
        shadows.at[i] = surface.at;
        shadows.normal[i] = pixel.normal;
        place[i] = kOrder[static_cast<std::size_t>((y % kTile) * kTile + x % kTile)];
      }
      for (std::size_t k = 0; k < lamps.size(); ++k) {
        if (!lamps[k].has_shadow) continue;
        bool is_any = false;
        for (std::size_t i = 0; i < kPacket; ++i) {
          shadows.is_asked[i] = is_met[i] && glm::dot(lamps[k].at - shadows.at[i], shadows.normal[i]) > 0;
          is_any |= shadows.is_asked[i];
          shadows.place[i] = is_cloth(lamps[k]) ? find_lamp_place(lamps[k], place[i]) : lamps[k].at;
        }
        if (!is_any) continue;
        find_hidden(page.tracer, shadows);
        for (std::size_t i = 0; i < kPacket; ++i)
          if (shadows.is_asked[i]) page.hidden[k][index[i]] = shadows.is_hidden[i] ? 1 : 0;
      }
    }
}

// How much of a lamp a pixel sees: the mean of its tile, as far as neighbours lie on the same surface.
float find_visible(const SketchPage& page, std::size_t lamp, int x, int y) {
  const std::vector<std::uint8_t>& hidden = page.hidden[lamp];
  const std::size_t here = page.index(x, y);
  if (hidden[here] == kNotAsked) return 1;
  if (!is_cloth(page.stage.lamps[lamp])) return hidden[here] == 0 ? 1.0f : 0.0f;
  const SketchPixel& pixel = page.pixels[here];
  const int left = std::max(x - kTile / 2, 0), right = std::min(x + kTile / 2, page.size.width_px),
            top = std::max(y - kTile / 2, 0), bottom = std::min(y + kTile / 2, page.size.height_px);
  bool is_all_alike = true;
  for (int ny = top; ny < bottom && is_all_alike; ++ny)
    for (int nx = left; nx < right; ++nx) is_all_alike &= hidden[page.index(nx, ny)] == hidden[here];
  if (is_all_alike) return hidden[here] == 0 ? 1.0f : 0.0f;
  int seen = 0, all = 0;
  for (int ny = top; ny < bottom; ++ny)
    for (int nx = left; nx < right; ++nx) {
      const std::size_t there = page.index(nx, ny);
      const SketchPixel& other = page.pixels[there];
      if (hidden[there] == kNotAsked || !is_beside(other, pixel.normal, pixel.base.along_mm)) continue;
      ++all;
      seen += hidden[there] == 0 ? 1 : 0;
    }
  return static_cast<float>(seen) / static_cast<float>(all);
}

// Third pass: light.
void light_pixels(SketchPage& page) {
  for (std::size_t i = 0; i < page.stage.lamps.size(); ++i) {
    if (!page.stage.lamps[i].has_shadow) continue;
    for (int y = 0; y < page.size.height_px; ++y)
      for (int x = 0; x < page.size.width_px; ++x)
        page.visible[i][page.index(x, y)] = find_visible(page, i, x, y);
  }
  for (int y = 0; y < page.size.height_px; ++y)
    for (int x = 0; x < page.size.width_px; ++x) {
      const std::size_t index = page.index(x, y);
      const SketchRay ray = build_pixel_ray(page, x, y);
      if (page.pixels[index].hit.part == SketchHit::kNone) {
        glm::vec4& sky = page.sky[index];
        if (sky == kUnknown) sky = sample_sky(page.stage, ray.direction);
        page.light[index] = sky;
        continue;
      }
      page.light[index] =
          trace_ray(page, ray, page.pixels[index].hit, index, (y % kTile) * kTile + x % kTile);
    }
}

// Fourth pass: pixels that differ from a neighbour are the mean of several rays.
void smooth_edges(SketchPage& page) {
  std::vector<std::uint8_t> is_edge(page.light.size(), 0);
  const auto compare = [&](std::size_t a, std::size_t b) {
    const glm::vec4 apart = glm::abs(glm::min(page.light[a], 1.0f) - glm::min(page.light[b], 1.0f));
    if (std::max({apart.r, apart.g, apart.b, apart.a}) > kEdge) is_edge[a] = is_edge[b] = 1;
  };
  for (int y = 0; y < page.size.height_px; ++y)
    for (int x = 0; x < page.size.width_px; ++x) {
      if (x + 1 < page.size.width_px) compare(page.index(x, y), page.index(x + 1, y));
      if (y + 1 < page.size.height_px) compare(page.index(x, y), page.index(x, y + 1));
    }
  std::vector<std::size_t> edges;
  for (std::size_t i = 0; i < is_edge.size(); ++i)
    if (is_edge[i] != 0) edges.push_back(i);
  constexpr std::size_t kAtOnce = kPacket / kFiner.size();
  std::array<SketchRay, kPacket> rays;
  std::array<SketchHit, kPacket> hits;
  for (std::size_t first = 0; first < edges.size(); first += kAtOnce) {
    const auto find_edge = [&](std::size_t ray) {
      return edges[std::min(first + ray / kFiner.size(), edges.size() - 1)];
    };
    const auto width = static_cast<std::size_t>(page.size.width_px);
    for (std::size_t i = 0; i < kPacket; ++i) {
      const auto& [dx, dy] = kFiner[i % kFiner.size()];
      const std::size_t edge = find_edge(i);
      const std::size_t x = edge % width, y = edge / width;
      rays[i] = build_ray(page, static_cast<float>(x) + 0.5f + dx, static_cast<float>(y) + 0.5f + dy);
    }
    find_hits(page.tracer, rays.data(), hits.data());
    for (std::size_t i = 0; i < kAtOnce && first + i < edges.size(); ++i) {
      const std::size_t edge = edges[first + i];
      glm::vec4 sum = glm::clamp(page.light[edge], 0.0f, 1.0f);
      for (std::size_t k = i * kFiner.size(); k < (i + 1) * kFiner.size(); ++k)
        sum += glm::clamp(trace_ray(page, rays[k], hits[k], edge, static_cast<int>(edge + k)), 0.0f, 1.0f);
      page.light[edge] = sum / static_cast<float>(kFiner.size() + 1);
    }
  }
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

// Rounded up or down by a pattern, so that a dark ground shows no bands. Where a pixel is transparent its
// colour is that of what covers it.
void write_pixels(const SketchPage& page, Pixels& picture) {
  static const SrgbTable table;
  picture.size = page.size;
  picture.rgb.resize(3 * page.light.size());
  const auto is_clear = [](const glm::vec4& light) { return light.a < 1; };
  if (std::ranges::any_of(page.light, is_clear)) picture.alpha.resize(page.light.size());
  for (int y = 0; y < page.size.height_px; ++y)
    for (int x = 0; x < page.size.width_px; ++x) {
      const float up =
          (static_cast<float>(kOrder[static_cast<std::size_t>((y % kTile) * kTile + x % kTile)]) + 0.5f) /
          (kTile * kTile);
      const std::size_t at = page.index(x, y);
      const float covered = page.light[at].a;
      if (!picture.alpha.empty()) picture.alpha[at] = static_cast<std::uint8_t>(std::lround(255 * covered));
      const float share = covered > 0 && covered < 1 ? 1 / covered : 1;
      for (int c = 0; c < 3; ++c) {
        const float light = std::clamp(share * page.light[at][c], 0.0f, 1.0f) * SrgbTable::kSteps;
        const float byte = table.bytes[static_cast<std::size_t>(light)];
        picture.rgb[3 * at + static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(std::min(byte + up, 255.0f));
      }
    }
}

}  // namespace

SketchDesk::SketchDesk() : tracer(std::make_unique<SketchTracer>()) {}
SketchDesk::SketchDesk(SketchDesk&&) noexcept = default;
SketchDesk& SketchDesk::operator=(SketchDesk&&) noexcept = default;
SketchDesk::~SketchDesk() = default;

void set_stage(SketchDesk& desk, SketchStage stage) {
  desk.stage = std::move(stage);
  desk.sky.clear();
}

Pixels trace_sketch(SketchDesk& desk, const std::vector<SketchFigure>& figures, const PictureSize& size) {
  set_figures(*desk.tracer, figures);
  const std::size_t count =
      static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px);
  if (desk.sky.size() != count) desk.sky.assign(count, kUnknown);
  SketchTracer& tracer = *desk.tracer;
  SketchPage page{desk.stage,    tracer,        desk.sky,       size,
                  tracer.pixels, tracer.hidden, tracer.visible, tracer.light};
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
