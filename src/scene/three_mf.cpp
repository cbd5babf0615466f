// 3D Manufacturing Format, Core Specification 1.2 (3MF Consortium): a package of three files (Open Packaging
// Conventions, ECMA-376 part 2) in a ZIP archive (PKWARE APPNOTE 6.3), here stored and dated 1980, so that
// nothing in it depends on when it was written.
#include "scene/three_mf.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

constexpr int kDecimals = 5;           // finer than a float of 100 mm
constexpr std::uint16_t kDate = 0x21;  // 1 January 1980

constexpr std::string_view kTypes =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
    "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
    "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
    "</Types>\n";
constexpr std::string_view kRelations =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";

void append_le(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> 8 * i & 0xff);
}

std::uint32_t find_crc(std::string_view content) {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    table[i] = i;
    for (int bit = 0; bit < 8; ++bit) table[i] = table[i] & 1 ? table[i] >> 1 ^ 0xEDB88320u : table[i] >> 1;
  }
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char c : content) crc = table[(crc ^ static_cast<unsigned char>(c)) & 0xff] ^ crc >> 8;
  return ~crc;
}

struct PackedFile {
  std::string_view name, content;
};

std::string build_zip(const std::vector<PackedFile>& files) {
  std::string bytes, directory;
  for (const auto& [name, content] : files) {
    std::string facts;        // what both headers share
    append_le(facts, 20, 2);  // the version needed to read it
    append_le(facts, 0, 2);
    append_le(facts, 0, 2);  // stored
    append_le(facts, 0, 2);
    append_le(facts, kDate, 2);
    append_le(facts, find_crc(content), 4);
    append_le(facts, static_cast<std::uint32_t>(content.size()), 4);
    append_le(facts, static_cast<std::uint32_t>(content.size()), 4);
    append_le(facts, static_cast<std::uint32_t>(name.size()), 2);
    append_le(facts, 0, 2);
    append_le(directory, 0x02014b50, 4);
    append_le(directory, 20, 2);
    directory += facts;
    append_le(directory, 0, 2 + 2 + 2);
    append_le(directory, 0, 2 + 2);
    append_le(directory, static_cast<std::uint32_t>(bytes.size()), 4);
    directory += name;
    append_le(bytes, 0x04034b50, 4);
    bytes += facts;
    bytes += name;
    bytes += content;
  }
  const auto start = static_cast<std::uint32_t>(bytes.size());
  bytes += directory;
  append_le(bytes, 0x06054b50, 4);
  append_le(bytes, 0, 4);
  append_le(bytes, static_cast<std::uint32_t>(files.size()), 2);
  append_le(bytes, static_cast<std::uint32_t>(files.size()), 2);
  append_le(bytes, static_cast<std::uint32_t>(directory.size()), 4);
  append_le(bytes, start, 4);
  append_le(bytes, 0, 2);
  return bytes;
}

// Text for XML: ASCII as it is or escaped, anything else as '?' unless it is sound UTF-8.
std::string escape(const std::string& text) {
  std::string safe;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const int more = c >> 5 == 6 && c >= 0xC2 ? 1 : c >> 4 == 14 ? 2 : c >> 3 == 30 && c <= 0xF4 ? 3 : 0;
    bool is_sound = c >= 0x80 && more > 0 && i + more < text.size();
    for (int k = 1; is_sound && k <= more; ++k) is_sound = static_cast<unsigned char>(text[i + k]) >> 6 == 2;
    if (is_sound && more == 2) {  // no overlong forms, surrogates or non-characters
      const auto next = static_cast<unsigned char>(text[i + 1]);
      is_sound = !(c == 0xE0 && next < 0xA0) && !(c == 0xED && next > 0x9F) && !(c == 0xEF && next == 0xBF);
    }
    if (is_sound && more == 3) {
      const auto next = static_cast<unsigned char>(text[i + 1]);
      is_sound = !(c == 0xF0 && next < 0x90) && !(c == 0xF4 && next > 0x8F);
    }
    if (is_sound) {
      safe += text.substr(i, more + 1);
      i += more;
    } else if (c == '<' || c == '>' || c == '&' || c == '"' || c == '\'') {
      safe += fmt::format("&#{};", c);
    } else {
      safe += c < ' ' ? ' ' : c < 127 ? static_cast<char>(c) : '?';
    }
  }
  return safe;
}

std::string format_colour(const glm::vec3& srgb) {
  std::string text = "#";
  for (int i = 0; i < 3; ++i)
    text += fmt::format("{:02X}", int(std::lround(std::min(std::max(srgb[i], 0.0f), 1.0f) * 255)));
  return text;
}

// Each object has its colours as a resource of its own, numbered before it.
void append_object(std::string& xml, const PrintObject& object, std::size_t number) {
  const std::size_t colours = 2 * number + 1;
  std::vector<std::size_t> colour_of(object.mesh.triangles.size(), 0);
  for (std::size_t i = 0; i < object.colours.size(); ++i)
    for (std::size_t t = 0; t < object.colours[i].count; ++t) colour_of.at(object.colours[i].first + t) = i;
  std::string properties;
  if (!object.colours.empty()) {
    xml += fmt::format("  <basematerials id=\"{}\">\n", colours);
    for (const ColourRange& range : object.colours)
      xml += fmt::format("   <base name=\"{}\" displaycolor=\"{}\"/>\n", escape(range.name),
                         format_colour(range.srgb));
    xml += "  </basematerials>\n";
    properties = fmt::format(" pid=\"{}\" pindex=\"0\"", colours);
  }
  xml += fmt::format("  <object id=\"{}\" type=\"model\" name=\"{}\"{}>\n   <mesh>\n    <vertices>\n",
                     colours + 1, escape(object.name), properties);
  for (const glm::vec3& p : object.mesh.positions) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw RunError("internal: a mesh holds a number that is not finite");
    xml += "     <vertex x=\"";
    append_number(xml, p.x, kDecimals);
    xml += "\" y=\"";
    append_number(xml, p.y, kDecimals);
    xml += "\" z=\"";
    append_number(xml, p.z, kDecimals);
    xml += "\"/>\n";
  }
  xml += "    </vertices>\n    <triangles>\n";
  for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = object.mesh.triangles[t];
    xml += fmt::format("     <triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"", a, b, c);
    if (colour_of[t] > 0) xml += fmt::format(" pid=\"{}\" p1=\"{}\"", colours, colour_of[t]);
    xml += "/>\n";
  }
  xml += "    </triangles>\n   </mesh>\n  </object>\n";
}

}  // namespace

std::string build_3mf(const std::string& title, const std::vector<PrintObject>& objects) {
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
      " <metadata name=\"Title\">{}</metadata>\n <metadata name=\"Application\">mien</metadata>\n "
      "<resources>\n",
      escape(title));
  for (std::size_t i = 0; i < objects.size(); ++i) append_object(xml, objects[i], i);
  xml += " </resources>\n <build>\n";
  for (std::size_t i = 0; i < objects.size(); ++i)
    xml += fmt::format("  <item objectid=\"{}\"/>\n", 2 * i + 2);
  xml += " </build>\n</model>\n";
  return build_zip({{"[Content_Types].xml", kTypes}, {"_rels/.rels", kRelations}, {"3D/3dmodel.model", xml}});
}

}  // namespace mien
