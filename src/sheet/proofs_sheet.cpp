#include "sheet/proofs_sheet.hpp"

#include <array>

#include "clip/outputs.hpp"
#include "core/text.hpp"
#include "render/process.hpp"
#include "render/progress.hpp"
#include "render/work_folder.hpp"
#include "sheet/proof.hpp"

namespace mien {

namespace {

struct FaceFigure {
  const char* number;
  const char* title;
  std::vector<std::string> names;
};

}  // namespace

SheetFiles write_proofs(const Options& options, const Resources& resources) {
  const OutputFile output = find_output_file(options, std::filesystem::path("out") / "proofs" / "index.html");
  check_ending(output, "page", {".html"});
  check_output_files({output}, {});
  const std::vector<FaceFigure> faces{{"6-7", "At rest", {"neutral"}},
                                      {"6-8", "Joy", {"smile", "laugh"}},
                                      {"6-9", "Anger", {"anger"}},
                                      {"6-10", "Surprise", {"surprise", "shout"}},
                                      {"6-11", "Fear", {"fear"}},
                                      {"6-12", "Sadness", {"sadness"}},
                                      {"6-13", "Doubt", {"doubt_left", "doubt_right"}}};
  constexpr std::array kSkullFigures{std::pair("6-1", "square"), std::pair("6-2", "round"),
                                     std::pair("6-3", "wide"), std::pair("6-4", "narrow")};
  constexpr std::array kAgeFigures{std::pair("6-5", "adult"), std::pair("6-6", "child")};
  const int jobs = count_jobs(options);
  Progress progress(stderr, compute_progress_style(stderr, options.is_quiet, options.is_json), "figures",
                    static_cast<int>(kSkullFigures.size() + kAgeFigures.size() + faces.size() + 2));
  std::vector<Proof> proofs;
  const auto add = [&](Proof proof) {
    throw_if_interrupted();
    proofs.push_back(std::move(proof));
    progress.advance(false, static_cast<int>(proofs.size()));
  };
  for (const auto& [number, skull] : kSkullFigures) add(prove_skull(resources, number, skull, jobs));
  for (const auto& [number, age] : kAgeFigures) add(prove_guides(resources, number, age, jobs));
  add(prove_growth(resources));
  for (const FaceFigure& face : faces)
    add(prove_expressions(resources, face.number, face.title, face.names, jobs));
  add(prove_clip(resources));
  progress.finish();
  remove_left_parts_of(output.path);
  write_file(output.path, build_proof_page(proofs));
  return {{output.path}, {}};
}

}  // namespace mien
