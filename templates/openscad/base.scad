// The base: rings of points from below the figure's foot to the underside, one point for each of the foot's. A ring's
// point is the foot's, moved outward by a share of the way to the outline.

// [how far out, how high] from top to bottom: hollow, torus and drum, or a plain block.
base_socle = [{{socle}}];
base_block = [{{block}}];

// The outline's distance from the axis in the direction of the unit vector d: a circle or a square with soft corners.
function base_outline(shape, radius, d) = let (n = shape == "round" ? 2 : {{squareness}})
  radius * pow(pow(abs(d[0]), n) + pow(abs(d[1]), n), -1 / n);

function base_point(p, shape, height, radius, out, up) = let (
    from = norm([p[0], p[1]]),
    d = [p[0], p[1]] / from,
    to = max(base_outline(shape, radius, d), {{spread}} * from))
  [for (c = d * (from + out * (to - from))) c, height * up];

// foot: the figure's lowest ring, at z = height. shape: "none", "round", "square" or "plinth".
function base_rings(foot, shape, height, radius) =
  shape == "none" ? (height > 0 ? [[for (p = foot) [p[0], p[1], 0]]] : [])
  : [for (k = shape == "plinth" ? base_block : base_socle)
      [for (p = foot) base_point(p, shape, height, radius, k[0], k[1])]];

// A circle with a point in the direction of each of `around`; what is as thick as the diameter goes through its sides.
function base_circle(around, diameter, z) = let (
    n = len(around),
    ways = [for (p = around) [p[0], p[1]] / norm([p[0], p[1]])],
    narrow = min([for (i = [0:n - 1]) sqrt((1 + ways[i] * ways[(i + 1) % n]) / 2)]))
  [for (w = ways) [w[0] * diameter / 2 / narrow, w[1] * diameter / 2 / narrow, z]];

// The label: letters drawn with a round pen as lines on a grid (capitals are {{capital}} units high), so that no font is needed.
// [letter, width, lines]; small letters are drawn as capitals, the last one stands for all that is not here.
{{letters}}
function letter_of(c) = let (
    code = ord(c), capital = code >= 97 && code <= 122 ? chr(code - 32) : code < 32 || code == 127 ? " " : c,
    found = [for (l = letters) if (l[0] == capital) l])
  len(found) > 0 ? found[0] : letters[len(letters) - 1];
function label_pen(size) = max({{least_pen}}, {{pen_share}} * size);
function label_unit(size) = (size - label_pen(size)) / {{capital}};
function label_gap(size) = max({{least_letter_gap}}, {{letter_gap}} * label_unit(size));
// Where each letter begins, and at last how long the text is with a gap behind it.
function label_starts(text, size, i = 0, x = 0) = i >= len(text) ? [x]
  : concat([x], label_starts(text, size, i + 1,
      x + letter_of(text[i])[1] * label_unit(size) + label_pen(size) + label_gap(size)));
function label_width(text, size) = let (s = label_starts(text, size)) s[len(s) - 1] - label_gap(size);
function label_trim(text) = len(text) > 0 && text[len(text) - 1] == " " ? label_trim(label_head(text, len(text) - 1)) : text;
function label_head(text, count) = chr([for (i = [0:1:count - 1]) ord(text[i])]);
function label_cut(text, size, room) = len(text) == 0 || label_width(text, size) <= room ? text
  : label_cut(label_head(text, len(text) - 1), size, room);
function label_fit(text, size, least, room) = label_width(text, size) <= room || size * {{letter_shrink}} < least ? size
  : label_fit(text, size * {{letter_shrink}}, least, room);

// The middle lines of a text's strokes as [from, to] in mm, from the middle of its lower edge.
function label_lines(text, size) = let (
    starts = label_starts(text, size), pen = label_pen(size), unit = label_unit(size),
    left = pen / 2 - label_width(text, size) / 2)
  [for (i = [0:1:len(text) - 1]) for (stroke = letter_of(text[i])[2], k = [1:1:len(stroke) - 1])
    [for (p = [stroke[k - 1], stroke[k]]) [left + starts[i] + p[0] * unit, pen / 2 + p[1] * unit]]];
function label_distance(p, line) = let (
    way = line[1] - line[0], to = p - line[0], square = way * way,
    share = square > 0 ? min(max(to * way / square, 0), 1) : 0)
  norm(to - share * way);

// A strip of triangles between two lines of vertices that run the same way, the second to the left of the first.
function strip(right, left) = let (n = len(right) - 1, m = len(left) - 1)
  concat([for (i = [0:n - 1]) [right[i], left[ceil((i + 1) * m / n) - 1], right[i + 1]]],
         [for (j = [0:m - 1]) [right[floor((j + 1) * n / m)], left[j], left[j + 1]]]);

// The upright band between two rings of vertices with a text raised from its front: [new points, faces]. The letters
// become smaller, and are then cut, if the front is too narrow; size 0 is as large as it allows. The new points'
// numbers begin at `first`.
function label_band(text, size, raise, step, points, high, low, first) = let (
    margin = {{label_margin}}, slope = {{label_slope}}, n = len(low),
    // The front from the character's right to its left: places in the rings, unrolled.
    back = max([for (v = low) points[v][1]]),
    start = [for (i = [0:n - 1]) if (points[low[i]][1] == back) i][0],
    broad = max([for (v = low) abs(points[v][0])]),
    front = [for (k = [0:n - 1]) let (i = (start + n - k) % n, p = points[low[i]])
      if (p[1] < 0 && abs(p[0]) <= {{label_sector}} * broad) i],
    at = [for (i = front) [points[low[i]][0], points[low[i]][1]]],
    last = len(at) - 1,
    lengths = [for (i = 0, sum = 0; i <= last; sum = sum + (i < last ? norm(at[i + 1] - at[i]) : 0), i = i + 1) sum],
    zero = lookup(0, [for (i = [0:last]) [at[i][0], lengths[i]]]),
    along = [for (l = lengths) l - zero],
    outward = [for (i = front) let (way = points[low[(i + n - 1) % n]] - points[low[(i + 1) % n]]) [way[1], -way[0]] / norm(way)],
    // The letters.
    low_z = points[low[0]][2], high_z = points[high[0]][2],
    room = 2 * (min(-along[0], along[last]) - 3 * margin),
    asked = size > 0 ? size : {{most_letter}},
    least = min(asked, {{least_letter}}),
    head = label_head(label_trim(text), min(len(label_trim(text)), floor(max(room, 0) / {{narrowest_letter}}) + 1)),
    fit = label_fit(head, min(asked, high_z - low_z - 2 * margin), least, room),
    line = fit < least ? "" : label_cut(head, fit, room))
  len(line) == 0 ? [[], band(high, low)] : let (
    lines = label_lines(line, fit), pen = label_pen(fit),
    half = label_width(line, fit) / 2 + margin,
    bottom = (low_z + high_z - fit) / 2,
    floor_z = bottom - {{label_frame}} * margin, top_z = bottom + fit + {{label_frame}} * margin,
    columns = ceil(min(2 * half / step, {{most_label_steps}})), rows = max(2, ceil((top_z - floor_z) / step)),
    reach = pen / 2 + slope,
    // A grid in front of the wall: how far it is raised.
    grid = [for (i = [0:columns]) let (
        a = -half + 2 * half * i / columns,
        x = lookup(a, [for (k = [0:last]) [along[k], at[k][0]]]), y = lookup(a, [for (k = [0:last]) [along[k], at[k][1]]]),
        o = [lookup(a, [for (k = [0:last]) [along[k], outward[k][0]]]), lookup(a, [for (k = [0:last]) [along[k], outward[k][1]]])],
        way = o / norm(o),
        near = [for (l = lines) if (min(l[0][0], l[1][0]) - reach < a && a < max(l[0][0], l[1][0]) + reach) l])
      for (j = [0:rows]) let (
        z = floor_z + (top_z - floor_z) * j / rows,
        is_wall = i == 0 || i == columns || j == 0 || j == rows || len(near) == 0,
        out = is_wall ? 0 : pen / 2 - min([for (l = near) label_distance([a, z - bottom], l)]),
        up = is_wall ? 0 : raise * min(max(0.5 + out / slope, 0), 1))
      [x + up * way[0], y + up * way[1], z]],
    // As few columns of the wall as hold the label are replaced.
    wide = half + margin,
    begin = max([0, for (i = [0:last]) if (along[i] < -wide) i]),
    end = min([last, for (i = [0:last]) if (along[i] > wide) i]),
    replaced = [for (i = [begin + 1:end]) front[i]],
    under = [for (i = [begin:end]) low[front[i]]], over = [for (i = [end:-1:begin]) high[front[i]]])
  [grid, concat(
    [for (i = [0:n - 1]) let (j = (i + 1) % n) if (len([for (r = replaced) if (r == i) r]) == 0)
      each [[high[i], low[j], high[j]], [high[i], low[i], low[j]]]],
    [for (i = [0:columns - 1], j = [0:rows - 1]) let (
        p = i * (rows + 1) + j, a = first + p, b = a + rows + 1, c = b + 1, d = a + 1)
      each norm(grid[p] - grid[p + rows + 2]) <= norm(grid[p + rows + 1] - grid[p + 1])
        ? [[a, c, b], [a, d, c]] : [[a, d, b], [b, d, c]]],
    strip(under, [for (i = [0:columns]) first + i * (rows + 1)]),
    strip([under[len(under) - 1], over[0]], [for (j = [0:rows]) first + columns * (rows + 1) + j]),
    strip(over, [for (i = [columns:-1:0]) first + i * (rows + 1) + rows]),
    strip([over[len(over) - 1], under[0]], [for (j = [rows:-1:0]) first + j]))];

// Faces between two rings of as many vertices.
function band(above, below) = [for (i = [0:len(above) - 1]) let (j = (i + 1) % len(above))
  each [[above[i], below[j], above[j]], [above[i], below[i], below[j]]]];
