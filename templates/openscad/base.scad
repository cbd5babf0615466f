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
