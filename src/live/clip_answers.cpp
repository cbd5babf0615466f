#include "live/clip_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "clip/reach.hpp"
#include "config/edit_places.hpp"
#include "config/law_numbers.hpp"
#include "config/pose_mix.hpp"
#include "config/words.hpp"
#include "core/print_numbers.hpp"
#include "timeline/advice.hpp"
#include "timeline/chart.hpp"
#include "timeline/rehearsal.hpp"

namespace mien {

namespace {

constexpr std::array kLayerNames{"table", "cue", "speech", "law"};

// With the place in the text where it stands; a place in an included file is none.
Json describe_key(const LiveSession& session, const char* kind, double at_s, const std::string& label,
                  const Place& place, const std::string& actor) {
  const bool is_here = place.file == session.shelf.file.string();
  return {{"kind", kind},
          {"at_s", at_s},
          {"end_s", at_s},
          {"label", label},
          {"line", is_here ? place.line : 0},
          {"column", is_here ? place.column : 0},
          {"actor", actor}};
}

double find_end_s(double time_s, double length_s) {
  return std::min(time_s, length_s);
}  // JSON has no infinity

// A phrase that is said has a cue for lips and chin and one for the corners.
bool is_same_phrase(const Json& a, const Json& b) {
  return a["layer"] == "speech" && b["layer"] == "speech" && a["label"] == b["label"] &&
         a["from_s"] == b["from_s"] && a["end_s"] == b["end_s"];
}

Json describe_cue(const LiveSession& session, const CueSpec& cue, double length_s, const std::string& actor) {
  Json value = describe_key(session, "cue", cue.from_s, cue.what.label, cue.what.place, actor);
  value["from_s"] = cue.from_s;
  value["full_s"] = find_end_s(cue.full_s, length_s);
  value["ebb_s"] = find_end_s(cue.ebb_s, length_s);
  value["end_s"] = find_end_s(cue.end_s, length_s);
  value["layer"] = kLayerNames[static_cast<std::size_t>(cue.layer)];
  Json areas = Json::array();
  for (const AreaKey& key : kAreaKeys) {
    if (key.is_both) continue;
    for (std::size_t i = 0; i < kMoveCount; ++i)
      if (cue.owns[i] && find_area_key(kMoves[i]) == key.key) {
        areas.push_back(std::string(key.key));
        break;
      }
  }
  value["areas"] = areas;
  return value;
}

// A law of the camera, the head's turning, the lights or a place, as one of areas is told.
Json describe_law(const LiveSession& session, const TrackLaw& law, double length_s,
                  const std::string& actor) {
  CueSpec cue;
  cue.from_s = law.from_s;
  cue.full_s = law.full_s;
  cue.ebb_s = law.ebb_s;
  cue.end_s = law.end_s;
  cue.layer = Layer::law;
  cue.what.label = law.label;
  cue.what.place = law.place;
  return describe_cue(session, cue, length_s, actor);
}

Json describe_mix(const Mix& mix) {
  if (mix.size() == 1) return mix.begin()->first;
  Json value = Json::object();
  for (const auto& [name, weight] : mix) value[name] = weight;
  return value;
}

Json describe_colour(const glm::vec3& srgb) {
  const auto part = [](float x) { return std::lround(255 * std::clamp(x, 0.0f, 1.0f)); };
  return fmt::format("#{:02x}{:02x}{:02x}", part(srgb.r), part(srgb.g), part(srgb.b));
}

Json describe_head(const HeadSpec& head) {
  Json look{{"skin", describe_colour(head.look.skin)},
            {"iris", describe_colour(head.look.iris)},
            {"brow", describe_colour(head.look.brow)},
            {"hair", describe_colour(head.look.hair)},
            {"beard", head.look.beard},
            {"freckles", head.look.freckles},
            {"age_spots", head.look.age_spots}};
  if (head.look.lips) look["lips"] = describe_colour(*head.look.lips);
  Json features = Json::object();
  for (const auto& [name, value] : head.features) features[name] = value;
  return {{"age", describe_mix(head.age)},
          {"skull", describe_mix(head.skull)},
          {"design", describe_mix(head.design)},
          {"character", head.character},
          {"hair", head.hair},
          {"features", features},
          {"look", look},
          {"said", head.said}};
}

// "child 0.4, adult 0.6", which is what a head grows to mostly.
std::string describe_growth(const HeadSpec& head) {
  std::string label;
  for (const auto& [name, weight] : head.age)
    label += fmt::format("{}{}{}", label.empty() ? "" : ", ", name,
                         weight == 1 ? "" : fmt::format(" {:.3g}", weight));
  return label;
}

// The text of a clip, for where things stand in it; as good as none if it is not to be edited.
EditText find_places(const std::filesystem::path& file, const std::string& bytes) {
  EditText text;
  text.is_empty = true;
  try {
    text = open_text(bytes);
    text.document.source.file = file.string();
  } catch (const InputError&) {
  }
  return text;
}

struct Tracks {
  Json keys = Json::array(), cues = Json::array(), turns = Json::array(), heads = Json::array(),
       blinks = Json::array();
};

void add_tracks(const LiveSession& session, const Clip& clip, const Actor& actor, const EditText& text,
                Tracks& tracks) {
  const ClipSpec& spec = actor.performance.clip;
  const auto list_places = [&](const char* track) {
    return list_timed_places(text, actor.name, track, clip.spec.clip.fps);
  };
  const std::vector<TimedPlace> heads = list_places("head"), blinks = list_places("blinks");
  for (const PoseKey& key : spec.keys)
    tracks.keys.push_back(describe_key(session, "key", key.at_s, key.label, key.place, actor.name));
  for (const CueSpec& cue : spec.cues) {
    Json told = describe_cue(session, cue, clip.spec.clip.length_s, actor.name);
    if (tracks.cues.empty() || !is_same_phrase(tracks.cues.back(), told))
      tracks.cues.push_back(std::move(told));
    else
      for (const Json& area : told["areas"]) tracks.cues.back()["areas"].push_back(area);
  }
  for (const TrackLaw& law : spec.laws)
    if (law.track == LawTrack::turn || law.track == LawTrack::place || actor.name.empty())
      tracks.cues.push_back(describe_law(session, law, clip.spec.clip.length_s, actor.name));
  for (const TurnKey& key : spec.turn)
    tracks.turns.push_back(describe_key(
        session, "turn", key.at_s,
        fmt::format("{:.3g} {:.3g} {:.3g}", key.turn_deg, key.nod_deg, key.tilt_deg), key.place, actor.name));
  for (const HeadKey& key : spec.head)
    tracks.heads.push_back(describe_key(session, "head", key.at_s, describe_growth(key.head),
                                        find_timed_place(heads, key.at_s), actor.name));
  for (const double at_s : spec.blinks_s)
    tracks.blinks.push_back(
        describe_key(session, "blink", at_s, "", find_timed_place(blinks, at_s), actor.name));
}

Json describe_stage_keys(const LiveSession& session, const ClipSpec& clip, const EditText& text,
                         const char* kind, bool has_actors) {
  Json keys = Json::array();
  const std::vector<TimedPlace> places = list_timed_places(text, "", kind, clip.fps);
  const auto add = [&](double at_s, const std::string& label) {
    keys.push_back(describe_key(session, kind, at_s, label, find_timed_place(places, at_s), ""));
  };
  const std::string_view which = kind;
  if (which == "camera")
    for (const CameraKey& key : clip.camera)
      add(key.at_s,
          fmt::format("{:.3g} deg, {:.3g} deg, {:.3g}", key.angle_deg, key.height_deg, key.distance));
  if (which == "light")
    for (const LightKey& key : clip.light) add(key.at_s, key.set);
  for (const TrackLaw& law : clip.laws)
    if (has_actors && which == kLawTracks[static_cast<std::size_t>(law.track)])
      keys.push_back(describe_key(session, kind, law.from_s, law.label, {}, ""));
  if (which == "background")
    for (const BackgroundKey& key : clip.background)
      add(key.at_s, key.colour ? std::string(describe_colour(*key.colour)) : key.name);
  return keys;
}

constexpr std::array<std::string_view, 3> kStyleNames{"studio", "ink", "plaster"};

Json describe_clip(const LiveSession& session, const Clip& clip, const EditText& text) {
  const ClipSpec& spec = clip.spec.clip;
  Json drawn = Json::array(), actors = Json::array(), own = Json::array();
  for (int frame = 0; frame < clip.frame_count; ++frame) drawn.push_back(compute_drawn_frame(spec, frame));
  Tracks tracks;
  const bool has_actors = !clip.spec.actors.empty();
  for (const Actor& actor : clip.actors) {
    actors.push_back({{"name", actor.name}, {"head_values", describe_head(actor.head)}});
    add_tracks(session, clip, actor, text, tracks);
  }
  for (const Expression& expression : clip.spec.expressions)
    if (expression.library.empty()) own.push_back(expression.name);
  return {{"title", clip.spec.title},
          {"fps", spec.fps},
          {"frames", clip.frame_count},
          {"length_s", spec.length_s},
          {"width", clip.spec.render.width_px},
          {"height", clip.spec.render.height_px},
          {"style", kStyleNames[static_cast<std::size_t>(clip.spec.render.style)]},
          {"drawn", drawn},
          {"actors", actors},
          {"keys", tracks.keys},
          {"cues", tracks.cues},
          {"blinks", tracks.blinks},
          {"turns", tracks.turns},
          {"cameras", describe_stage_keys(session, spec, text, "camera", has_actors)},
          {"lights", describe_stage_keys(session, spec, text, "light", has_actors)},
          {"backgrounds", describe_stage_keys(session, spec, text, "background", has_actors)},
          {"heads", tracks.heads},
          {"is_growing", !tracks.heads.empty()},
          {"expressions", own}};
}

Json describe_rows(const std::vector<Shown>& shown, const std::string& actor) {
  Json rows = Json::array();
  for (const ChartRow& row : list_chart_rows(shown)) {
    Json values = Json::array();
    for (const std::vector<double>& move : row.values) {
      Json numbers = Json::array();
      for (const double value : move) numbers.push_back(std::round(value * 1000) / 1000);
      values.push_back(std::move(numbers));
    }
    rows.push_back(
        {{"actor", actor}, {"name", row.name}, {"moves", row.moves}, {"values", std::move(values)}});
  }
  return rows;
}

// Where a move is at its limit while somebody asks for more, in the rehearsed frames: 0..0 if it never is.
std::pair<double, double> find_held_span(const Held& held, const std::vector<Rehearsal>& rehearsals,
                                         int fps) {
  int first = -1, last = -1;
  for (const Rehearsal& rehearsal : rehearsals)
    for (int frame = 0; frame < static_cast<int>(rehearsal.shown.size()); ++frame) {
      const double shown = rehearsal.shown[static_cast<std::size_t>(frame)].pose.values[held.move];
      if (shown * held.held < 0 || std::abs(shown) < std::abs(held.held) - 1e-3) continue;
      if (first < 0) first = frame;
      last = frame;
    }
  return first < 0 ? std::pair{0.0, 0.0} : std::pair{first / double(fps), (last + 1) / double(fps)};
}

// `actor`: whose limits; of the file's own expressions and busts nobody's.
void add_held(const Clip& clip, const std::vector<Held>& held, const std::vector<Rehearsal>& rehearsals,
              const Json& actor, Json& all) {
  for (const HeldNote& note : build_notes(held)) {
    const auto [from_s, to_s] = find_held_span(note.held, rehearsals, clip.spec.clip.fps);
    all.push_back({{"area", find_area_key(kChannels[note.held.move])},
                   {"move", kChannels[note.held.move].move},
                   {"asked", note.held.asked},
                   {"got", note.held.held},
                   {"from_s", from_s},
                   {"to_s", to_s},
                   {"who", note.text},
                   {"file", note.held.place.file},
                   {"line", note.held.place.line},
                   {"column", note.held.place.column}});
    if (!actor.is_null()) all.back()["actor"] = actor;
  }
}

Json describe_held(const Clip& clip, const std::vector<Rehearsal>& rehearsals) {
  Json all = Json::array();
  add_held(clip, list_held(clip.spec), rehearsals, nullptr, all);
  for (std::size_t i = 0; i < rehearsals.size(); ++i)
    add_held(clip, rehearsals[i].held, {rehearsals[i]}, clip.actors[i].name, all);
  return all;
}

template <typename Words>
Json list_words(const Words& words) {
  Json list = Json::array();
  for (const LookWord& word : words) list.push_back(word.name);
  return list;
}

}  // namespace

std::size_t find_asked_actor(const Clip& clip, const Json& asked) {
  const std::string name = asked.contains("actor") ? take_text(asked, "actor") : "";
  if (name.empty()) return 0;
  const auto found = std::ranges::find(clip.actors, name, &Actor::name);
  if (found == clip.actors.end()) throw InputError(fmt::format("there is no actor '{}'", show_word(name)));
  return static_cast<std::size_t>(found - clip.actors.begin());
}

double find_asked_time_s(const Clip& clip, const Json& asked) {
  const int last = clip.frame_count - 1;
  const auto frame = static_cast<int>(take_number(asked, "frame", 0, kMaxFrames, 0));
  return compute_drawing_time_s(clip.spec.clip, std::min(frame, last));
}

LiveAnswer answer_check(LiveSession& session, const Json& asked) {
  const std::string text = take_text(asked, "text");
  const DocumentPointer document = read_document(session.shelf, text);
  Json findings = Json::array();
  for (const Diagnostic& mistake : document->mistakes) findings.push_back(describe_finding(mistake));
  Json value{{"doc", document->key}, {"good", document->clip.has_value()}, {"findings", findings}};
  if (document->clip)
    value["clip"] = describe_clip(session, *document->clip, find_places(session.shelf.file, text));
  return build_answer(value);
}

LiveAnswer answer_chart(LiveSession& session, const Json& asked) {
  const DocumentPointer document = find_document(session.shelf, take_text(asked, "doc"));
  const Clip& clip = *document->clip;
  Json rows = Json::array(), warnings = Json::array();
  try {
    const auto heads = find_heads(session.shelf, *document, 0);
    std::vector<Rehearsal> rehearsals;
    for (std::size_t i = 0; i < clip.actors.size(); ++i) {
      rehearsals.push_back(rehearse(heads->performances[i]));
      for (Json& row : describe_rows(rehearsals[i].shown, clip.actors[i].name))
        rows.push_back(std::move(row));
      for (const Diagnostic& advice :
           advise_clip(heads->performances[i].clip, rehearsals[i], compute_reach(*heads->figures[i])))
        warnings.push_back(describe_finding(advice));
    }
    return build_answer({{"rows", rows}, {"held", describe_held(clip, rehearsals)}, {"warnings", warnings}});
  } catch (const InputError& error) {  // a head that cannot be built
    for (const Diagnostic& mistake : error.diagnostics) warnings.push_back(describe_finding(mistake));
    return build_answer({{"rows", rows}, {"held", Json::array()}, {"warnings", warnings}});
  }
}

LiveAnswer answer_pose_at(LiveSession& session, const Json& asked) {
  const DocumentPointer document = find_document(session.shelf, take_text(asked, "doc"));
  const Clip& clip = *document->clip;
  const double time_s = find_asked_time_s(clip, asked);
  const auto heads = find_heads(session.shelf, *document, time_s);
  const Moment moment = sample_performance(heads->performances[find_asked_actor(clip, asked)], time_s);
  return build_answer(
      {{"values", describe_values(moment.pose)},
       {"turn",
        {{"turn", moment.turn.turn_deg}, {"nod", moment.turn.nod_deg}, {"tilt", moment.turn.tilt_deg}}}});
}

LiveAnswer answer_expression(LiveSession& session, const Json& asked) {
  const DocumentPointer document = find_document(session.shelf, take_text(asked, "doc"));
  const Spec& spec = document->clip->spec;
  const Expression& expression = find_expression(spec, take_text(asked, "name"));
  const double strength = take_number(asked, "strength", 0, 1, 1);
  const Pose pose = mix_poses({{1, expression.pose, expression.manner}}, strength);
  const HeldPose held = hold_pose({pose, expression.reach, strength, {}, spec.exaggerate});
  return build_answer({{"values", describe_values(held.pose)}, {"strength", strength}});
}

LiveAnswer answer_language(LiveSession& session) {
  const Stock& stock = session.shelf.resources->stock;
  const HeadWords& words = stock.language->words;
  Json expressions = Json::array(), areas = Json::array(), features = words.features;
  for (const Expression& expression : stock.language->libraries.expressions) {
    if (expression.library == "mien") expressions.push_back(expression.name);
    expressions.push_back(expression.library + "/" + expression.name);
  }
  for (const AreaInfo& area : kAreas) {
    Json moves = Json::array();
    for (const MoveInfo& move : kMovesOfOneSide)
      if (move.of == area.area)
        moves.push_back(
            {{"move", move.move}, {"low", move.low}, {"high", move.high}, {"meaning", move.meaning}});
    areas.push_back({{"name", area.name},
                     {"key", area.has_sides() ? area.plural : area.name},
                     {"left", area.left_key},
                     {"right", area.right_key},
                     {"in_words", area.in_words},
                     {"moves", moves}});
  }
  return build_answer({{"schema", Json::parse(session.schema)},
                       {"expressions", expressions},
                       {"areas", areas},
                       {"lists",
                        {{"looks", list_words(words.look_words)},
                         {"hair_colours", list_words(words.hair_colour_words)},
                         {"designs", list_words(words.designs)},
                         {"features", features}}}});
}

}  // namespace mien
