// The words that the head's own data define: features, places on the skin and looks.
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "config/findings.hpp"
#include "config/head_spec.hpp"
#include "config/people.hpp"
#include "config/words.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

// What colours of hair and brows become on a head that is all `old`: so far on the way to a grey.
struct Greying {
  glm::vec3 hair{0}, brow{0};
  double hair_share = 0, brow_share = 0;
  double age_spots = 0;  // at least, where the author says nothing of them
};

// A word of looks.yaml as `mien list looks` tells it.
struct LookWord {
  std::string name;
  std::string value;  // the colour as the file writes it; none for a dial
  std::string meaning;
};

struct HeadWords {
  Names features;  // the keys of `head.features`
  Names middle;    // places of the mid-plane: Farkas' codes and everyday words
  std::vector<std::pair<std::string, Look>> looks;  // what `look.skin` may name, from light to dark
  std::vector<std::pair<std::string, Look>>
      hair_colours;  // what `look.hair` may name, with brows to go with it
  Greying greying;   // with age
  std::vector<LookWord> look_words, hair_colour_words, dial_words;  // in the file's order
  Names sided;  // places that stand on both sides, without _l or _r; pupils are none, they are no skin
  std::vector<LookWord> designs;  // what `design` may name, `real` first
  Names inked;                    // those of them that are drawn in ink where a file says nothing of it
  People people;                  // whom `random` draws from
};

// From templates/head/features.yaml, landmarks.yaml, looks.yaml and people.yaml of the data folder; what does
// not exist has no words.
HeadWords load_head_words(const std::filesystem::path& data_folder, Findings& findings);

// The colours of `entries` by their keys, each as "#rrggbb", and the dials, from 0 to 1; what is missing
// stays as it is.
void load_look_words(const YamlMapping& entries, Look& look);

// Sets the old colours of what the author gave no colour.
void set_greying(const Greying& greying, Look& look);

// Every word for a place: the middle ones, then each sided one alone, with _l and with _r.
Names list_places(const HeadWords& words);

}  // namespace mien
