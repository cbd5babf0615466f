# Draws the half head's control points with their names, from the front and from the side, as SVG. Reads
# templates/head/half_points.csv (names), half.obj (places) and half_quads.csv (meshes), in this order.
function across(view, p) { return view == 0 ? x[p] : -z[p] }
function toward(view, p) { return view == 0 ? z[p] : x[p] }
function place(view, p) { return sprintf("%.1f %.1f", left[view] + scale * across(view, p), 60 + scale * (135 - y[p])) }
BEGIN { FS = ","; scale = 13; left[0] = 60; left[1] = 3020 }
/^#/ || /^\r?$/ { next }
FILENAME ~ /half_points/ { if (seen++ > 0 || $1 != "name") { if ($1 != "name") name[++names] = $1 }; next }
FILENAME ~ /half.obj/ { split($0, v, " "); if (v[1] == "v") { ++places; x[places] = v[2]; y[places] = v[3]; z[places] = v[4]; number[name[places]] = places }; next }
{ ++quads; for (i = 1; i <= 4; ++i) { gsub(/[ \r]/, "", $i); corner[quads, i] = number[$i] } }
END {
  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 4800 5000\" font-family=\"sans-serif\">\n"
  printf "<rect width=\"4800\" height=\"5000\" fill=\"#fffdf8\"/>\n"
  for (view = 0; view < 2; ++view) {
    split("", drawn)
    for (q = 1; q <= quads; ++q) {
      a = corner[q, 1]; b = corner[q, 2]; c = corner[q, 3]; d = corner[q, 4]
      # Facing the eye, and not inside: the mouth, the nostril, the eye's socket and the cut of the neck.
      ux = across(view, c) - across(view, a); uy = y[c] - y[a]; vx = across(view, d) - across(view, b); vy = y[d] - y[b]
      if (ux * vy - uy * vx <= 0 || name[a] ~ /^(MB|EB|E0|M0|ni|nd)/) continue
      printf "<path d=\"M%s L%s L%s L%sZ\" fill=\"none\" stroke=\"#b9ad98\" stroke-width=\"1.2\"/>\n", place(view, a), place(view, b), place(view, c), place(view, d)
      for (i = 1; i <= 4; ++i) drawn[corner[q, i]] = 1
    }
    for (p in drawn) {
      split(place(view, p), at, " ")
      printf "<circle cx=\"%s\" cy=\"%s\" r=\"2\" fill=\"#a33\"/><text x=\"%.1f\" y=\"%.1f\" font-size=\"11\" fill=\"#222\">%s</text>\n", at[1], at[2], at[1] + 3, at[2] - 3, name[p]
    }
  }
  print "</svg>"
}
