// Parke's conformation parameters in the features of our heads: words, and no form of their own.
//
// Source: F. I. Parke, "Parameterized models for facial animation" (IEEE CG&A, 1982): what shapes a face and
// does not move it. The parameters are those that his papers and the thesis name, but for the colours, which
// `look` has, and the length of the neck; how far each goes is that of our features.
#pragma once

#include <array>
#include <string_view>

namespace mien {

inline constexpr std::string_view kConformationKey = "conformation";

struct FeatureShare {
  std::string_view feature;  // of templates/head/features.yaml; empty: none
  double value = 0;          // at 1; as much the other way at -1
};

struct ConformationRow {
  std::string_view name;
  std::string_view meaning;
  std::array<FeatureShare, 4> shares = {};
};

// The table is read across.
// clang-format off
inline constexpr std::array kConformationRows{
    ConformationRow{"head_aspect", "the head broader (+) or longer (-)", {{{"temple_width", 1}, {"cheekbones", 0.7}, {"jaw_width", 0.7}, {"chin_height", -0.6}}}},
    ConformationRow{"forehead_shape", "the forehead bulging (+) or lying back (-)", {{{"forehead", 1}, {"brow_ridge", -0.4}}}},
    ConformationRow{"forehead_scale", "the forehead broader (+) or narrower (-)", {{{"temple_width", 1}, {"forehead", 0.3}}}},
    ConformationRow{"jaw_width", "the jaw broader (+) or narrower (-)", {{{"jaw_width", 1}, {"jaw_angle", 0.4}}}},
    ConformationRow{"chin_shape", "the chin square (+) or pointed (-)", {{{"chin_width", 1}, {"chin_projection", 0.3}}}},
    ConformationRow{"chin_scale", "the chin larger (+) or smaller (-)", {{{"chin_height", 0.8}, {"chin_projection", 0.8}, {"chin_width", 0.4}}}},
    ConformationRow{"cheek_shape", "the cheeks full (+) or hollow (-)", {{{"cheek_fullness", 1}}}},
    ConformationRow{"cheekbone_shape", "the cheekbones high (+) or flat (-)", {{{"cheekbones", 1}}}},
    ConformationRow{"neck_width", "the neck thicker (+) or thinner (-)", {{{"neck_width", 1}}}},
    ConformationRow{"eye_size", "the eyes longer (+) or shorter (-)", {{{"eye_size", 1}}}},
    ConformationRow{"eye_separation", "the eyes further apart (+) or nearer (-)", {{{"eye_spacing", 1}}}},
    ConformationRow{"eye_position", "the eyes higher (+) or lower (-)", {{{"eye_height", 1}, {"brow_height", 0.5}}}},
    ConformationRow{"eyelid_size", "the upper lid's crease higher (+) or lower (-)", {{{"lid_crease", 1}}}},
    ConformationRow{"nose_length", "the nose longer (+) or shorter (-)", {{{"nose_length", 1}}}},
    ConformationRow{"nose_bridge", "the nose's bridge higher (+) or lower (-)", {{{"nose_bridge", 1}}}},
    ConformationRow{"nostril_width", "the nostrils broader (+) or narrower (-)", {{{"nose_width", 1}}}},
    ConformationRow{"mouth_width", "the mouth wider (+) or narrower (-)", {{{"mouth_width", 1}}}},
    ConformationRow{"mouth_scale", "the mouth larger (+) or smaller (-), its lips with it", {{{"mouth_width", 0.7}, {"lip_fullness", 0.8}}}},
};
// clang-format on

}  // namespace mien
