// How people differ (templates/head/people.yaml), and one of them drawn from a seed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "config/findings.hpp"
#include "config/head_spec.hpp"
#include "config/words.hpp"

namespace mien {

// Two skulls that are each other's opposites.
struct SkullWay {
  std::string name, more, less;
  double spread = 0;  // standard deviation; 1 is `more` alone, -1 `less`
};

struct HairColour {
  glm::vec3 hair{0}, brow{0};
};

// One skin, and how often what goes with it is found.
struct PeoplesSkin {
  Look look;
  double share = 0;  // of all people, against the other skins' shares
  std::map<std::string, double> hairs, irises;
  double freckled = 0;  // share of these people who have freckles
};

struct CutShares {
  double women = 0, men = 0;
};

// All that can be drawn is one normal number each, a dial: character, tone, the skull's ways, the features.
// Standard deviations are in the dial's own unit.
struct People {
  double most = 0;  // standard deviations from the middle
  double character_middle = 0, character_spread = 0;
  std::vector<SkullWay> skulls;
  double most_skull = 1;  // of the skulls' weights together; the rest is average
  std::vector<std::pair<std::string, double>> features;  // with their standard deviations
  std::vector<PeoplesSkin> skins;                        // from light to dark
  std::map<std::string, HairColour> hair_colours;
  std::map<std::string, glm::vec3> irises;
  double shade = 0;  // how much lighter or darker hair may be, as a share
  std::map<std::string, CutShares> cuts;
  CutShares other_cuts;
  std::map<std::string, double> beards;          // of men
  double least_freckles = 0, most_freckles = 0;  // of who has some
  std::vector<std::string> dials;                // character, tone, the ways of the skull, the features
  // Correlations of the dials, and the lower triangular root of them (Cholesky): numbers that go together are
  // this root times numbers that do not. Rows and columns are dials.
  std::vector<std::vector<double>> together, root;
};

// What people.yaml may name.
struct PeopleWords {
  Names features;
  std::vector<std::pair<std::string, Look>> looks;  // of looks.yaml
};

// Reads `file` and adds its mistakes to the findings at their places: unknown words, numbers out of their
// ranges, correlations that contradict each other. Without the file nobody differs.
People load_people(const std::filesystem::path& file, const PeopleWords& words, Findings& findings);

// Where a person stands on each dial, in standard deviations, at most `people.most`; the first is
// `character`. The same on every machine.
std::vector<double> draw_dials(const People& people, std::uint64_t seed, double character);

// Fills in what head.said does not hold: skull, character, features, look and the cut of hair, which suits
// the character that the head has then. All numbers are in hundredths and all colours in whole bytes, so that
// they can be written out.
void draw_person(const People& people, std::uint64_t seed, HeadSpec& head);

}  // namespace mien
