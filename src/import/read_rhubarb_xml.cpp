// Rhubarb Lip Sync's XML: rhubarbResult has mouthCues, and those a mouthCue with start, end and a shape each.
// Source: DanielSWolf/rhubarb-lip-sync README, "XML format". Of XML this reads tags, attributes, text and
// comments; shapes and times have no entities.
#include <fmt/format.h>
#include <algorithm>

#include "import/mouth_reading.hpp"

namespace mien {

namespace {

constexpr std::size_t kDeepestXml = 16;  // elements within each other; Rhubarb writes three

struct XmlAttribute {
  MouthWord name, value;
};

// What comes next: the text up to a tag, or a tag.
struct XmlPart {
  enum class Kind { text, open, close } kind = Kind::text;
  MouthWord word;  // the text, or the tag's name
  std::vector<XmlAttribute> attributes;
  bool is_closed = false;  // <name/>
};

struct XmlReader {
  const MouthText& text;
  std::size_t at = 0;
  XmlPart part;
};

std::string_view find_rest(const XmlReader& xml) { return std::string_view(xml.text.text).substr(xml.at); }

// Moves on behind `end`, which closes what was opened here.
void skip_xml_past(XmlReader& xml, std::string_view end) {
  const std::size_t found = xml.text.text.find(end, xml.at);
  if (found == std::string::npos)
    fail_at(xml.text, xml.at, fmt::format("nothing closes this; expected '{}' behind it", end));
  xml.at = found + end.size();
}

void skip_xml_blanks(XmlReader& xml) {
  xml.at = std::min(xml.text.text.find_first_not_of(" \t\n", xml.at), xml.text.text.size());
}

MouthWord read_xml_name(XmlReader& xml) {
  const std::string_view rest = find_rest(xml);
  const MouthWord name{rest.substr(0, rest.find_first_of(" \t\n<>/=\"'")), xml.at};
  if (name.word.empty()) fail_at(xml.text, xml.at, "no name stands here; expected XML as Rhubarb writes it");
  xml.at += name.word.size();
  return name;
}

MouthWord read_xml_value(XmlReader& xml) {
  skip_xml_blanks(xml);
  if (!find_rest(xml).starts_with('='))
    fail_at(xml.text, xml.at, "an attribute has no value; expected =\"..\"");
  ++xml.at;
  skip_xml_blanks(xml);
  const std::string_view rest = find_rest(xml);
  if (!rest.starts_with('"') && !rest.starts_with('\''))
    fail_at(xml.text, xml.at, "a value without quotes; expected \"..\"");
  const std::size_t begin = xml.at;
  ++xml.at;
  const std::size_t end = xml.text.text.find_first_of({rest.front(), '<'}, xml.at);
  if (end == std::string::npos || xml.text.text[end] == '<')
    fail_at(xml.text, begin, "nothing closes this quote; expected one more");
  xml.at = end + 1;
  return {rest.substr(1, end - begin - 1), begin + 1};
}

void read_xml_tag(XmlReader& xml) {
  const std::size_t begin = xml.at;
  ++xml.at;
  XmlPart& part = xml.part;
  part.kind = XmlPart::Kind::open;
  if (find_rest(xml).starts_with('/')) {
    part.kind = XmlPart::Kind::close;
    ++xml.at;
  }
  part.word = read_xml_name(xml);
  while (true) {
    skip_xml_blanks(xml);
    const std::string_view rest = find_rest(xml);
    if (rest.empty()) fail_at(xml.text, begin, "nothing closes this tag; expected '>'");
    part.is_closed = part.kind == XmlPart::Kind::open && rest.starts_with("/>");
    if (part.is_closed || rest.starts_with('>')) {
      xml.at += part.is_closed ? 2 : 1;
      return;
    }
    const MouthWord name = read_xml_name(xml);
    part.attributes.push_back({name, read_xml_value(xml)});
  }
}

// False at the end of the file.
bool read_xml_part(XmlReader& xml) {
  xml.part = {};
  while (true) {
    const std::string_view rest = find_rest(xml);
    if (rest.empty()) return false;
    if (rest.starts_with("<!--")) {
      skip_xml_past(xml, "-->");
    } else if (rest.starts_with("<?")) {
      skip_xml_past(xml, "?>");
    } else if (rest.starts_with('<')) {
      read_xml_tag(xml);
      return true;
    } else {
      xml.part.word = trim_word({rest.substr(0, rest.find('<')), xml.at});
      xml.at += std::min(rest.find('<'), rest.size());
      if (!xml.part.word.word.empty()) return true;
    }
  }
}

double parse_xml_time(const MouthText& text, const XmlPart& tag, std::string_view name) {
  for (const XmlAttribute& attribute : tag.attributes)
    if (attribute.name.word == name) return parse_seconds(text, attribute.value);
  fail_at(text, tag.word.at,
          fmt::format("a cue without '{}'; expected <mouthCue start=\"0.1\" end=\"0.2\">A</mouthCue>", name));
}

struct XmlTrack {
  MouthTrack track;
  std::vector<MouthWord> open;  // names of the elements that are open
  double from_s = 0, to_s = 0;  // of the cue that is open
  MouthWord shape;
  bool has_root = false, has_cues = false;
};

bool is_within(const XmlTrack& xml, std::initializer_list<std::string_view> names) {
  return std::ranges::equal(xml.open, names, {}, &MouthWord::word);
}

void open_element(const MouthText& text, XmlTrack& xml, const XmlPart& tag) {
  if (xml.open.empty() && (xml.has_root || tag.word.word != "rhubarbResult"))
    fail_at(text, tag.word.at,
            fmt::format("an element '{}'; expected {}", show_words(tag.word.word),
                        xml.has_root ? "the end of the file" : "rhubarbResult"));
  xml.has_root = true;
  if (xml.open.size() >= kDeepestXml)
    fail_at(text, tag.word.at,
            fmt::format("more than {} elements within each other; expected fewer", kDeepestXml));
  xml.open.push_back(tag.word);
  if (is_within(xml, {"rhubarbResult", "mouthCues"})) xml.has_cues = true;
  if (!is_within(xml, {"rhubarbResult", "mouthCues", "mouthCue"})) return;
  xml.from_s = parse_xml_time(text, tag, "start");
  xml.to_s = parse_xml_time(text, tag, "end");
  xml.shape = {{}, tag.word.at};
}

void close_element(const MouthText& text, XmlTrack& xml) {
  if (is_within(xml, {"rhubarbResult", "mouthCues", "mouthCue"})) {
    check_mouth_name(text, MouthNames::rhubarb, xml.shape);
    append_cue(text, xml.track.cues, xml.open.back().at, xml.from_s, xml.to_s, std::string(xml.shape.word));
  }
  xml.open.pop_back();
}

void close_element_by_tag(const MouthText& text, XmlTrack& xml, MouthWord name) {
  const std::string open = xml.open.empty() ? "" : show_words(xml.open.back().word);
  if (xml.open.empty())
    fail_at(text, name.at,
            fmt::format("'{}' is closed here, and nothing is open; expected the end of the file",
                        show_words(name.word)));
  if (xml.open.back().word != name.word)
    fail_at(text, name.at,
            fmt::format("'{}' is closed here, and '{}' is open; expected </{}>", show_words(name.word), open,
                        open));
  close_element(text, xml);
}

void take_xml_text(const MouthText& text, XmlTrack& xml, MouthWord word) {
  if (xml.open.empty())
    fail_at(text, word.at,
            fmt::format("'{}'; expected {}", show_words(word.word),
                        xml.has_root ? "the end of the file" : "<rhubarbResult>"));
  if (is_within(xml, {"rhubarbResult", "mouthCues", "mouthCue"})) xml.shape = word;
  if (is_within(xml, {"rhubarbResult", "metadata", "duration"})) xml.track.end_s = parse_seconds(text, word);
}

}  // namespace

MouthTrack read_rhubarb_xml(const MouthText& text) {
  XmlReader reader{text, 0, {}};
  XmlTrack xml;
  while (read_xml_part(reader)) {
    const XmlPart& part = reader.part;
    if (part.kind == XmlPart::Kind::text) {
      take_xml_text(text, xml, part.word);
    } else if (part.kind == XmlPart::Kind::close) {
      close_element_by_tag(text, xml, part.word);
    } else {
      open_element(text, xml, part);
      if (part.is_closed) close_element(text, xml);
    }
  }
  if (!xml.open.empty())
    fail_at_end(text, fmt::format("the file ends here, within '{}'; expected </{}>",
                                  show_words(xml.open.back().word), show_words(xml.open.back().word)));
  if (!xml.has_cues) fail_at_end(text, "the file ends here without mouthCues; expected what Rhubarb writes");
  if (!xml.track.cues.empty()) xml.track.end_s = std::max(xml.track.end_s, xml.track.cues.back().to_s);
  return std::move(xml.track);
}

}  // namespace mien
