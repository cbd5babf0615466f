#include "sheet/compare_sheet.hpp"
#include "scene/surface_look.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "clip/outputs.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "head/landmarks.hpp"
#include "head/surface.hpp"
#include "render/work_folder.hpp"
#include "sheet/asked_face.hpp"
#include "sheet/camera.hpp"
#include "sheet/comparison.hpp"
#include "sheet/face_word.hpp"
#include "sheet/head_pictures.hpp"
#include "sheet/layout.hpp"
#include "sheet/wire_head.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr std::pair kFace_px{420, 500};
constexpr double kProfile_deg = 90, kHeatAside_deg = 35;
constexpr std::array<std::uint8_t, 3> kFirstInk{38, 34, 31}, kSecondInk{184, 38, 26};
constexpr int kHeatShades = 64;

// One of the two, built and posed.
struct ComparedFace {
  Spec spec;
  AskedFace face;
  std::string words;  // "anna, smile"
  Figure figure;
  Drawing drawing;
  HeadMeasures measures;
  std::map<std::string, glm::dvec3> landmarks;  // in the pose
};

ComparedFace build_compared(const Options& options, const std::string& word, const Resources& resources) {
  const Options own = take_face_word(options, word);
  const Clip clip = open_clip(own, *resources.stock.language);
  ComparedFace compared;
  compared.spec = clip.spec;
  try {
    compared.face = find_asked_face(own, clip, resources);
  } catch (const InputError& e) {
    throw InputError(fmt::format("{}: {}", word, e.what()));
  }
  const std::string title = find_sheet_title(clip.spec);
  compared.words = compared.face.words.empty() ? title : title + ", " + compared.face.words;
  compared.figure = build_figure(resources.heads, compared.face.head);
  DeformBuffers buffers;
  deform_figure(compared.figure, compared.face.pose, {}, buffers, compared.drawing);
  compared.measures = measure_head(compared.figure);
  compared.landmarks = measure_landmarks(compared.figure.head, find_landmarks(compared.figure.head),
                                         compared.figure.model, compared.drawing);
  return compared;
}

// The skin without what folds add to it: the vertices that all heads have.
Mesh build_common_skin(const ComparedFace& compared) {
  const Surface& surface = *compared.figure.head.surface;
  const PartShape& drawn = compared.drawing.parts.front();
  const auto count = static_cast<std::ptrdiff_t>(surface.vertex_count());
  Mesh skin{{drawn.positions.begin(), drawn.positions.begin() + count},
            {drawn.normals.begin(), drawn.normals.begin() + count},
            {}};
  skin.triangles = split_quads(surface, skin.positions);
  return skin;
}

SheetTable build_landmark_table(const std::vector<LandmarkDistance>& distances, double unit_mm) {
  constexpr std::size_t kColumnsAcross = 3;
  SheetTable table;
  table.has_header = true;
  for (std::size_t i = 0; i < kColumnsAcross; ++i)
    for (const auto& [share, align] :
         {std::pair(0.34, 0.0), {0.12, 1.0}, {0.12, 1.0}, {0.12, 1.0}, {0.13, 1.0}, {0.13, 1.0}, {0.04, 1.0}})
      table.columns.emplace_back(share / kColumnsAcross, align);
  const auto add = [](std::vector<SheetField>& row, const std::vector<std::string>& words) {
    for (const std::string& word : words) row.push_back({word});
    row.push_back({""});  // air before the next
  };
  std::vector<SheetField>& header = table.rows.emplace_back();
  for (std::size_t i = 0; i < kColumnsAcross; ++i)
    add(header, {"landmark", "left", "up", "forward", "mm", "units"});
  const std::size_t count = (distances.size() + kColumnsAcross - 1) / kColumnsAcross;
  for (std::size_t r = 0; r < count; ++r) {
    std::vector<SheetField>& row = table.rows.emplace_back();
    for (std::size_t i = 0; i < kColumnsAcross; ++i) {
      if (r + i * count >= distances.size()) {
        add(row, {"", "", "", "", "", ""});
        continue;
      }
      const LandmarkDistance& d = distances[r + i * count];
      add(row, {build_caption(d.name), fmt::format("{:+.1f}", d.way_mm.x), fmt::format("{:+.1f}", d.way_mm.y),
                fmt::format("{:+.1f}", d.way_mm.z), fmt::format("{:.1f}", d.mm),
                fmt::format("{:.3f}", d.mm / unit_mm)});
    }
  }
  return table;
}

SheetCell build_cell(const std::string& caption, double angle_deg) {
  SheetCell cell{caption};
  cell.angle_deg = angle_deg;
  return cell;
}

// Where the farthest place is, by the nearest landmark.
std::string find_nearest_landmark(const std::map<std::string, glm::dvec3>& landmarks,
                                  const glm::vec3& place) {
  std::string nearest;
  double least_mm = 1e9;
  for (const auto& [name, at] : landmarks)
    if (const double far_mm = glm::distance(at, glm::dvec3(place)); far_mm < least_mm) {
      least_mm = far_mm;
      nearest = name;
    }
  return build_caption(nearest);
}

SheetPlan plan_compare(const ComparedFace& first, const ComparedFace& second, const SkinDistances& distances,
                       double scale_mm) {
  SheetPlan plan;
  plan.subject = "Two faces compared";
  plan.cell_px = kFace_px;
  plan.blocks.resize(3);
  plan.blocks[0].heading = first.words + ", and " + second.words;
  plan.blocks[0].cells = {build_cell("first: front", 0), build_cell("first: side", kProfile_deg),
                          build_cell("second: front", 0), build_cell("second: side", kProfile_deg)};
  plan.blocks[1].heading = "Over each other";
  plan.blocks[1].note = fmt::format(
      "the same place of the skin is {} mm away on average, {} mm at most, by {}",
      format_number(distances.mean_mm, 2), format_number(distances.most_mm, 2),
      find_nearest_landmark(first.landmarks, first.drawing.parts.front().positions[distances.most]));
  const std::string heat = fmt::format("0 to {} mm", format_number(scale_mm, 2));
  plan.blocks[1].cells = {build_cell("black first, red second", 0), build_cell("from the side", kProfile_deg),
                          build_cell("distance, " + heat, 0),
                          build_cell("distance, three-quarter", kHeatAside_deg)};
  const double unit_mm = first.measures.height_mm() / 3.5;
  plan.blocks[2].heading = "Landmarks";
  plan.blocks[2].note =
      fmt::format("from the first to the second, 1 unit is {} mm, of which the first is 3.5 high",
                  format_number(unit_mm, 1));
  plan.blocks[2].table =
      build_landmark_table(measure_landmark_distances(first.landmarks, second.landmarks), unit_mm);
  return plan;
}

// The first skin in the colours of the distances.
struct HeatFigure {
  Model model;
  Drawing drawing;
  SketchLook look;
};

HeatFigure build_heat_figure(const Mesh& skin, const SkinDistances& distances, double scale_mm) {
  // Half of it glows, so that a colour means the same in light and shade and the form is still seen.
  constexpr float kGlow = 0.5f;
  HeatFigure heat;
  Part part;
  part.name = part.material = "skin";
  part.rest = skin;
  SketchPart look;
  for (int i = 0; i < kHeatShades; ++i) {
    const glm::vec3 srgb = find_heat(static_cast<double>(i) / (kHeatShades - 1));
    part.palette.push_back({srgb, 0});
    SketchTexture texture;
    texture.pigment.colour.rgb = {linearize(srgb.x), linearize(srgb.y), linearize(srgb.z)};
    texture.finish.diffuse = 1 - kGlow;
    texture.finish.emission = glm::vec3(kGlow);
    look.textures.push_back(texture);
  }
  for (const float mm : distances.mm)
    part.shade.push_back(static_cast<std::uint16_t>(std::clamp(
        std::lround(static_cast<double>(mm) / scale_mm * (kHeatShades - 1)), 0L, kHeatShades - 1L)));
  heat.drawing.parts.push_back({skin.positions, skin.normals, {}, glm::mat4(1)});
  heat.model.parts.push_back(std::move(part));
  heat.look.parts.push_back(std::move(look));
  return heat;
}

// Contours and features of one face in one colour, over what is there.
void draw_outline(const ComparedFace& compared, const WireCamera& camera,
                  const std::array<std::uint8_t, 3>& srgb, const glm::dvec2& corner_px, int jobs,
                  Paper& paper) {
  WireModel model;
  append_wire_head(compared.figure, {compared.face.pose, {}, glm::dmat4(1)}, {}, model);
  std::erase_if(model.lines, [](const WireLine& line) { return line.pen == Pen::mesh; });
  PenLooks looks = get_pen_looks();
  for (PenLook& look : looks) look.srgb = srgb;
  draw_wire(model, camera, looks, corner_px, jobs, paper);
}

// What the colours mean, below the picture's lower left corner.
void append_scale(const glm::dvec2& corner_px, const std::pair<int, int>& cell_px, Paper& paper) {
  const double width = 0.4 * cell_px.first, height = 0.018 * cell_px.second;
  const glm::dvec2 left = corner_px + glm::dvec2(0.04 * cell_px.first, 0.965 * cell_px.second);
  for (int i = 0; i < kHeatShades; ++i) {
    const glm::vec3 srgb = 255.0f * find_heat(static_cast<double>(i) / (kHeatShades - 1));
    const double step = width / kHeatShades;
    PaperStroke stroke{{left + glm::dvec2(i * step, 0), left + glm::dvec2((i + 1) * step, 0)}, height, {}};
    for (int c = 0; c < 3; ++c) stroke.srgb[static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(srgb[c]);
    paper.strokes.push_back(stroke);
  }
}

}  // namespace

SheetFiles write_compare_sheet(const Options& options, const Resources& resources) {
  const ComparedFace first = build_compared(options, options.file.string(), resources);
  const ComparedFace second = build_compared(options, options.other.string(), resources);
  const OutputFile output =
      find_output_file(options, fs::path("out") / first.spec.name / "sheet_compare.png");
  check_ending(output, "picture", {".png"});
  check_output_files({output}, first.spec);
  check_output_files({output}, second.spec);

  const Mesh skin = build_common_skin(first), other = build_common_skin(second);
  const SkinDistances distances = measure_distances(skin, other.positions);
  const double scale_mm = find_scale_end(distances.most_mm);
  const SheetPlan plan = plan_compare(first, second, distances, scale_mm);
  const std::pair<int, int> cell_px = options.size_px.value_or(plan.cell_px);
  const SheetLayout layout = build_sheet_layout(plan, find_sheet_title(first.spec), cell_px);
  check_sheet_page(layout);

  Paper paper;
  append_plate(layout.plate, paper);
  const PictureSize size{cell_px.first, cell_px.second};
  // Both are seen by one camera, which the first head places.
  const auto find_view = [&](std::size_t block, std::size_t cell) {
    return compute_cell_view(plan.blocks[block].cells[cell], first.measures, first.measures);
  };
  const auto find_corner = [&](std::size_t place) {
    return glm::dvec2(layout.places[place].left_px, layout.places[place].top_px);
  };
  for (std::size_t i = 0; i < 2; ++i) {
    const WireCamera camera = build_wire_camera(find_view(1, i), size);
    draw_outline(first, camera, kFirstInk, find_corner(4 + i), count_jobs(options), paper);
    draw_outline(second, camera, kSecondInk, find_corner(4 + i), count_jobs(options), paper);
  }
  Pixels page = build_paper_pixels(paper, find_letters(resources.stock.templates));
  HeadStage stage = build_head_stage(size, resources.stock.templates);
  const HeatFigure heat = build_heat_figure(skin, distances, scale_mm);
  const auto paste = [&](const Pixels& picture, std::size_t place) {
    paste_pixels(page, picture, layout.places[place].left_px, layout.places[place].top_px);
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const ComparedFace& shown = i < 2 ? first : second;
    paste(sketch_head(stage, find_view(0, i), shown.figure.model, shown.drawing), i);
  }
  for (std::size_t i = 2; i < 4; ++i)
    paste(sketch_head(stage, find_view(1, i), heat.model, heat.drawing, &heat.look), 4 + i);
  Paper scale;
  append_scale(find_corner(6), cell_px, scale);
  draw_strokes(scale.strokes, page);

  remove_left_parts_of(output.path);
  write_file(output.path, build_png(page));
  SheetFiles files{{output.path}, first.face.held};
  files.held.insert(files.held.end(), second.face.held.begin(), second.face.held.end());
  return files;
}

}  // namespace mien
