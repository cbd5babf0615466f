// What a sheet is about: the second word of `mien sheet KIND FILE`, which for some kinds may be a name.
#pragma once

#include <map>
#include <string>

#include "config/stock.hpp"
#include "options.hpp"

namespace mien {

struct SheetSubject {
  Spec spec;                                   // of a name: the adult, with that library as `spec.library`
  Expression expression;                       // of `sheet heads`
  std::map<std::string, std::string> sources;  // of the libraries: in one line, where each is from
  int seed = 1;                                // of the first head of `sheet people`
  SpeechDataPointer speech = {};               // of `sheet mouths`
  Pose pose = {};                              // of a sheet of one face: what --express or --at asks for
  std::string words = {};                      // that, in words; empty: at rest
};

// `options.file` is the word: a FILE if there is one or if it ends as files do, else a name. A library may
// stand for `sheet expressions`, an expression for `sheet heads`; `sheet heads FILE` shows what --express
// says, else the face of the clip's poster. `sheet people` needs no word. Throws InputError: a wrong file's
// mistakes, an unknown name with the nearest known one, --express beside an expression's name.
SheetSubject load_sheet_subject(const Options& options, const Stock& stock);

}  // namespace mien
