// Seeded damage to good files: the answer is a Spec or an InputError with a place, and nothing else.
#include <random>

#include "config/config_fixture.hpp"
#include "fuzz_rounds.hpp"

namespace mien {
namespace {

std::vector<std::string> load_good_texts() {
  std::vector<std::filesystem::path> files{kData / "templates/new.yaml"};
  for (const auto& entry : std::filesystem::directory_iterator(kData / "configs"))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> texts;
  for (const auto& file : files) texts.push_back(read_file(file));
  return texts;
}

const std::string kYamlLetters = "{}[]:,-#&*!|>'\"%@`?~ \n\t0.\\\xC3\x80s",
                  kTableLetters = "00123456789.,-e \n";

// Replaces, inserts, removes or repeats at a few places; letters of the file's grammar are the likeliest.
std::string damage(std::string text, const std::string& letters, std::mt19937& random) {
  const auto pick = [&](std::size_t below) {
    return std::uniform_int_distribution<std::size_t>(0, below - 1)(random);
  };
  for (std::size_t i = 0, count = 1 + pick(4); i < count && !text.empty(); ++i) {
    const std::size_t at = pick(text.size());
    switch (pick(5)) {
      case 0:
        text[at] = letters[pick(letters.size())];
        break;
      case 1:
        text.insert(at, 1, letters[pick(letters.size())]);
        break;
      case 2:
        text.erase(at, 1 + pick(8));
        break;
      case 3:
        text.insert(at, text.substr(pick(text.size()), pick(40)));
        break;
      default:
        text[at] = static_cast<char>(pick(256));
    }
  }
  return text;
}

// 1 if the file is good; of what is wrong every mistake has a place.
int try_file(const std::filesystem::path& file, const std::string& text) {
  try {
    const Spec spec = load_spec(file, *find_language());
    EXPECT_GE(count_frames(spec.clip), 1);
    return 1;
  } catch (const InputError& error) {
    EXPECT_FALSE(error.diagnostics.empty());
    for (const Diagnostic& diagnostic : error.diagnostics) {
      EXPECT_GE(diagnostic.place.line, 1) << text;
      EXPECT_GE(diagnostic.place.column, 1) << text;
      EXPECT_FALSE(diagnostic.message.empty());
    }
  } catch (const std::exception& error) {
    ADD_FAILURE() << error.what() << "\n" << text;
  }
  return 0;
}

TEST(fuzz, gives_a_spec_or_mistakes_with_a_place) {
  const std::vector<std::string> texts = load_good_texts();
  const auto file = make_test_folder() / "fuzz.yaml";
  std::mt19937 random(find_fuzz_seed(1990));
  int good = 0;
  const int rounds = count_fuzz_rounds(2000);
  for (int round = 0; round < rounds; ++round) {
    const std::string text =
        damage(texts[static_cast<std::size_t>(round) % texts.size()], kYamlLetters, random);
    write_file(file, text);
    good += try_file(file, text);
  }
  EXPECT_GT(good, rounds / 20);
  EXPECT_LT(good, rounds - rounds / 20);
}

TEST(fuzz, tables_give_a_spec_or_mistakes_with_a_place) {
  const auto folder = make_test_folder();
  const std::string whole = read_file(kData / "configs/talk.csv");
  write_file(folder / "fuzz_table.yaml", "mien: 1\nclip: {tracks: [{csv: fuzz_table.csv}]}\n");
  std::mt19937 random(find_fuzz_seed(7));
  int good = 0;
  const int rounds = count_fuzz_rounds(400);
  for (int round = 0; round < rounds; ++round) {
    const std::string text = damage(whole, kTableLetters, random);
    write_file(folder / "fuzz_table.csv", text);
    good += try_file(folder / "fuzz_table.yaml", text);
  }
  EXPECT_GT(good, rounds / 100) << "a table bears little";
  EXPECT_LT(good, rounds - rounds / 20);
}

}  // namespace
}  // namespace mien
