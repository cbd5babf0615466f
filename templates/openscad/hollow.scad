// The hollow: rings around a line in the middle of the head. It is the same in every pose: whatever the expression, the
// wall is wall_mm thick or more; only two sliders pushed to their ends at once may come nearer to it.

own_wall_mm = wall_mm / growth;  // at the height of the numbers below
function most_wall_mm() = len(cavities) == 0 ? 0 : floor(cavities[len(cavities) - 1][0] * growth * 100) / 100;
assert(!hollow || most_wall_mm() > 0, "this bust is too small to be hollow");
assert(!hollow || wall_mm <= most_wall_mm() + 0.01, str("wall_mm can be ", most_wall_mm(), " at most in a bust of this height"));

// What lies between the next thinner and the next thicker wall that is known.
function between(values) = let (
    thinner = max([0, for (i = [0:len(cavities) - 1]) if (cavities[i][0] <= own_wall_mm) i]),
    thicker = min(thinner + 1, len(cavities) - 1),
    share = thicker == thinner ? 0
      : max(0, (own_wall_mm - cavities[thinner][0]) / (cavities[thicker][0] - cavities[thinner][0])))
  values[thinner] + (values[thicker] - values[thinner]) * min(share, 1);

function cavity_z(height) = (height - foot_mm) * growth + stand_mm;
function cavity_top() = [0, cavity_rows[len(cavity_rows) - 1][1] * growth, cavity_z(between([for (c = cavities) c[1]]))];
function cavity_ring(row, reaches) = [for (i = [0:len(reaches) - 1]) let (way = reaches[i] * cavity_ways[i])
  [way[0] * growth, (row[1] + way[1]) * growth, cavity_z(row[0])]];

// From the floor up; `ceiling` is how high a magnet's pocket is.
function cavity_rings(ceiling) = let (
    reaches = between([for (c = cavities) c[2]]),
    rows = len(cavity_rows),
    lowest = [for (k = [0:rows - 1]) if (reaches[k][0] > 0.1) k][0],
    asked = (max(stand_mm, ceiling + wall_mm) - stand_mm) / growth + foot_mm,
    height = drain_mm > 0 ? asked : max(asked, cavity_rows[lowest][0]),
    k = max([lowest, for (i = [lowest:rows - 2]) if (cavity_rows[i][0] <= height) i]),
    share = (height - cavity_rows[k][0]) / (cavity_rows[k + 1][0] - cavity_rows[k][0]),
    top = between([for (c = cavities) c[1]]))
  // A foot that is too narrow for the wall: nothing drains through it.
  share < 0 ? [[for (r = reaches[0]) [0, 0, cavity_z(height)]]]
  : concat([cavity_ring(cavity_rows[k] + share * (cavity_rows[k + 1] - cavity_rows[k]),
                        reaches[k] + share * (reaches[k + 1] - reaches[k]))],
           [for (i = [k + 1:rows - 1])
             if (reaches[i][0] > 0.1 && cavity_rows[i][0] > height + {{cavity_step}} && cavity_rows[i][0] < top - {{cavity_step}})
               cavity_ring(cavity_rows[i], reaches[i])]);

// How far the ring is from the axis, sides and not corners taken.
function cavity_inside(ring) = min([for (i = [0:len(ring) - 1]) let (
    p = ring[i], q = ring[(i + 1) % len(ring)], a = [p[0], p[1]], way = [q[0], q[1]] - a, square = way * way)
  norm(a + way * (square > 0 ? min(max(-(a * way) / square, 0), 1) : 0))]);

// Faces between the drain's ring and the floor's, which has fewer vertices.
function collar(tube, ring) = let (n = len(ring), stride = len(tube) / n)
  [for (i = [0:n - 1]) each concat(
    [for (t = [0:stride - 1]) [tube[i * stride + t], ring[i], tube[(i * stride + t + 1) % len(tube)]]],
    [[tube[(i + 1) * stride % len(tube)], ring[i], ring[(i + 1) % n]]])];

// The vent, a tunnel from the drain to the base's back, as [width, floor, ceiling]; [] where it has no room. `pocket` is how
// deep a magnet's is.
function base_vent(shape, height, drain, pocket) = let (
    profile = shape == "plinth" ? base_block : base_socle, lower = len(profile) - {{label_ring}},
    width = {{vent_share}} * drain,
    low = max({{vent_plate}}, profile[lower][1] * height + {{vent_edge}}, pocket > 0 ? pocket + {{magnet_ledge}} : 0),
    high = min(low + width, profile[lower - 1][1] * height - {{vent_edge}}, profile[lower - 2][1] * height - {{vent_plate}}))
  shape == "none" || min(width, high - low) < {{least_drain}} ? [] : [width, low, high];

// The columns of a ring from beyond one side of the vent to beyond the other, across the middle of the back.
function vent_columns(ring, half) = let (
    n = len(ring),
    middle = [for (i = [0:n - 1]) if (ring[i][1] > 0 && (ring[i][0] <= 0) != (ring[(i + 1) % n][0] <= 0)) i + n][0],
    before = len([for (i = 0; abs(ring[(middle - i) % n][0]) <= half; i = i + 1) i]),
    behind = len([for (i = 1; abs(ring[(middle + i) % n][0]) <= half; i = i + 1) i]))
  [for (i = [middle - before:middle + 1 + behind]) i % n];

// An edge of the tunnel in the ring's wall.
function vent_line(ring, columns, half, z) = let (last = len(columns) - 1)
  [for (c = [0:last]) let (
      p = ring[columns[c]], next = ring[columns[c == 0 ? 1 : c - 1]],
      at = c > 0 && c < last ? p : p + (next - p) * ((p[0] > 0 ? half : -half) - p[0]) / (next[0] - p[0]))
    [at[0], at[1], z]];

// Faces, of vertices: around a mouth, between two rings and the tunnel's edges nearer to either; of the tunnel.
function quad(a, b, c, d) = [[a, c, b], [a, d, c]];
function vent_frame(from, to, a, b) = let (last = len(a) - 1) concat(
  [for (c = [0:last - 1]) each concat(quad(from[c], from[c + 1], a[c + 1], a[c]), quad(b[c], b[c + 1], to[c + 1], to[c]))],
  quad(from[0], a[0], b[0], to[0]), quad(a[last], from[last], to[last], b[last]));
function vent_tunnel(out_low, out_high, in_low, in_high) = let (last = len(out_low) - 1, end = len(in_low) - 1) concat(
  strip(out_high, in_high), strip(in_low, out_low), quad(out_low[0], out_high[0], in_high[0], in_low[0]),
  quad(out_high[last], out_low[last], in_low[end], in_high[end]));
// The faces but for those that have vertices of the opening alone.
function faces_outside(faces, opening) =
  [for (f = faces) if (len([for (v = f, o = opening) if (v == o) v]) < len(f)) f];
