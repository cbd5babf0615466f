#include <fmt/format.h>

#include <algorithm>

#include "scene/strip.hpp"
#include "sheet/proof.hpp"

namespace mien {

namespace {

constexpr const char* kStyle =
    "body{margin:2.5em auto;max-width:64em;padding:0 1.5em;background:#f3f0e9;color:#26221f;"
    "font:16px/1.5 Georgia,'Times New Roman',serif}"
    "h1{font-weight:normal;font-size:2em;margin:0}"
    "h2{font-weight:normal;font-size:1.3em;margin:0 0 .3em}"
    "section{border-top:1px solid #bdb6a8;padding:1.4em 0}"
    "p{margin:.3em 0;max-width:46em}"
    "figure{display:inline-block;margin:.8em .7em 0 0;vertical-align:top}"
    "figure img{display:block}"
    "figcaption{font-size:.8em;color:#6d665d;text-align:center}"
    ".verdict{font-family:Helvetica,Arial,sans-serif;font-size:.88em}"
    ".met::before,.unmet::before{display:inline-block;min-width:4.6em;font-weight:bold}"
    ".met::before{content:'shown'}.unmet::before{content:'not shown';color:#b81e10}";

}  // namespace

std::string build_proof_page(const std::vector<Proof>& proofs) {
  const auto met = std::ranges::count(proofs, true, &Proof::is_met);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>Proofs</title>\n"
      "<style>{}</style>\n</head>\n<body>\n<h1>What chapter 6 shows, measured</h1>\n"
      "<p>The figures of Yen, <cite>Animation of Human Faces</cite>, Tamkang University, 1990, made anew by "
      "mien {}: {} of {} claims are shown. All numbers were measured when this page was made.</p>\n",
      kStyle, MIEN_VERSION, met, proofs.size());
  for (const Proof& proof : proofs) {
    std::string id = escape_xml(proof.number);  // ids have no blanks
    std::ranges::replace(id, ' ', '_');
    page += fmt::format(
        "<section id=\"f{5}\">\n<h2>{0} &nbsp; {1}</h2>\n<p>{2}</p>\n<p class=\"verdict {3}\">{4}</p>\n",
        escape_xml(proof.number), escape_xml(proof.title), escape_xml(proof.claim),
        proof.is_met ? "met" : "unmet", escape_xml(proof.verdict), id);
    for (const ProofPicture& picture : proof.pictures)
      page += fmt::format(
          "<figure><img alt=\"{0}\" "
          "src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
          escape_xml(picture.caption), encode_base64(picture.png));
    page += "</section>\n";
  }
  return page + "</body>\n</html>\n";
}

}  // namespace mien
