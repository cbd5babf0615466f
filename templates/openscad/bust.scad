// {{title}}
//
// A bust to print, made by mien. Everything is in this file: press F6, then export. The Customizer (Window menu) changes
// what stands under [Bust] and [Quality]. Millimetres; z up, the face looks toward -y.

/* [Bust] */
// Height of the whole print in mm
height_mm = {{height_mm}}; // [20:1:400]
// Stand on a turned base; without one the chest is cut flat
base = true;
// Height of the base in mm
base_height_mm = {{base_height_mm}}; // [2:0.5:60]
// Radius of the base in mm
base_radius_mm = {{base_radius_mm}}; // [4:0.5:120]

/* [Quality] */
// Sides of the turned base
base_sides = 72; // [24:12:360]

/* [Hidden] */
figure_height_mm = {{figure_height_mm}};  // of the solids below, which stand on z = 0
foot_mm = {{foot_mm}};                    // the height at which they are cut when there is no base
foot_radius_mm = {{foot_radius_mm}};      // of their round underside
foot_sink_mm = {{foot_sink_mm}};          // how deep that goes into the base

assert(height_mm > 0, "height_mm must be above 0");
assert(!base || base_height_mm >= 2 && base_height_mm < height_mm / 2,
       "base_height_mm must be at least 2 and less than half of height_mm");
assert(!base || base_radius_mm > 0, "base_radius_mm must be above 0");

growth = base ? (height_mm - base_height_mm + foot_sink_mm) / figure_height_mm
              : height_mm / (figure_height_mm - foot_mm);
lift_mm = base ? base_height_mm - foot_sink_mm : -foot_mm * growth;

// A solid at its size and height.
module place() translate([0, 0, lift_mm]) scale(growth) children();

// The socle: a drum with a bevelled edge, a round moulding, a hollow that runs up to the figure's foot.
module turned_base() {
  h = base_height_mm;
  top = foot_radius_mm * growth * 1.12;
  low = max(base_radius_mm, top);
  bevel = min(0.04 * low, 0.1 * h);
  shoulder = top + (low - top) * 0.8;
  rotate_extrude($fn = base_sides) polygon(concat(
    [[0, 0], [low - bevel, 0], [low, bevel], [low, 0.30 * h - bevel], [low - bevel, 0.30 * h]],
    [for (a = [-80:20:80]) [shoulder + 0.11 * h * cos(a), 0.42 * h + 0.11 * h * sin(a)]],
    [for (a = [0:10:90]) [top + (shoulder - top) * pow(1 - sin(a), 1.3), 0.54 * h + 0.36 * h * (1 - cos(a))]],
    [[top, h], [0, h]]));
}

module figure() {
{{calls}}}

if (base) {
  turned_base();
  figure();
} else {
  intersection() {
    union() figure();
    translate([-2 * height_mm, -2 * height_mm, 0]) cube([4 * height_mm, 4 * height_mm, 2 * height_mm]);
  }
}

{{modules}}
