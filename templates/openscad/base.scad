// The base: rings of points from below the figure's foot to the underside, one point for each of the foot's. A ring's
// point is the foot's, moved outward by a share of the way to the outline.

// [how far out, how high] from top to bottom: hollow, torus and drum, or a plain block.
base_socle = [[0.061, 0.9005], [0.234, 0.8162], [0.494, 0.7598], [0.8, 0.74], [0.871, 0.7195], [0.9, 0.67],
              [0.871, 0.6205], [0.8, 0.6], [0.97, 0.6], [1, 0.57], [1, 0.04], [0.96, 0]];
base_block = [[0.97, 1], [1, 0.96], [1, 0.04], [0.96, 0]];

// The outline's distance from the axis in the direction of the unit vector d: a circle or a square with soft corners.
function base_outline(shape, radius, d) = let (n = shape == "round" ? 2 : 8)
  radius * pow(pow(abs(d[0]), n) + pow(abs(d[1]), n), -1 / n);

function base_point(p, shape, height, radius, out, up) = let (
    from = norm([p[0], p[1]]),
    d = [p[0], p[1]] / from,
    to = max(base_outline(shape, radius, d), 1.12 * from))
  [for (c = d * (from + out * (to - from))) c, height * up];

// foot: the figure's lowest ring, at z = height. shape: "none", "round", "square" or "plinth".
function base_rings(foot, shape, height, radius) =
  shape == "none" ? (height > 0 ? [[for (p = foot) [p[0], p[1], 0]]] : [])
  : [for (k = shape == "plinth" ? base_block : base_socle)
      [for (p = foot) base_point(p, shape, height, radius, k[0], k[1])]];

// The label: letters drawn with a round pen as lines on a grid (capitals are 6 units high), so that no font is needed.
// [letter, width, lines]; small letters are drawn as capitals, the last one stands for all that is not here.
{{letters}}
function letter_of(c) = let (
    code = ord(c), capital = code >= 97 && code <= 122 ? chr(code - 32) : code < 32 || code == 127 ? " " : c,
    found = [for (l = letters) if (l[0] == capital) l])
  len(found) > 0 ? found[0] : letters[len(letters) - 1];
function label_pen(size) = max(0.8, 0.16 * size);
function label_unit(size) = (size - label_pen(size)) / 6;
function label_gap(size) = max(0.5, 0.9 * label_unit(size));
// Where each letter begins, and at last how long the text is with a gap behind it.
function label_starts(text, size, i = 0, x = 0) = i >= len(text) ? [x]
  : concat([x], label_starts(text, size, i + 1,
      x + letter_of(text[i])[1] * label_unit(size) + label_pen(size) + label_gap(size)));
function label_width(text, size) = let (s = label_starts(text, size)) s[len(s) - 1] - label_gap(size);
function label_head(text, count) = chr([for (i = [0:1:count - 1]) ord(text[i])]);
function label_cut(text, size, room) = len(text) == 0 || label_width(text, size) <= room ? text
  : label_cut(label_head(text, len(text) - 1), size, room);
function label_fit(text, size, least, room) = label_width(text, size) <= room || size * 0.98 < least ? size
  : label_fit(text, size * 0.98, least, room);

// Raised on the front of a base, to be united with it: smaller and then cut if it is too long. size 0 is as large as the
// front allows. front_mm is how far the front is from the axis.
module base_label(text, size, raise, shape, height, front_mm) {
  low = 0.04 * height;
  high = (shape == "plinth" ? 0.96 : 0.57) * height;
  room = (shape == "round" ? 2 * front_mm * asin(0.8) * PI / 180 : 1.6 * front_mm) - 0.9;
  asked = size > 0 ? size : 8;
  least = min(asked, 3);
  head = label_head(text, min(len(text), floor(room / 1.3) + 1));
  fit = label_fit(head, min(asked, high - low - 0.3), least, room);
  line = label_cut(head, fit, room);
  starts = label_starts(line, fit);
  pen = label_pen(fit);
  unit = label_unit(fit);
  sink = 1;  // into the wall, which curves behind a flat letter
  if (shape != "none" && fit >= least && len(line) > 0)
    for (i = [0:1:len(line) - 1]) {
      glyph = letter_of(line[i]);
      middle = starts[i] + (glyph[1] * unit + pen) / 2 - label_width(line, fit) / 2;
      if (len(glyph[2]) > 0)
        rotate([0, 0, shape == "round" ? middle / front_mm * 180 / PI : 0])
          translate([shape == "round" ? 0 : middle, -front_mm + sink, (low + high - fit) / 2 + pen / 2])
            rotate([90, 0, 0]) linear_extrude(sink + raise) for (stroke = glyph[2], k = [1:1:len(stroke) - 1]) hull()
              for (p = [stroke[k - 1], stroke[k]])
                translate([(p[0] - glyph[1] / 2) * unit, p[1] * unit]) circle(d = pen, $fn = 12);
    }
}
