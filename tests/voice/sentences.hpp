// Twenty sentences in four languages, for tests.
#pragma once

#include <array>

namespace mien {

struct Sentence {
  const char* voice;
  const char* text;
};

inline constexpr std::array kSentences{
    Sentence{"en-us", "I'm fine."},
    Sentence{"en-us", "Bob may pump the map back up."},
    Sentence{"en-us", "Five very brave foxes leave the village."},
    Sentence{"en-us", "Who would have thought of you?"},
    Sentence{"en-us", "My mother baked apple pie for Bill."},
    Sentence{"en-gb", "Perhaps we had better begin before noon."},
    Sentence{"en-gb", "She sells sea shells by the shore."},
    Sentence{"en-gb", "Mind the gap between the train and the platform."},
    Sentence{"de", "Papa und Mama bauen am Abend ein Boot."},
    Sentence{"de", "Fischers Fritz fischt frische Fische."},
    Sentence{"de", "Wann kommst du bitte wieder heim?"},
    Sentence{"de", "Das Pferd frisst keinen Gurkensalat."},
    Sentence{"fr-fr", "Bonjour madame, vous parlez bien."},
    Sentence{"fr-fr", "Un bon vin blanc pour ma famille."},
    Sentence{"fr-fr", "Il a beaucoup plu ce matin."},
    Sentence{"fr-fr", "Je ne veux pas partir."},
    Sentence{"es", "Buenos días, mi buen amigo Pablo."},
    Sentence{"es", "Me gusta mucho el vino blanco."},
    Sentence{"es", "La mamá peina a su bebé."},
    Sentence{"es", "Por favor, vamos a comer."},
};

}  // namespace mien
