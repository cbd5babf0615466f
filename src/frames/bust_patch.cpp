#include "frames/bust_patch.hpp"

namespace mien {

namespace {

// A vertex of the grid or of its rims; column 0 and the last one are the corners.
std::uint32_t find_vertex(const Patch& patch, int column, int row) {
  const int last = patch.column_count();
  if (column == 0) return patch.upper.front();
  if (column == last) return patch.upper.back();
  return patch.first + static_cast<std::uint32_t>((column - 1) * (kPatchRows - 1) + row - 1);
}

// The grid's edge row along a rim, each of the rim's edges to kPatchFine of the grid's.
void append_rim(Mesh& mesh, const Patch& patch, bool is_upper) {
  const std::vector<std::uint32_t>& rim = is_upper ? patch.upper : patch.lower;
  const int row = is_upper ? 1 : kPatchRows - 1;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a == b || b == c || c == a) return;
    mesh.triangles.push_back(is_upper ? Triangle{a, b, c} : Triangle{a, c, b});
  };
  for (int i = 0; i + 1 < static_cast<int>(rim.size()); ++i) {
    const std::uint32_t left = find_vertex(patch, kPatchFine * i, row),
                        middle = find_vertex(patch, kPatchFine * i + 1, row),
                        right = find_vertex(patch, kPatchFine * (i + 1), row);
    add(rim[i], left, middle);
    add(rim[i], middle, rim[i + 1]);
    add(rim[i + 1], middle, right);
  }
}

}  // namespace

Patch append_patch(Mesh& mesh, const Slit& slit) {
  Patch patch;
  for (const SlitColumn& column : slit.columns) {
    patch.upper.push_back(column.upper.front());
    patch.lower.push_back(column.lower.front());
  }
  patch.first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.resize(mesh.positions.size() + patch.vertex_count());
  append_rim(mesh, patch, true);
  append_rim(mesh, patch, false);
  const int last = patch.column_count();
  for (int row = 1; row + 1 < kPatchRows; ++row) {
    const auto at = [&](int column, int down) { return find_vertex(patch, column, row + down); };
    mesh.triangles.push_back({at(0, 0), at(1, 1), at(1, 0)});
    for (int c = 1; c + 1 < last; ++c) {
      mesh.triangles.push_back({at(c, 0), at(c, 1), at(c + 1, 1)});
      mesh.triangles.push_back({at(c, 0), at(c + 1, 1), at(c + 1, 0)});
    }
    mesh.triangles.push_back({at(last - 1, 0), at(last - 1, 1), at(last, 0)});
  }
  return patch;
}

void place_patch(const Patch& patch, const std::function<glm::vec3(const PatchPlace&)>& place,
                 std::vector<glm::vec3>& positions) {
  const auto find_end = [&](const std::vector<std::uint32_t>& rim, int column) {
    const std::size_t i = static_cast<std::size_t>(column / kPatchFine);
    if (column % kPatchFine == 0) return positions[rim[i]];
    return 0.5f * (positions[rim[i]] + positions[rim[i + 1]]);
  };
  static_assert(kPatchFine == 2);  // a column lies on the rim's or in the middle of two
  for (int c = 1; c < patch.column_count(); ++c) {
    PatchPlace at{find_end(patch.upper, c), find_end(patch.lower, c)};
    for (int row = 1; row < kPatchRows; ++row) {
      at.row = row;
      at.down = float(row) / kPatchRows;
      positions[find_vertex(patch, c, row)] = place(at);
    }
  }
}

}  // namespace mien
