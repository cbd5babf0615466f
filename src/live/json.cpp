#include "live/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "config/findings.hpp"
#include "config/ledger.hpp"

namespace mien {

namespace {

double round_to_thousandths(double value) { return std::round(value * 1000) / 1000 + 0.0; }

}  // namespace

LiveAnswer build_answer(const Json& value) {
  return {200, "application/json", value.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

LiveAnswer build_bytes(const Json& header, const std::string& bytes) {
  std::string text = header.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const auto size = static_cast<std::uint32_t>(text.size());
  std::string body(sizeof size, '\0');
  std::memcpy(body.data(), &size, sizeof size);
  return {200, "application/octet-stream", body + text + bytes};
}

Json parse_body(const LiveRequest& request) {
  Json object = Json::parse(request.body, nullptr, false);
  if (!object.is_object()) throw InputError("the request is no JSON object");
  return object;
}

int take_version(const LiveRequest& request) {
  const auto found = request.query.find("version");
  int version = 0;
  if (found != request.query.end())
    std::from_chars(found->second.data(), found->second.data() + found->second.size(), version);
  return version;
}

std::string take_text(const Json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end() || !found->is_string())
    throw InputError(fmt::format("'{}' is missing; expected a text", name));
  return found->get<std::string>();
}

double take_number(const Json& object, const char* name, double low, double high) {
  const auto found = object.find(name);
  if (found == object.end() || !found->is_number())
    throw InputError(fmt::format("'{}' is missing; expected a number", name));
  const double value = found->get<double>();
  if (!(value >= low && value <= high))
    throw InputError(fmt::format("'{}' is {}; expected {} to {}", name, value, low, high));
  return value;
}

double take_number(const Json& object, const char* name, double low, double high, double otherwise) {
  return object.contains(name) ? take_number(object, name, low, high) : otherwise;
}

bool take_flag(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

Json describe_finding(const Diagnostic& diagnostic) {
  return {{"kind", diagnostic.is_warning ? "warning" : "error"},
          {"file", diagnostic.place.file},
          {"line", diagnostic.place.line},
          {"column", diagnostic.place.column},
          {"message", diagnostic.message}};
}

Json describe_values(const Pose& pose) {
  Json values = Json::object();
  for (std::size_t i = 0; i < kMoveCount; ++i)
    values[std::string(find_area_key(kMoves[i]))][std::string(kMoves[i].move)] =
        round_to_thousandths(pose.values[i]);
  return values;
}

Pose read_pose(const Json& values) {
  Pose pose;
  if (!values.is_object()) throw InputError("'values' is no object of areas");
  for (const auto& area : values.items()) {
    if (!area.value().is_object())
      throw InputError(fmt::format("'{}' is no object of moves", show_word(area.key())));
    for (const auto& move : area.value().items()) {
      const auto found = std::ranges::find_if(kMoves, [&](const MoveInfo& info) {
        return find_area_key(info) == area.key() && info.move == move.key();
      });
      if (found == kMoves.end() || !move.value().is_number())
        throw InputError(
            fmt::format("'{}.{}' is no move with a number", show_word(area.key()), show_word(move.key())));
      pose.values[static_cast<std::size_t>(found - kMoves.begin())] =
          std::clamp(move.value().get<double>(), found->low * kMaxExaggerate, found->high * kMaxExaggerate);
    }
  }
  return pose;
}

}  // namespace mien
