#include "config/language.hpp"

#include <algorithm>

#include "config/language_forms.hpp"

namespace mien {

Sections::Sections() {
  fill_head_sections(*this);
  fill_face_sections(*this);
  fill_clip_sections(*this);
  fill_file_sections(*this);
}

const Sections& find_sections() {
  static const Sections sections;
  return sections;
}

std::vector<const Section*> list_sections() {
  const Sections& all = find_sections();
  std::vector<const Section*> list{&all.file,   &all.head,   &all.guides, &all.look,
                                   &all.sculpt, &all.limits, &all.areas,  &all.live_areas};
  for (const auto* moves : {&all.moves, &all.live_moves})
    for (const Section& section : *moves) list.push_back(&section);
  for (const Section* section :
       {&all.muscles, &all.live_muscles, &all.candide, &all.live_candide, &all.parke, &all.conformation})
    list.push_back(section);
  for (const Section* section :
       {&all.expression,     &all.dominance,   &all.growth,   &all.clip,        &all.pose_key,
        &all.release,        &all.camera_key,  &all.turn_key, &all.head_key,    &all.light_key,
        &all.background_key, &all.draw_change, &all.input,    &all.input_point, &all.lead,
        &all.wait,           &all.cue,         &all.law,      &all.track,       &all.include,
        &all.script,         &all.blink,       &all.gaze,     &all.gaze_key,    &all.direction,
        &all.drift,          &all.asymmetry,   &all.sound,    &all.say,         &all.actor,
        &all.place,          &all.place_key,   &all.render,   &all.ink,         &all.bust,
        &all.bust_set,       &all.library_file})
    list.push_back(section);
  return list;
}

Names list_keys(const Section& section) {
  Names names;
  for (const Key& key : section.keys) names.push_back(key.name);
  return names;
}

const Key* find_key(const Section& section, std::string_view name) {
  const auto found = std::ranges::find(section.keys, name, &Key::name);
  return found == section.keys.end() ? nullptr : &*found;
}

const Form* find_form(const Forms& forms, FormKind kind) {
  const auto found = std::ranges::find(forms, kind, &Form::kind);
  return found == forms.end() ? nullptr : &*found;
}

}  // namespace mien
