// {{title}}
//
// A bust to print and to pose, made by mien. Everything is in this file: move the sliders of the Customizer (Window
// menu), press F6, then export. Millimetres; z up, the face looks toward -y, "left" is the character's own left.

/* [Bust] */
// Height of the whole print in mm
height_mm = {{height_mm}}; // [20:1:400]
// What it stands on; without a base the chest is cut flat
base = "{{base_shape}}"; // [none, round, square, plinth]
// Height of the base in mm
base_height_mm = {{base_height_mm}}; // [2:0.5:60]
// Radius of the base in mm; half the side of a square one
base_radius_mm = {{base_radius_mm}}; // [4:0.5:120]
{{label_settings}}// Diameter in mm of a pocket for a magnet in the underside; 0: none
magnet_diameter_mm = {{magnet_diameter_mm}}; // [0:0.5:30]
// Depth of the pocket in mm
magnet_depth_mm = {{magnet_depth_mm}}; // [0.5:0.5:20]
// Hollow: inside a wall that no expression and no slider below makes thinner
hollow = {{is_hollow}};
// Thickness of the wall in mm
wall_mm = {{wall_mm}}; // [0.8:0.1:10]
// Diameter in mm of the hole to drain the hollow, which has a vent to the base's back; with a magnet it is in the pocket; 0: the hollow stays closed
drain_mm = {{drain_mm}}; // [0:0.5:12]

/* [Expression] */
// The expression to begin with; the sliders add to it
expression = "{{expression}}"; // [{{expression_names}}]
{{sliders}}
/* [Quality] */
// How fine the letters of the label are, in mm
letter_step_mm = {{label_step}}; // [0.1:0.05:0.5]

/* [Hidden] */
own_height_mm = {{height_mm}};  // what the numbers below were computed for
figure_mm = {{figure_mm}};      // of it without the base
own_is_flat = {{own_is_flat}};   // its chest is cut flat; else it ends in a foot for a base
other_foot_mm = {{other_foot_mm}};  // where it ends on the other stand
mm = {{mm_per_head_mm}};        // of the print for one of the head

assert(height_mm >= 10, "height_mm must be 10 at least");
assert(base == "none" || base_height_mm >= 1 && base_height_mm < height_mm / 2,
       "base_height_mm must be at least 1 and less than half of height_mm");
assert(base == "none" || base_radius_mm > 0, "base_radius_mm must be above 0");
assert(magnet_diameter_mm == 0 || base != "none" && magnet_depth_mm < base_height_mm - {{pocket_roof}}
                                  && magnet_diameter_mm < 1.6 * base_radius_mm,
       "the magnet's pocket must fit into the base");

is_flat = base == "none";
stand_mm = is_flat ? 0 : base_height_mm;
foot_mm = is_flat == own_is_flat ? 0 : other_foot_mm;
growth = (height_mm - stand_mm) / (figure_mm - foot_mm);

// "a, b, c"; the values of an expression that is not there would be nothing, and so would all that is made of them.
function join_names(names, i = 0) = i >= len(names) ? "" : str(i > 0 ? ", " : "", names[i], join_names(names, i + 1));
assert(len([for (e = expressions) if (e[0] == expression) e]) > 0,
       str("there is no expression \"", expression, "\"; known: ", join_names([for (e = expressions) e[0]])));

{{base_functions}}

{{hollow_functions}}

// The face in its pose on its base, one closed polyhedron.
module body() {
  // --- The pose: what the expression and the sliders come to

  slider_values = [{{slider_names}}];
  chosen = [for (e = expressions) if (e[0] == expression) e][0];
  values = [for (m = [0:len(moves) - 1]) min(max(chosen[1][m] + slider_values[m], moves[m][0]), moves[m][1])];

  // How much of a move's state i there is at value x; `a` are the values of its states. The states in between share x.
  function share(x, a, i) = let (
      at = a[i],
      before = i > 0 && !(a[i - 1] < 0 && at > 0) ? a[i - 1] : at > 0 ? 0 : at - 1,
      after = i + 1 < len(a) && !(at < 0 && a[i + 1] > 0) ? a[i + 1] : at < 0 ? 0 : at + 1)
    min(max(x <= at ? (x - before) / (at - before) : (after - x) / (after - at), 0), 1);

  shares = concat(
    [for (m = [0:len(moves) - 1]) for (i = [0:len(moves[m][4]) - 1]) share(values[m], moves[m][4], i)],
    [for (e = expressions) e[0] == expression ? 1 : 0],
    [is_flat == own_is_flat ? 0 : 1]);

  // Vertices: [place], or [place, states, what each of them adds].
  function posed(rows) = [for (r = rows) len(r) == 1 ? r[0] : r[0] + [for (k = r[1]) shares[k]] * r[2]];

  skin = posed(skin_rows);
  chest = posed(chest_rows);

  function reached(m, x) = x * (x > 0 ? moves[m][3] : moves[m][2]);

  // --- Eyes: a ball behind the lids, carved where it looks

  function mix(a, b, t) = a + (b - a) * t;
  function smooth(from, to, x) = let (t = min(max((x - from) / (to - from), 0), 1)) t * t * (3 - 2 * t);

  // Columns of a grid stand on its rim's vertices and halfway between them.
  function rim_point(rim, c) =
    c % 2 == 0 ? skin[rim[c / 2]] : (skin[rim[(c - 1) / 2]] + skin[rim[(c + 1) / 2]]) / 2;

  function light(width, x, y) = let (
      from = [{{light_from}}], along = [{{light_along}}], at = [x, y] - from,
      t = min(max(at * along / (along * along), 0), 1))
    1 - smooth(width, width + {{light_soft}}, norm(at - t * along));

  // x and y in radii of the iris from the gaze; wall {{iris_wall}} of them.
  function carving(eye, x, y) = let (
      r = norm([x, y]),
      iris = 1 - smooth({{iris_inside}}, {{iris_outside}}, r),
      pupil = 1 - smooth({{pupil_inside}}, {{pupil_outside}}, r))
    mix(iris * eye[5], eye[6], pupil) * (1 - light(eye[9], x, y));

  function eye_point(eye, gaze, right, up, high, low, t) = let (
      a = high - eye[2], b = low - eye[2],
      way = mix(a, b, t), out = way / norm(way),
      rim = mix(norm(a), norm(b), t),
      gap = norm(high - low),
      across = out * right, above = out * up,
      sine = norm([across, above]),
      per_sine = atan2(sine, out * gaze) / asin(eye[4] / eye[3]) / max(sine, {{least_sine}}),
      seat = smooth(0, {{eye_seat}}, min(t, 1 - t) * gap),
      line = 1 - smooth(eye[7], 2 * eye[7], gap),
      ball = eye[3] - carving(eye, across * per_sine, above * per_sine) * (1 - line))
    eye[2] + out * (mix(rim, ball, seat) - line * eye[8] * 4 * t * (1 - t));

  // The gaze in degrees, yaw to the character's left and pitch upward; m: the move "up" of that eye, "side" is the next.
  function pitch_rad(x) = x > 0 ? x * gaze_up_rad : x * gaze_down_rad;
  function gaze_angle(side, m) =
    [chosen[4][side][0] + (reached(m + 1, values[m + 1]) - reached(m + 1, chosen[1][m + 1])) * gaze_side_rad,
     chosen[4][side][1] + pitch_rad(reached(m, values[m])) - pitch_rad(reached(m, chosen[1][m]))] * 180 / PI;

  function eye_points(eye, angle) = let (
      gaze = [cos(angle[1]) * sin(angle[0]), -cos(angle[1]) * cos(angle[0]), sin(angle[1])],
      level = cross([0, 0, 1], gaze), right = level / norm(level), up = cross(gaze, right))
    [for (c = [1:2 * len(eye[0]) - 3]) let (high = rim_point(eye[0], c), low = rim_point(eye[1], c))
      for (row = [1:grid_rows - 1]) eye_point(eye, gaze, right, up, high, low, row / grid_rows)];

  // --- The mouth: a hollow behind the lips with teeth and tongue as relief

  jaw_open = chosen[3] + reached(open_move, values[open_move]) - reached(open_move, chosen[1][open_move]);

  // A place of the mid-plane as [height, forward] with the jaw moved.
  function with_jaw(p) = let (a = jaw_open * jaw_open_rad * 180 / PI, arm = p - jaw_axis)
    jaw_axis + [arm[0] * cos(a) - arm[1] * sin(a), arm[0] * sin(a) + arm[1] * cos(a)] + jaw_open * jaw_open_shift;

  // Teeth: [height and forward of the edge, of a place of the front] at samples from side to side; [] where there is none.
  upper_teeth = teeth_rows[0];
  lower_teeth = [for (t = teeth_rows[1]) t == [] ? [] : [with_jaw(t[0]), with_jaw(t[1])]];
  tongue_at = with_jaw(tongue[0]);

  function tooth(row, x) = let (at = (x / teeth_reach + 1) / 2 * (len(row) - 1), i = floor(at))
    i < 0 || i + 1 >= len(row) ? [] : row[i] == [] || row[i + 1] == [] ? [] : mix(row[i], row[i + 1], at - i);

  function stand_teeth(row, sign, x, z, back) = let (t = tooth(row, x))
    t == [] ? back : let (
      height = sign * (z - t[0][0]),
      crown = max({{least_crown}}, sign * (t[1][0] - t[0][0])),
      front = t[0][1] + (t[1][1] - t[0][1]) / crown * min(max(height, 0), {{crown_reach}}))
    mix(back, max(back, front), smooth(-{{tooth_edge}}, {{tooth_edge}}, height));

  function stand_tongue(x, z, back) = tongue[1][0] <= 0 ? back : let (
      inside = 1 - pow(x / tongue[1][0], 2) - pow((z - tongue_at[0]) / tongue[1][1], 2))
    inside <= 0 ? back : max(back, tongue_at[1] + tongue[1][2] * sqrt(inside));

  // How far down each row lies: the first ones above the upper teeth's edge, the last ones below the lower teeth's.
  function mouth_rows(high, low, gap) = let (
      x = (high[0] + low[0]) / 2, height = max(high[2] - low[2], {{least_mouth_gap}}),
      over = tooth(upper_teeth, x), under = tooth(lower_teeth, x),
      first = min(max(over == [] ? {{no_upper_tooth}} : (high[2] - over[0][0]) / height, {{least_upper_rows}}), {{most_upper_rows}}),
      second = min(max(under == [] ? {{no_lower_tooth}} : (high[2] - under[0][0]) / height, first + {{least_between_rows}}), {{most_lower_rows}}),
      step = min({{tooth_edge}} / max(gap, {{least_mouth_gap}}), {{most_edge_step}}))
    [for (row = [1:grid_rows - 1])
      row <= {{teeth_rows}} ? (first - step) * row / {{teeth_rows}}
      : row < grid_rows - {{teeth_rows}} ? mix(first + step, second - step, (row - {{first_between_row}}) / (grid_rows - {{edge_rows}}))
      : mix(second + step, 1, (row - grid_rows + {{teeth_rows}}) / {{teeth_rows}})];

  function mouth_point(high, low, gap, t) = let (
      p = mix(high, low, t), lips = -p[1],
      depth = min(mouth_line * smooth(0, {{lip_line_fade}}, gap) + {{depth_per_gap}} * gap, {{deepest_mouth}}),
      back = lips - depth * sqrt(sin(180 * t)),
      front = max(stand_tongue(p[0], p[2], back), stand_teeth(lower_teeth, -1, p[0], p[2], back),
                  stand_teeth(upper_teeth, 1, p[0], p[2], back)))
    [p[0], -min(front, max(back, lips - {{behind_lips}})), p[2]];

  function mouth_points(rims) =
    [for (c = [1:2 * len(rims[0]) - 3])
      let (high = rim_point(rims[0], c), low = rim_point(rims[1], c), gap = norm(high - low))
      for (t = mouth_rows(high, low, gap)) mouth_point(high, low, gap, t)];

{{lens}}  // --- The body

  figure = [for ({{straight}} = concat(skin, eye_points(eyes[0], gaze_angle(0, left_gaze_move)),
                            eye_points(eyes[1], gaze_angle(1, right_gaze_move)), mouth_points(mouth), chest))
    {{bent}}[p[0] * growth, p[1] * growth, (p[2] - foot_mm) * growth + stand_mm]];
  // --- One ring after the other: from the foot down the base, under it, up the drain, to the top of the hollow

  sides = len(foot);
  foot_points = [for (i = foot) let (p = figure[i]) [p[0], p[1], stand_mm]];
  base_points = base_rings(foot_points, base, stand_mm, base_radius_mm);
  outline = len(base_points) > 0 ? base_points[len(base_points) - 1] : foot_points;
  has_magnet = magnet_diameter_mm > 0 && base != "none";
  ceiling = has_magnet ? magnet_depth_mm : 0;
  pocket = !has_magnet ? [] : [for (z = [0, ceiling]) base_circle(outline, magnet_diameter_mm, z)];

  inner = hollow ? cavity_rings(ceiling) : [];
  drain = hollow && drain_mm > 0
    ? min(concat([drain_mm, {{drain_share}} * cavity_inside(inner[0])], has_magnet ? [magnet_diameter_mm - {{magnet_ledges}}] : [])) : 0;
  assert(!hollow || drain >= min(drain_mm, {{least_drain}}), str("a wall of ", wall_mm,
    " mm leaves no room for a drain; a thinner wall, base none or a greater height have it, and drain_mm 0 does without"));
  tube = drain > 0 ? [for (z = [ceiling, inner[0][0][2]]) base_circle(outline, drain, z)] : [];

  outer = concat(base_points, pocket, tube);  // rings of as many points as the foot
  function ring(k) = k == 0 ? foot : [for (i = [0:sides - 1]) len(figure) + (k - 1) * sides + i];
  bottom = ring(len(outer));
  columns = hollow ? len(inner[0]) : 1;
  inner_first = len(figure) + len(outer) * sides;
  function inner_ring(k) = [for (i = [0:columns - 1]) inner_first + k * columns + i];
  top = inner_first + len(inner) * columns;
  outer_points = concat(figure, [for (r = outer) each r]);
  inner_points = concat([for (r = inner) each r], hollow ? [cavity_top()] : [], drain > 0 ? [] : [[0, 0, ceiling]]);
  under = len(outer_points) + len(inner_points) - 1;  // the middle of the underside, if nothing drains there

  front = base == "none" || label == "" ? -1 : len(base_points) - {{label_ring}};  // of the rings, the upper one of the label's
  labelled = front < 0 ? [[], []]
    : label_band(label, label_size_mm, {{label_raise}}, letter_step_mm, outer_points, ring(front), ring(front + 1),
                 len(outer_points) + len(inner_points));

  // The vent's mouths: in the upright back of the base, and in the drain.
  vent = drain > 0 ? base_vent(base, stand_mm, drain, ceiling) : [];
  has_vent = len(vent) > 0;
  walls = has_vent ? [len(base_points) - {{label_ring}}, len(outer) - 1] : [];  // the first of either one's two rings
  wall_points = has_vent ? [base_points[walls[0]], tube[1]] : [];
  columns_of = [for (p = wall_points) vent_columns(p, vent[0] / 2)];
  lines = [for (w = [0:1:len(walls) - 1]) for (z = [vent[1], vent[2]]) vent_line(wall_points[w], columns_of[w], vent[0] / 2, z)];
  line_first = len(outer_points) + len(inner_points) + len(labelled[0]);
  function line_start(i) = i == 0 ? line_first : line_start(i - 1) + len(lines[i - 1]);
  mouths = [for (i = [0:1:len(lines) - 1]) let (start = line_start(i)) [for (k = [0:len(lines[i]) - 1]) start + k]];
  rims = [for (w = [0:1:len(walls) - 1]) [for (k = [walls[w], walls[w] + 1]) let (r = ring(k)) [for (c = columns_of[w]) r[c]]]];
  function wall_faces(k) = let (faces = k == front ? labelled[1] : band(ring(k), ring(k + 1)))
    !has_vent || k != walls[0] && k != walls[1] ? faces
    : let (rim = rims[k == walls[0] ? 0 : 1]) faces_outside(faces, concat(rim[0], rim[1]));
  vent_faces = !has_vent ? [] : concat(
    vent_frame(rims[0][0], rims[0][1], mouths[1], mouths[0]), vent_frame(rims[1][0], rims[1][1], mouths[2], mouths[3]),
    vent_tunnel(mouths[0], mouths[1], mouths[2], mouths[3]));

  polyhedron(convexity = 12,
    points = concat(outer_points, inner_points, labelled[0], [for (l = lines) each l]),
    faces = concat(triangles, vent_faces,
      [for (k = [0:1:len(outer) - 1]) each wall_faces(k)],
      drain > 0 ? collar(bottom, inner_ring(0))
        : concat([for (i = [0:sides - 1]) [bottom[i], under, bottom[(i + 1) % sides]]], hollow ? [inner_ring(0)] : []),
      [for (k = [0:1:len(inner) - 2]) each band(inner_ring(k), inner_ring(k + 1))],
      hollow ? let (last = inner_ring(len(inner) - 1))
        [for (i = [0:columns - 1]) [last[i], top, last[(i + 1) % columns]]] : []));
}

body();

// --- The numbers ---

// Moves: lowest and highest value, what -1 and 1 come to on this head, the values of their states.
moves = [{{moves}}];
// Expressions: name, values of the moves, state, how far the jaw is open, yaw and pitch of either eye in radians.
expressions = [{{expressions}}];
open_move = {{chin_down}};
left_gaze_move = {{left_eye_up}};
right_gaze_move = {{right_eye_up}};
gaze_side_rad = {{gaze_side_rad}};
gaze_up_rad = {{gaze_up_rad}};
gaze_down_rad = {{gaze_down_rad}};
grid_rows = {{grid_rows}};
// Eyes: upper rim, lower rim, centre, radius, iris, depth of iris and pupil, width and depth of the line when shut, light.
eyes = [{{eyes}}];
mouth = [{{mouth}}];
mouth_line = {{mouth_line}};
jaw_axis = {{jaw_axis}};
jaw_open_rad = {{jaw_open_rad}};
jaw_open_shift = {{jaw_open_shift}};
teeth_reach = {{teeth_reach}};
teeth_rows = [{{teeth}}];
tongue = {{tongue}};
foot = [{{foot}}];
skin_rows = [{{skin_rows}}];
chest_rows = [{{chest_rows}}];
triangles = [{{triangles}}];
{{cavity}}
