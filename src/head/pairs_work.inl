// The loops of head/pairs.cpp, which includes this text twice: for any processor, and for those with wide
// registers. Nothing but sums, products, roots and quotients as IEEE 754 has them: the same bits from both.

inline Float8 load(const Twin& twin) {
  Float8 v;
  std::memcpy(&v, &twin, sizeof(v));
  return v;
}
inline void store(Twin& twin, const Float8& v) { std::memcpy(&twin, &v, sizeof(v)); }
inline void add(Twin& twin, const Float8& v) { store(twin, load(twin) + v); }

inline Float8 swap_halves(const Float8& v) { return __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3); }
inline Float8 turn_axes(const Float8& v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3, 5, 6, 4, 7); }
inline Float8 spread_x(const Float8& v) { return __builtin_shufflevector(v, v, 0, 0, 0, 0, 4, 4, 4, 4); }
inline Float8 spread_y(const Float8& v) { return __builtin_shufflevector(v, v, 1, 1, 1, 1, 5, 5, 5, 5); }
inline Float8 spread_z(const Float8& v) { return __builtin_shufflevector(v, v, 2, 2, 2, 2, 6, 6, 6, 6); }
inline Float8 spread_w(const Float8& v) { return __builtin_shufflevector(v, v, 3, 3, 3, 3, 7, 7, 7, 7); }

// As the same of Float4: of the first three of either half.
inline Float8 cross_pair(const Float8& a, const Float8& b) {
  return turn_axes(a * turn_axes(b) - turn_axes(a) * b);
}
inline Float8 dot_pair(const Float8& a, const Float8& b) {
  const Float8 products = a * b;
  return spread_x(products) + spread_y(products) + spread_z(products);
}
inline Float8 normalize_pair(const Float8& v, float least_square, const Float8& other) {
  const Float8 squares = dot_pair(v, v);
  const float left = squares[0], right = squares[4];
  if (left > least_square && right > least_square) {
    const float l = 1 / std::sqrt(left), r = 1 / std::sqrt(right);
    return v * Float8{l, l, l, l, r, r, r, r};
  }
  Float8 unit = other;
  if (left > least_square)
    for (int i = 0; i < 4; ++i) unit[i] = v[i] * (1 / std::sqrt(left));
  if (right > least_square)
    for (int i = 4; i < 8; ++i) unit[i] = v[i] * (1 / std::sqrt(right));
  return unit;
}

// What a place of the mid-plane gets of a left face and of its mirror image: both at once, as a mirrored pose
// adds them.
inline Float8 add_halves(const Float8& v) { return v + swap_halves(v); }

// Mirror images are added to each other first, so that a mirrored pose gives the same sum.
inline Float8 sum_on_midline(const Surface& surface, std::uint32_t v, const Twin* points) {
  Float8 sum{};
  for (std::uint32_t k = surface.first[v]; k < surface.first[v + 1]; ++k) {
    const std::uint32_t point = surface.point[k];
    if (surface.mirror[point] == point) {
      sum += surface.weight[k] * load(points[point]);
    } else {  // the next one is its image; see pair_row
      sum += surface.weight[k] * add_halves(load(points[point]));
      ++k;
    }
  }
  return sum;
}

[[gnu::noinline]] void deform(const Surface& surface, const Twin* points, Twin* places) {
  const std::size_t count = surface.pairs.size();
  for (std::size_t slot = 0; slot < count; ++slot) {
    const MirrorPair pair = surface.pairs[slot];
    if (pair.is_middle()) {
      store(places[slot], sum_on_midline(surface, pair.left, points));
      continue;
    }
    // A row and its mirror image have the same weights. Sums that do not wait for each other are quicker.
    const std::uint32_t first = surface.first[pair.left], size = surface.first[pair.left + 1] - first;
    const float* weight = surface.weight.data() + first;
    const std::uint32_t* point = surface.point.data() + first;
    Float8 even{}, odd{};
    for (std::uint32_t k = 0; k + 1 < size; k += 2) {
      even += weight[k] * load(points[point[k]]);
      odd += weight[k + 1] * load(points[point[k + 1]]);
    }
    if (size % 2 != 0) even += weight[size - 1] * load(points[point[size - 1]]);
    store(places[slot], even + odd);
  }
}

[[gnu::noinline]] void add_areas(const Surface& surface, const Twin* places, Twin* sums) {
  // A mirror image goes round the other way: one of its diagonals is turned.
  const Float8 turned{1, 1, 1, 1, -1, -1, -1, -1};
  for (const PairedQuad& quad : surface.pair_quads) {
    const auto& [a, b, c, d] = quad.slots;
    // Twice the quad's area vector: the cross product of its diagonals.
    const Float8 area = cross_pair(load(places[c]) - load(places[a]), (load(places[d]) - load(places[b])) * turned);
    if (quad.middle == 0) {
      add(sums[a], area);
      add(sums[b], area);
      add(sums[c], area);
      add(sums[d], area);
      continue;
    }
    const Float8 both = add_halves(area);
    for (std::size_t i = 0; i < 4; ++i) add(sums[quad.slots[i]], (quad.middle >> i & 1) != 0 ? both : area);
  }
}

[[gnu::noinline]] void normalize_all(Twin* normals, std::size_t count) {
  const Float8 forward{0, 0, 1, 0, 0, 0, 1, 0};
  for (std::size_t i = 0; i < count; ++i) store(normals[i], normalize_pair(load(normals[i]), 1e-20f, forward));
}

[[gnu::noinline]] void append_fine(const FineSkin& fine, Twin* places, Twin* normals) {
  std::size_t slot = fine.base_pairs;
  for (const auto& [a, b] : fine.pair_parents) {
    const Float8 pa = load(places[a]), pb = load(places[b]), na = load(normals[a]), nb = load(normals[b]);
    const Float8 lift = dot_pair(pb - pa, nb) * nb - dot_pair(pb - pa, na) * na;
    store(places[slot], 0.5f * (pa + pb) + 0.125f * lift);
    store(normals[slot], normalize_pair(na + nb, 1e-12f, na));
    ++slot;
  }
}

// The slope of the heights over a triangle of places with heights as their fourth, weighted by its area
// squared (which needs no root), and that.
inline Float8 find_slope(const Float8& a, const Float8& b, const Float8& c) {
  const Float8 along = b - a, beside = c - a, normal = cross_pair(along, beside);
  const Float8 slope = cross_pair(spread_w(along) * beside - spread_w(beside) * along, normal);
  return __builtin_shufflevector(slope, dot_pair(normal, normal), 0, 1, 2, 11, 4, 5, 6, 15);
}

inline bool is_flat(const Float8& a, const Float8& b, const Float8& c) {
  return a[3] == 0 && b[3] == 0 && c[3] == 0 && a[7] == 0 && b[7] == 0 && c[7] == 0;
}

[[gnu::noinline]] void press(const std::vector<MirrorPair>& pairs,
                  const std::vector<Triangle>& triangles, float relief,
                  FoldPlaces& folded) {
  Twin *places = folded.places.data(), *normals = folded.normals.data(), *slopes = folded.slopes.data();
  for (const Triangle& corners : triangles) {
    const Float8 a = load(places[corners[0]]), b = load(places[corners[1]]), c = load(places[corners[2]]);
    if (is_flat(a, b, c)) continue;
    const Float8 slope = find_slope(a, b, c);
    for (const std::uint32_t corner : corners)
      add(slopes[corner], pairs[corner].is_middle() ? add_halves(slope) : slope);
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Float8 slope = load(slopes[i]), n = load(normals[i]), place = load(places[i]);
    store(places[i], place + relief * spread_w(place) * n);
    const float left = slope[3], right = slope[7];
    if (left > 1e-20f && right > 1e-20f) {
      const float l = 1 / left, r = 1 / right;
      store(normals[i], normalize_pair(n - slope * Float8{l, l, l, l, r, r, r, r}, 0, n));
      continue;
    }
    Float8 pressed = n;
    for (int half = 0; half < 8; half += 4) {
      if (!(slope[half + 3] > 1e-20f)) continue;
      const float by = 1 / slope[half + 3];
      const Float8 unit = normalize_pair(n - slope * Float8{by, by, by, by, by, by, by, by}, 0, n);
      for (int k = half; k < half + 4; ++k) pressed[k] = unit[k];
    }
    store(normals[i], pressed);
  }
}
