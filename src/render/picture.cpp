// PNG (Portable Network Graphics) Specification, W3C, second edition: a signature, then chunks of length,
// type, data and a CRC of type and data. Pixels are decoded by libpng.
#include "render/picture.hpp"

#include <fmt/format.h>
#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
constexpr std::string_view kKeyword("mien-key\0", 9);  // a tEXt chunk: keyword, zero, text

struct Chunk {
  std::string_view type, data;
};

struct Chunks {
  std::vector<Chunk> list;
  std::string fault;  // why the file is not a whole PNG; empty if it is
};

std::uint32_t read_number(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes.substr(0, 4)) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

void append_be32(std::string& bytes, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(value >> shift & 0xff);
}

std::uint32_t compute_crc(std::string_view type_and_data) {
  const auto* bytes = reinterpret_cast<const Bytef*>(type_and_data.data());
  return static_cast<std::uint32_t>(::crc32(0, bytes, static_cast<uInt>(type_and_data.size())));
}

Chunks find_chunks(std::string_view png) {
  Chunks chunks;
  if (!png.starts_with(kSignature)) return {{}, png.empty() ? "the file is empty" : "it is not a PNG"};
  png.remove_prefix(kSignature.size());
  while (chunks.list.empty() || chunks.list.back().type != "IEND") {
    constexpr std::size_t kAround = 12;  // length, type and CRC
    if (png.size() < kAround || png.size() - kAround < read_number(png)) return {{}, "the file is cut short"};
    const std::uint32_t length = read_number(png);
    if (compute_crc(png.substr(4, length + 4)) != read_number(png.substr(8 + length)))
      return {{}, "its bytes are damaged"};
    chunks.list.push_back({png.substr(4, 4), png.substr(8, length)});
    png.remove_prefix(kAround + length);
  }
  if (!png.empty()) return {{}, "something follows its end"};
  if (chunks.list.front().type != "IHDR" || chunks.list.front().data.size() != 13)
    return {{}, "it has no header"};
  return chunks;
}

PictureSize read_size(const Chunks& chunks) {
  const std::string_view header = chunks.list.front().data;
  return {static_cast<int>(read_number(header)), static_cast<int>(read_number(header.substr(4)))};
}

// Its header's colour type: with an alpha channel.
bool says_alpha(const Chunks& chunks) {
  return (static_cast<unsigned char>(chunks.list.front().data[9]) & PNG_COLOR_MASK_ALPHA) != 0;
}

struct Decoded {
  std::vector<png_byte> bytes;
  std::string fault;
};

// `format` is libpng's: PNG_FORMAT_RGBA, ...
Decoded decode_picture(std::string_view png, png_uint_32 format = PNG_FORMAT_RGBA) {
  Decoded decoded;
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, png.data(), png.size()) != 0) {
    image.format = format;
    decoded.bytes.resize(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, decoded.bytes.data(), 0, nullptr) != 0) return decoded;
  }
  decoded.fault = image.message;
  png_image_free(&image);
  return decoded;
}

bool is_one_colour(const std::vector<png_byte>& rgba) {
  // Equal to itself shifted by one pixel.
  return std::equal(rgba.begin() + 4, rgba.end(), rgba.begin());
}

[[noreturn]] void fail_picture(const std::filesystem::path& picture, const std::string& fault) {
  throw RunError(fmt::format("{} is not a whole PNG picture: {}", picture.string(), fault));
}

void append_chunk(std::string& png, std::string_view type, std::string_view data) {
  append_be32(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = png.size();
  png += type;
  png += data;
  append_be32(png, compute_crc(std::string_view(png).substr(start)));
}

}  // namespace

std::string find_picture_fault(std::string_view png, const PictureSize& expected) {
  const Chunks chunks = find_chunks(png);
  if (!chunks.fault.empty()) return "does not decode: " + chunks.fault;
  const auto [width_px, height_px] = read_size(chunks);
  if (width_px != expected.width_px || height_px != expected.height_px)
    return fmt::format("is {}x{} pixels, not {}x{}", width_px, height_px, expected.width_px,
                       expected.height_px);
  const Decoded decoded = decode_picture(png);
  if (!decoded.fault.empty()) return "does not decode: " + decoded.fault;
  return is_one_colour(decoded.bytes) ? "is all one colour" : "";
}

std::string mark_picture(std::string_view png, std::string_view key) {
  const Chunks chunks = find_chunks(png);
  if (!chunks.fault.empty()) throw RunError("cannot mark a picture: " + chunks.fault);
  static const std::set<std::string_view> kLeftOut{"tIME", "tEXt", "zTXt", "iTXt"};
  std::string marked(kSignature);
  for (const Chunk& chunk : chunks.list) {
    if (!kLeftOut.contains(chunk.type)) append_chunk(marked, chunk.type, chunk.data);
    if (chunk.type == "IHDR") append_chunk(marked, "tEXt", std::string(kKeyword).append(key));
  }
  return marked;
}

std::string read_picture_key(const std::filesystem::path& picture) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(picture, ignored)) return "";
  const std::string png = read_file(picture);
  const Chunks chunks = find_chunks(png);
  if (!chunks.fault.empty() || !decode_picture(png).fault.empty()) return "";
  for (const Chunk& chunk : chunks.list)
    if (chunk.type == "tEXt" && chunk.data.starts_with(kKeyword))
      return std::string(chunk.data.substr(kKeyword.size()));
  return "";
}

Pixels make_pixels(const PictureSize& size) {
  const std::size_t count =
      static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px);
  return {size, std::vector<std::uint8_t>(3 * count, 0)};
}

PictureSize read_picture_size(const std::filesystem::path& picture) {
  const std::string png = read_file(picture);
  const Chunks chunks = find_chunks(png);
  if (!chunks.fault.empty()) fail_picture(picture, chunks.fault);
  return read_size(chunks);
}

Pixels read_pixels(const std::filesystem::path& picture) {
  const std::string png = read_file(picture);
  const Chunks chunks = find_chunks(png);
  if (!chunks.fault.empty()) fail_picture(picture, chunks.fault);
  const bool is_clear = says_alpha(chunks);
  Decoded decoded = decode_picture(png, is_clear ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB);
  if (!decoded.fault.empty()) fail_picture(picture, decoded.fault);
  if (!is_clear) return {read_size(chunks), std::move(decoded.bytes)};
  Pixels pixels{read_size(chunks), {}, {}};
  for (std::size_t i = 0; i < decoded.bytes.size(); i += 4) {
    pixels.rgb.insert(pixels.rgb.end(), &decoded.bytes[i], &decoded.bytes[i] + 3);
    pixels.alpha.push_back(decoded.bytes[i + 3]);
  }
  return pixels;
}

bool has_alpha(const std::filesystem::path& picture) {
  const std::string png = read_file(picture);
  const Chunks chunks = find_chunks(png);
  if (!chunks.fault.empty()) fail_picture(picture, chunks.fault);
  return says_alpha(chunks);
}

void paste_pixels(Pixels& page, const Pixels& part, int left_px, int top_px) {
  if (left_px < 0 || top_px < 0 || left_px + part.size.width_px > page.size.width_px ||
      top_px + part.size.height_px > page.size.height_px)
    throw RunError("internal: a picture lies outside its page");
  const std::ptrdiff_t row = std::ptrdiff_t{3} * part.size.width_px;
  for (int y = 0; y < part.size.height_px; ++y) {
    const std::ptrdiff_t at = std::ptrdiff_t{3} * ((top_px + y) * page.size.width_px + left_px);
    std::copy_n(part.rgb.begin() + y * row, row, page.rgb.begin() + at);
  }
  if (part.alpha.empty() && page.alpha.empty()) return;
  constexpr std::uint8_t kOpaque = 255;
  if (page.alpha.empty()) page.alpha.assign(page.rgb.size() / 3, kOpaque);
  for (int y = 0; y < part.size.height_px; ++y) {
    const auto into = page.alpha.begin() + std::ptrdiff_t{top_px + y} * page.size.width_px + left_px;
    if (part.alpha.empty())
      std::fill_n(into, part.size.width_px, kOpaque);
    else
      std::copy_n(part.alpha.begin() + std::ptrdiff_t{y} * part.size.width_px, part.size.width_px, into);
  }
}

void cover_pixel(Pixels& picture, std::size_t pixel, const std::array<std::uint8_t, 3>& srgb, double cover) {
  const double below = (picture.alpha.empty() ? 1 : picture.alpha[pixel] / 255.0) * (1 - cover),
               all = cover + below;
  if (all <= 0) return;
  for (std::size_t c = 0; c < 3; ++c) {
    std::uint8_t& byte = picture.rgb[3 * pixel + c];
    byte = static_cast<std::uint8_t>(std::lround((cover * srgb[c] + below * byte) / all));
  }
  if (!picture.alpha.empty()) picture.alpha[pixel] = static_cast<std::uint8_t>(std::lround(255 * all));
}

std::vector<std::uint8_t> join_bytes(const Pixels& pixels) {
  std::vector<std::uint8_t> bytes;
  if (pixels.alpha.empty()) return bytes;
  bytes.reserve(4 * pixels.alpha.size());
  for (std::size_t i = 0; i < pixels.alpha.size(); ++i) {
    bytes.insert(bytes.end(), &pixels.rgb[3 * i], &pixels.rgb[3 * i] + 3);
    bytes.push_back(pixels.alpha[i]);
  }
  return bytes;
}

std::string build_png(const Pixels& pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(pixels.size.width_px);
  image.height = static_cast<png_uint_32>(pixels.size.height_px);
  image.format = pixels.alpha.empty() ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  const std::vector<std::uint8_t> both = join_bytes(pixels);
  const std::uint8_t* const bytes = both.empty() ? pixels.rgb.data() : both.data();
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string png(size, '\0');
  if (png_image_write_to_memory(&image, png.data(), &size, 0, bytes, 0, nullptr) == 0)
    throw RunError(fmt::format("cannot encode a picture: {}", image.message));
  png.resize(size);
  return png;
}

}  // namespace mien
