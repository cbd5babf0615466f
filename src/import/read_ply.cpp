// PLY (Turk 1994): a head of text that describes elements and their properties, then text or binary numbers.
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "import/reading.hpp"

namespace mien {

namespace {

struct PlyType {
  std::string_view name, other_name;
  std::size_t size;  // bytes
  char kind;         // 'i' signed, 'u' unsigned, 'f' floating
};
constexpr std::array kTypes{PlyType{"char", "int8", 1, 'i'},     PlyType{"uchar", "uint8", 1, 'u'},
                            PlyType{"short", "int16", 2, 'i'},   PlyType{"ushort", "uint16", 2, 'u'},
                            PlyType{"int", "int32", 4, 'i'},     PlyType{"uint", "uint32", 4, 'u'},
                            PlyType{"float", "float32", 4, 'f'}, PlyType{"double", "float64", 8, 'f'}};

struct Property {
  std::string name;
  const PlyType* type = nullptr;
  const PlyType* count_type = nullptr;  // of a list's length; null: no list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

enum class Format { none, text, little, big };

struct PlyReader {
  LineReader lines;
  std::string_view bytes;  // the whole file
  std::vector<std::string_view> words;
  std::size_t word = 0;  // the next one of the current line, in text
  std::size_t at = 0;    // the next byte, in binary
  Format format = Format::none;
  std::vector<Element> elements;
  const Element* element = nullptr;  // that is being read
  std::size_t item = 0;              // of that
};

[[noreturn]] void fail(const PlyReader& reader, const std::string& message) {
  fail_line(reader.lines.file, reader.lines.number, message);
}

const PlyType* find_type(const PlyReader& reader, std::string_view name) {
  for (const PlyType& type : kTypes)
    if (name == type.name || name == type.other_name) return &type;
  fail(reader,
       fmt::format("unknown type '{}'; expected char, uchar, short, ushort, int, uint, float or double",
                   show_found(name)));
}

void read_property(PlyReader& reader) {
  const auto& words = reader.words;
  if (reader.elements.empty()) fail(reader, "a property before any element; expected element NAME COUNT");
  auto& properties = reader.elements.back().properties;
  if (words.size() == 5 && words[1] == "list")
    properties.push_back({std::string(words[4]), find_type(reader, words[3]), find_type(reader, words[2])});
  else if (words.size() == 3)
    properties.push_back({std::string(words[2]), find_type(reader, words[1]), nullptr});
  else
    fail(reader, "a property of other words; expected property TYPE NAME or property list TYPE TYPE NAME");
}

void read_head_line(PlyReader& reader) {
  const auto& words = reader.words;
  const std::string_view word = words.front();
  if (word == "format") {
    const std::string_view name = words.size() > 1 ? words[1] : std::string_view();
    reader.format = name == "ascii"                  ? Format::text
                    : name == "binary_little_endian" ? Format::little
                    : name == "binary_big_endian"    ? Format::big
                                                     : Format::none;
    if (reader.format == Format::none)
      fail(reader,
           fmt::format("unknown format '{}'; expected ascii, binary_little_endian or binary_big_endian",
                       show_found(name)));
  } else if (word == "element") {
    const auto count = words.size() == 3 ? parse_index(words[2]) : std::nullopt;
    if (!count || *count < 0 || *count > static_cast<long long>(4 * kMaxGeometryPoints))
      fail(reader, fmt::format("an element of other words; expected element NAME COUNT, up to {}",
                               4 * kMaxGeometryPoints));
    reader.elements.push_back({std::string(words[1]), static_cast<std::size_t>(*count), {}});
    if (words[1] == "vertex")
      check_point_count(reader.lines.file, reader.lines.number, reader.elements.back().count);
  } else if (word == "property") {
    read_property(reader);
  } else if (word != "comment" && word != "obj_info") {
    fail(reader,
         fmt::format("unknown word '{}' in the head; expected format, element, property or end_header",
                     show_found(word)));
  }
}

void read_head(PlyReader& reader) {
  if (!read_line(reader.lines) || reader.lines.line != "ply")
    fail_line(reader.lines.file, 1, "the file does not begin with the word 'ply'; expected a PLY file");
  while (read_line(reader.lines)) {
    split_words(reader.lines.line, reader.words);
    if (reader.words.empty()) continue;
    if (reader.words.front() == "end_header") {
      if (reader.format == Format::none)
        fail(reader, "the head names no format; expected one, as in format ascii 1.0");
      reader.at = static_cast<std::size_t>(reader.lines.rest.data() - reader.bytes.data());
      reader.words.clear();
      return;
    }
    read_head_line(reader);
  }
  fail(reader, "the file ends within its head; expected end_header");
}

double read_text_number(PlyReader& reader) {
  while (reader.word >= reader.words.size()) {
    if (!read_line(reader.lines))
      fail(reader, fmt::format("the file ends within {} {} of {}; expected all of them", reader.element->name,
                               reader.item + 1, reader.element->count));
    split_words(reader.lines.line, reader.words);
    reader.word = 0;
  }
  const std::string_view word = reader.words[reader.word++];
  const auto value = parse_coordinate(word);
  if (!value) fail(reader, fmt::format("'{}' is no number; expected one", show_found(word)));
  return *value;
}

double read_binary_number(PlyReader& reader, const PlyType& type) {
  if (reader.bytes.size() - reader.at < type.size)
    fail_file(reader.lines.file,
              fmt::format("ends at byte {}, within {} {} of {}; expected all of them", reader.bytes.size(),
                          reader.element->name, reader.item + 1, reader.element->count));
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < type.size; ++i) {
    const std::size_t from = reader.format == Format::little ? type.size - 1 - i : i;
    bits = bits << 8 | static_cast<unsigned char>(reader.bytes[reader.at + from]);
  }
  reader.at += type.size;
  if (type.kind == 'f')
    return type.size == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                          : std::bit_cast<double>(bits);
  const std::uint64_t sign = std::uint64_t{1} << (8 * type.size - 1);
  if (type.kind == 'i' && (bits & sign)) return static_cast<double>(bits) - 2.0 * static_cast<double>(sign);
  return static_cast<double>(bits);
}

double read_number(PlyReader& reader, const PlyType& type) {
  return reader.format == Format::text ? read_text_number(reader) : read_binary_number(reader, type);
}

// Where the reader stands, as a message says it.
[[noreturn]] void fail_here(const PlyReader& reader, const std::string& what) {
  if (reader.format == Format::text) fail(reader, what);
  fail_file(reader.lines.file, fmt::format("before byte {}: {}", reader.at, what));
}

// How many numbers a property has here: one, or what a list says.
int read_count(PlyReader& reader, const Property& property) {
  constexpr double kMostInList = 10000;  // corners of a face and the like; a list that says more is none
  if (property.count_type == nullptr) return 1;
  const double count = read_number(reader, *property.count_type);
  if (!(count >= 0 && count <= kMostInList))
    fail_here(reader, fmt::format("{} {} has a list of {:.7g}; expected 0 to {}", reader.element->name,
                                  reader.item, count, kMostInList));
  return static_cast<int>(count);
}

void read_vertex(PlyReader& reader, Polygons& mesh) {
  constexpr std::string_view kNormal[] = {"nx", "ny", "nz"};
  glm::dvec3 position{0}, normal{0};
  int normal_axes = 0;
  for (const Property& property : reader.element->properties) {
    const int count = read_count(reader, property);
    for (int i = 0; i < count; ++i) {
      const double value = read_number(reader, *property.type);
      if (property.count_type) continue;
      if (const auto found = std::ranges::find(kNormal, property.name); found != std::end(kNormal)) {
        if (!std::isfinite(value)) continue;  // looks only: a file with such a normal has none
        normal[static_cast<glm::length_t>(found - std::begin(kNormal))] = value;
        ++normal_axes;
      }
      if (property.name.size() != 1) continue;
      const int axis = property.name[0] - 'x';
      if (axis < 0 || axis > 2) continue;
      if (!std::isfinite(value) || std::abs(value) > kMaxCoordinate)
        fail_here(reader,
                  fmt::format("the {} of vertex {} is {:.7g}; expected a number from -1000000 to 1000000",
                              property.name, reader.item, value));
      position[axis] = value;
    }
  }
  mesh.positions.push_back(position);
  if (normal_axes == 3) mesh.normals.push_back(normal);
  if (reader.format == Format::text) mesh.lines.push_back(static_cast<std::uint32_t>(reader.lines.number));
}

void read_face(PlyReader& reader, std::size_t point_count, Polygons& mesh) {
  for (const Property& property : reader.element->properties) {
    const bool is_corners = property.name == "vertex_indices" || property.name == "vertex_index";
    const int count = read_count(reader, property);
    if (is_corners && count < 3)
      fail_here(reader,
                fmt::format("face {} is a list of {}; expected 3 points or more", reader.item, count));
    for (int i = 0; i < count; ++i) {
      const double value = read_number(reader, *property.type);
      if (!is_corners) continue;
      if (!(value >= 0 && value < static_cast<double>(point_count)))
        fail_here(reader, fmt::format("face {} names vertex {:.7g}; expected numbers from 0 to {}",
                                      reader.item, value, static_cast<long long>(point_count) - 1));
      mesh.corners.push_back(static_cast<std::uint32_t>(value));
    }
    if (is_corners) mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
}

// Points without places would all lie at 0 0 0, however many the head says.
void check_axes(const PlyReader& reader, const Element& vertices) {
  for (const char* axis : {"x", "y", "z"})
    if (std::ranges::find(vertices.properties, axis, &Property::name) == vertices.properties.end())
      fail(reader, fmt::format("element vertex has no property '{}'; expected x, y and z", axis));
}

}  // namespace

Polygons read_ply(const std::string& file, std::string_view bytes) {
  PlyReader reader{{file, bytes, {}, 0}, bytes, {}, 0, 0, Format::none, {}, nullptr, 0};
  read_head(reader);
  const auto vertices = std::ranges::find(reader.elements, "vertex", &Element::name);
  const std::size_t point_count = vertices == reader.elements.end() ? 0 : vertices->count;
  if (point_count > 0) check_axes(reader, *vertices);
  Polygons mesh;
  for (const Element& element : reader.elements) {
    if (element.properties.empty()) continue;  // nothing to read, however many there are
    reader.element = &element;
    for (reader.item = 0; reader.item < element.count; ++reader.item) {
      if (element.name == "vertex") {
        read_vertex(reader, mesh);
      } else if (element.name == "face") {
        read_face(reader, point_count, mesh);
      } else {
        Polygons ignored;
        read_vertex(reader, ignored);
      }
    }
  }
  return mesh;
}

}  // namespace mien
