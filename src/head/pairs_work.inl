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
template <class Eight>
inline Eight spread_x(const Eight& v) {
  return __builtin_shufflevector(v, v, 0, 0, 0, 0, 4, 4, 4, 4);
}
template <class Eight>
inline Eight spread_y(const Eight& v) {
  return __builtin_shufflevector(v, v, 1, 1, 1, 1, 5, 5, 5, 5);
}
template <class Eight>
inline Eight spread_z(const Eight& v) {
  return __builtin_shufflevector(v, v, 2, 2, 2, 2, 6, 6, 6, 6);
}
template <class Eight>
inline Eight spread_w(const Eight& v) {
  return __builtin_shufflevector(v, v, 3, 3, 3, 3, 7, 7, 7, 7);
}

// As the same of Float4: of the first three of either half.
inline Float8 cross_pair(const Float8& a, const Float8& b) {
  return turn_axes(a * turn_axes(b) - turn_axes(a) * b);
}
inline Float8 dot_pair(const Float8& a, const Float8& b) {
  const Float8 products = a * b;
  return spread_x(products) + spread_y(products) + spread_z(products);
}
inline Float8 find_roots(const Float8& v) {
#if defined(MIEN_HAS_AVX)
  return __builtin_ia32_sqrtps256(v);
#else
  Float8 roots;
  for (int i = 0; i < 8; ++i) roots[i] = std::sqrt(v[i]);
  return roots;
#endif
}
inline Float8 normalize_pair(const Float8& v, float least_square, const Float8& other) {
  const Float8 squares = dot_pair(v, v);
  return squares > least_square ? v * (1 / find_roots(squares)) : other;
}

// Four at once: their squares fill one register, and one root and one division serve them all.
struct FourPairs {
  Float8 a, b, c, d;
};
inline FourPairs normalize_four(const FourPairs& v, float least_square, const FourPairs& other) {
  // Of either half, the x of all four, their y and their z.
  const Float8 low_ab = __builtin_shufflevector(v.a, v.b, 0, 8, 1, 9, 4, 12, 5, 13);
  const Float8 low_cd = __builtin_shufflevector(v.c, v.d, 0, 8, 1, 9, 4, 12, 5, 13);
  const Float8 high_ab = __builtin_shufflevector(v.a, v.b, 2, 10, 3, 11, 6, 14, 7, 15);
  const Float8 high_cd = __builtin_shufflevector(v.c, v.d, 2, 10, 3, 11, 6, 14, 7, 15);
  const Float8 x = __builtin_shufflevector(low_ab, low_cd, 0, 1, 8, 9, 4, 5, 12, 13);
  const Float8 y = __builtin_shufflevector(low_ab, low_cd, 2, 3, 10, 11, 6, 7, 14, 15);
  const Float8 z = __builtin_shufflevector(high_ab, high_cd, 0, 1, 8, 9, 4, 5, 12, 13);
  const Float8 squares = x * x + y * y + z * z;
  const auto is_long = squares > least_square;
  const Float8 by = 1 / find_roots(squares);
  return {spread_x(is_long) ? v.a * spread_x(by) : other.a, spread_y(is_long) ? v.b * spread_y(by) : other.b,
          spread_z(is_long) ? v.c * spread_z(by) : other.c, spread_w(is_long) ? v.d * spread_w(by) : other.d};
}

inline FourPairs load_four(const Twin* twins) {
  return {load(twins[0]), load(twins[1]), load(twins[2]), load(twins[3])};
}
inline void store_four(Twin* twins, const FourPairs& v) {
  store(twins[0], v.a);
  store(twins[1], v.b);
  store(twins[2], v.c);
  store(twins[3], v.d);
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
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4)
    store_four(normals + i, normalize_four(load_four(normals + i), 1e-20f, {forward, forward, forward, forward}));
  for (; i < count; ++i) store(normals[i], normalize_pair(load(normals[i]), 1e-20f, forward));
}

// The place in the middle of an edge of two slots, by whose normals it is lifted.
inline Float8 find_middle(const Float8& pa, const Float8& pb, const Float8& na, const Float8& nb) {
  const Float8 lift = dot_pair(pb - pa, nb) * nb - dot_pair(pb - pa, na) * na;
  return 0.5f * (pa + pb) + 0.125f * lift;
}

[[gnu::noinline]] void append_fine(const FineSkin& fine, Twin* places, Twin* normals) {
  const std::size_t count = fine.pair_parents.size();
  // Normals four at once; parents that are middles themselves may stand in the same four, which then go one by one.
  const auto append = [&](std::size_t i) {
    const auto [a, b] = fine.pair_parents[i];
    const Float8 na = load(normals[a]), nb = load(normals[b]);
    store(places[fine.base_pairs + i], find_middle(load(places[a]), load(places[b]), na, nb));
    store(normals[fine.base_pairs + i], normalize_pair(na + nb, 1e-12f, na));
  };
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) {
    const auto* parents = fine.pair_parents.data() + i;
    const std::size_t slot = fine.base_pairs + i;
    if (std::max({parents[0][0], parents[0][1], parents[1][0], parents[1][1], parents[2][0], parents[2][1],
                  parents[3][0], parents[3][1]}) >= slot) {
      for (std::size_t k = i; k < i + 4; ++k) append(k);
      continue;
    }
    FourPairs from, sum;
    Float8* const first[4] = {&from.a, &from.b, &from.c, &from.d};
    Float8* const both[4] = {&sum.a, &sum.b, &sum.c, &sum.d};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [a, b] = parents[k];
      const Float8 na = load(normals[a]), nb = load(normals[b]);
      store(places[slot + k], find_middle(load(places[a]), load(places[b]), na, nb));
      *first[k] = na;
      *both[k] = na + nb;
    }
    store_four(normals + slot, normalize_four(sum, 1e-12f, from));
  }
  for (; i < count; ++i) append(i);
}

// The slope of the heights over a triangle of places with heights as their fourth, weighted by its area
// squared (which needs no root), and that.
inline Float8 find_slope(const Float8& a, const Float8& b, const Float8& c) {
  const Float8 along = b - a, beside = c - a, normal = cross_pair(along, beside);
  const Float8 slope = cross_pair(spread_w(along) * beside - spread_w(beside) * along, normal);
  return __builtin_shufflevector(slope, dot_pair(normal, normal), 0, 1, 2, 11, 4, 5, 6, 15);
}

// Whether all six heights are 0.
inline bool is_flat(const Float8& a, const Float8& b, const Float8& c) {
  const auto raised = (a != 0) | (b != 0) | (c != 0);
  return raised[3] == 0 && raised[7] == 0;
}

[[gnu::noinline]] void press(const std::vector<MirrorPair>& pairs, const std::vector<Triangle>& triangles,
                             float relief, FoldPlaces& folded) {
  Twin *places = folded.places.data(), *normals = folded.normals.data(), *slopes = folded.slopes.data();
  for (const Triangle& corners : triangles) {
    const Float8 a = load(places[corners[0]]), b = load(places[corners[1]]), c = load(places[corners[2]]);
    if (is_flat(a, b, c)) continue;
    const Float8 slope = find_slope(a, b, c);
    for (const std::uint32_t corner : corners)
      add(slopes[corner], pairs[corner].is_middle() ? add_halves(slope) : slope);
  }
  // The normal less the slope by its weight; where there is no weight, as it is. The one is told from the other
  // by the square, which is that of a normal or, with no weight, 0.
  const auto lean = [&](std::size_t i, Float8& leaning) {
    const Float8 slope = load(slopes[i]), n = load(normals[i]), place = load(places[i]);
    store(places[i], place + relief * spread_w(place) * n);
    const Float8 weight = spread_w(slope);
    leaning = weight > 1e-20f ? n - slope * (1 / weight) : Float8{};
    return n;
  };
  std::size_t i = 0;
  for (; i + 4 <= pairs.size(); i += 4) {
    FourPairs leaning, n;
    n.a = lean(i, leaning.a);
    n.b = lean(i + 1, leaning.b);
    n.c = lean(i + 2, leaning.c);
    n.d = lean(i + 3, leaning.d);
    store_four(normals + i, normalize_four(leaning, 0, n));
  }
  for (; i < pairs.size(); ++i) {
    Float8 leaning;
    const Float8 n = lean(i, leaning);
    store(normals[i], normalize_pair(leaning, 0, n));
  }
}

// Lists of halves of slots.
inline Float4 load_half(const Twin* twins, std::uint32_t half) {
  Float4 v;
  std::memcpy(&v, reinterpret_cast<const char*>(twins) + sizeof(Float4) * half, sizeof(v));
  return v;
}
inline Float8 load_two(const Twin* twins, std::uint32_t one, std::uint32_t other) {
  return __builtin_shufflevector(load_half(twins, one), load_half(twins, other), 0, 1, 2, 3, 4, 5, 6, 7);
}
inline Float8 repeat_low(const Float8& v) { return __builtin_shufflevector(v, v, 0, 1, 2, 3, 0, 1, 2, 3); }
inline Float8 repeat_high(const Float8& v) { return __builtin_shufflevector(v, v, 4, 5, 6, 7, 4, 5, 6, 7); }

// As compute_skin_frame, of two bindings.
struct TwoFrames {
  Float8 origin, tangent, bitangent, normal;
};
inline TwoFrames find_frames(const HairRoots& roots, std::size_t two, const Twin* places, const Twin* normals) {
  const Triangle &one = roots.corners[2 * two], &other = roots.corners[2 * two + 1];
  const Float8 share = load(roots.shares[two]);
  const Float8 x = spread_x(share), y = spread_y(share), z = spread_z(share);
  const Float8 a = load_two(places, one[0], other[0]), b = load_two(places, one[1], other[1]),
               c = load_two(places, one[2], other[2]);
  const Float8 blended = load_two(normals, one[0], other[0]) * x + load_two(normals, one[1], other[1]) * y +
                         load_two(normals, one[2], other[2]) * z;
  const Float8 normal = normalize_pair(blended, 1e-12f, Float8{0, 0, 1, 0, 0, 0, 1, 0}), edge = b - a;
  Float8 tangent = edge - normal * dot_pair(edge, normal);
  const Float8 squares = dot_pair(tangent, tangent);
  for (int half = 0; half < 8; half += 4) {
    if (squares[half] > 1e-12f) continue;  // a collapsed edge: any direction along the skin
    const Float8 any = std::abs(normal[half]) < 0.9f ? Float8{1, 0, 0, 0, 1, 0, 0, 0} : Float8{0, 1, 0, 0, 0, 1, 0, 0};
    const Float8 along = any - normal * dot_pair(any, normal);
    for (int i = half; i < half + 4; ++i) tangent[i] = along[i];
  }
  tangent = normalize_pair(tangent, 0, tangent);
  return {a * x + b * y + c * z, tangent, cross_pair(normal, tangent), normal};
}

[[gnu::noinline]] void place_hairs(const HairRoots& roots, const Twin* places, const Twin* normals, glm::vec3* placed,
                                   glm::vec3* shaded) {
  for (std::size_t two = 0; two < roots.shares.size(); ++two) {
    const TwoFrames now = find_frames(roots, two, places, normals);
    const auto& [tangent, bitangent, normal] = roots.rest[two];
    // The turn from rest to now: the images of x, y and z.
    const auto turn = [&](const Float8& t, const Float8& b, const Float8& n) {
      return now.tangent * t + now.bitangent * b + now.normal * n;
    };
    const Float8 t = load(tangent), b = load(bitangent), n = load(normal);
    const Float8 x = turn(spread_x(t), spread_x(b), spread_x(n)), y = turn(spread_y(t), spread_y(b), spread_y(n)),
                 z = turn(spread_z(t), spread_z(b), spread_z(n));
    const auto place = [&](std::size_t binding, const Float8& to_x, const Float8& to_y, const Float8& to_z,
                           const Float8& origin) {
      for (std::uint32_t i = roots.first[binding]; i < roots.first[binding + 1]; ++i) {
        const Float8 arm = load(roots.arms[i]);
        const Float8 turned = to_x * spread_x(arm) + to_y * spread_y(arm) + to_z * spread_z(arm);
        const Float8 moved = origin + turned;
        placed[i] = {moved[0], moved[1], moved[2]};
        shaded[i] = {turned[4], turned[5], turned[6]};
      }
    };
    place(2 * two, repeat_low(x), repeat_low(y), repeat_low(z), now.origin);
    place(2 * two + 1, repeat_high(x), repeat_high(y), repeat_high(z), repeat_high(now.origin));
  }
}
