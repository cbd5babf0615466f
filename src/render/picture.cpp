// PNG (Portable Network Graphics) Specification, W3C, second edition: a signature, then chunks of length,
// type, data and a CRC of type and data. Pixels are decoded by libpng.
#include "render/picture.hpp"

#include <fmt/format.h>
#include <png.h>
#include <zlib.h>

#include <algorithm>
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

struct Pixels {
  std::vector<png_byte> rgba;
  std::string fault;
};

Pixels decode_picture(std::string_view png) {
  Pixels pixels;
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, png.data(), png.size()) != 0) {
    image.format = PNG_FORMAT_RGBA;
    pixels.rgba.resize(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, pixels.rgba.data(), 0, nullptr) != 0) return pixels;
  }
  pixels.fault = image.message;
  png_image_free(&image);
  return pixels;
}

bool is_one_colour(const std::vector<png_byte>& rgba) {
  // Equal to itself shifted by one pixel.
  return std::equal(rgba.begin() + 4, rgba.end(), rgba.begin());
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
  const Pixels pixels = decode_picture(png);
  if (!pixels.fault.empty()) return "does not decode: " + pixels.fault;
  return is_one_colour(pixels.rgba) ? "is all one colour" : "";
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

PictureSize read_picture_size(const std::filesystem::path& picture) {
  const std::string png = read_file(picture);
  const Chunks chunks = find_chunks(png);
  if (!chunks.fault.empty())
    throw RunError(fmt::format("{} is not a whole PNG picture: {}", picture.string(), chunks.fault));
  return read_size(chunks);
}

}  // namespace mien
