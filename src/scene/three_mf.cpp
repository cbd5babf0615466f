// 3D Manufacturing Format by lib3mf, the 3MF Consortium's own library. What it would draw by lot, the UUIDs
// of the production extension, is made of the content; its archives carry no date.
#include "scene/three_mf.hpp"

#include <Model/COM/NMR_DLLInterfaces.h>
#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/error.hpp"
#include "core/utf8.hpp"

namespace mien {

namespace {

void require(int result, const char* what) {
  if (result != 0)
    throw RunError(fmt::format("internal: lib3mf cannot {} ({:#x})", what, std::uint32_t(result)));
}

// Something of lib3mf's, given back at the end.
struct Handle {
  NMR::PLib3MFBase* it = nullptr;

  Handle() = default;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (it != nullptr) NMR::lib3mf_release(it);
  }
};

// ASCII as it is, anything else as '?' unless it is sound UTF-8: what XML may hold.
std::string clean(const std::string& text) {
  constexpr std::uint32_t kNoCharacters = 0xFFC0, kEndOfThem = 0xFFFF;
  std::string safe;
  for (std::size_t at = 0; at < text.size();) {
    const auto [code, length] = find_character(text, at);
    if (length > 1 && (code < kNoCharacters || code > kEndOfThem))
      safe += text.substr(at, length);
    else if (length > 1)
      safe.append(length, '?');
    else
      safe += length == 0 || code >= 127 ? '?' : code < ' ' ? ' ' : text[at];
    at += std::max<std::size_t>(length, 1);
  }
  return safe;
}

// lib3mf 1.8 writes metadata as they come, markup and all.
std::string escape_metadata(const std::string& text) {
  std::string safe;
  for (const char c : clean(text))
    safe += c == '<' || c == '>' || c == '&' || c == '"' || c == '\'' ? fmt::format("&#{};", int(c))
                                                                      : std::string(1, c);
  return safe;
}

// The same for the same content, and unlike for any other; version 8 of RFC 9562 is for such.
std::string build_uuid(const std::vector<PrintObject>& objects, std::uint64_t number) {
  XXH64_hash_t hash[2] = {number, ~number};
  for (const PrintObject& object : objects)
    for (XXH64_hash_t& part : hash) {
      part = XXH64(object.mesh.positions.data(), object.mesh.positions.size() * sizeof(glm::vec3), part);
      part = XXH64(object.mesh.triangles.data(), object.mesh.triangles.size() * sizeof(Triangle), part);
    }
  return fmt::format("{:08x}-{:04x}-8{:03x}-{:04x}-{:012x}", hash[0] >> 32, hash[0] >> 16 & 0xffff,
                     hash[0] & 0xfff, 0x8000 | (hash[1] >> 48 & 0x3fff), hash[1] & 0xffffffffffff);
}

BYTE find_byte(float share) { return BYTE(std::lround(std::clamp(share, 0.0f, 1.0f) * 255)); }

// The object's colours as a group of materials; the first one is for all that has none of its own.
void add_colours(NMR::PLib3MFModel* model, const PrintObject& object, NMR::PLib3MFModelMeshObject* mesh) {
  if (object.colours.empty()) return;
  Handle group, each, otherwise;
  DWORD id = 0, index = 0;
  require(NMR::lib3mf_model_addbasematerialgroup(model, &group.it), "add colours");
  require(NMR::lib3mf_resource_getresourceid(group.it, &id), "name colours");
  for (const ColourRange& range : object.colours) {
    const BYTE red = find_byte(range.srgb.x), green = find_byte(range.srgb.y), blue = find_byte(range.srgb.z);
    require(NMR::lib3mf_basematerial_addmaterialutf8(group.it, clean(range.name).c_str(), red, green, blue,
                                                     &index),
            "add a colour");
    require(NMR::lib3mf_basematerial_setdisplaycolorrgba(group.it, index, red, green, blue, 255),
            "set a colour");
  }
  require(NMR::lib3mf_object_createdefaultpropertyhandler(mesh, &otherwise.it), "colour an object");
  require(NMR::lib3mf_defaultpropertyhandler_setbasematerial(otherwise.it, id, 0), "colour an object");
  require(NMR::lib3mf_meshobject_createpropertyhandler(mesh, &each.it), "colour triangles");
  for (std::size_t i = 1; i < object.colours.size(); ++i)
    for (std::size_t t = 0; t < object.colours[i].count; ++t)
      require(NMR::lib3mf_propertyhandler_setbasematerial(each.it, DWORD(object.colours[i].first + t), id,
                                                          DWORD(i)),
              "colour a triangle");
}

void add_object(NMR::PLib3MFModel* model, const PrintObject& object, const std::string& uuid,
                const std::string& item_uuid) {
  std::vector<NMR::MODELMESHVERTEX> vertices;
  for (const glm::vec3& p : object.mesh.positions) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw RunError("internal: a mesh holds a number that is not finite");
    vertices.push_back({{p.x, p.y, p.z}});
  }
  std::vector<NMR::MODELMESHTRIANGLE> triangles;
  for (const auto& [a, b, c] : object.mesh.triangles) triangles.push_back({{a, b, c}});
  Handle mesh, item;
  require(NMR::lib3mf_model_addmeshobject(model, &mesh.it), "add an object");
  require(NMR::lib3mf_object_setnameutf8(mesh.it, clean(object.name).c_str()), "name an object");
  require(NMR::lib3mf_object_setuuidutf8(mesh.it, uuid.c_str()), "mark an object");
  require(NMR::lib3mf_meshobject_setgeometry(mesh.it, vertices.data(), DWORD(vertices.size()),
                                             triangles.data(), DWORD(triangles.size())),
          "take a mesh");
  add_colours(model, object, mesh.it);
  require(NMR::lib3mf_model_addbuilditem(model, mesh.it, nullptr, &item.it), "add a print");
  require(NMR::lib3mf_builditem_setuuidutf8(item.it, item_uuid.c_str()), "mark a print");
}

}  // namespace

std::string build_3mf(const std::string& title, const std::vector<PrintObject>& objects) {
  Handle model, writer;
  require(NMR::lib3mf_createmodel(&model.it), "begin");
  require(NMR::lib3mf_model_setunit(model.it, NMR::MODELUNIT_MILLIMETER), "set the unit");
  require(NMR::lib3mf_model_setlanguageutf8(model.it, "en-US"), "set the language");
  require(NMR::lib3mf_model_addmetadatautf8(model.it, "Title", escape_metadata(title).c_str()),
          "set the title");
  require(NMR::lib3mf_model_addmetadatautf8(model.it, "Application", "mien"), "set the program");
  require(NMR::lib3mf_model_setbuilduuidutf8(model.it, build_uuid(objects, 0).c_str()), "mark the print");
  for (std::size_t i = 0; i < objects.size(); ++i)
    add_object(model.it, objects[i], build_uuid(objects, 2 * i + 1), build_uuid(objects, 2 * i + 2));
  require(NMR::lib3mf_model_querywriter(model.it, "3mf", &writer.it), "write");
  ULONG64 size = 0;
  require(NMR::lib3mf_writer_getstreamsize(writer.it, &size), "write");
  std::string bytes(size, '\0');
  require(NMR::lib3mf_writer_writetobuffer(writer.it, reinterpret_cast<BYTE*>(bytes.data()), size), "write");
  return bytes;
}

}  // namespace mien
