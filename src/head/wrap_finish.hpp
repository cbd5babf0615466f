// What a wrapped skin needs to be a head: its inside, its eyes, its size and its place.
#pragma once

#include "head/form.hpp"

namespace mien {

// Brings nostrils, mouth bag, lips' contact and eyeballs of `form`, the adult with another skin, in order;
// then makes it `growth` times as large and puts it where every head stands.
void finish_wrap(const HeadStock& stock, double growth, HeadForm& form);

}  // namespace mien
