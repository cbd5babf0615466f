  // --- The lens of a drawn head: space stretched about each eye

  lens_middle = {{lens_middle}};  // of the left eye
  lens_radius = {{lens_radius}};
  function bend(p) = let (
      x = abs(abs(p[0]) - lens_middle[0]) / lens_radius,
      up = abs(p[2] - lens_middle[2]) / lens_radius, forth = (lens_middle[1] - p[1]) / lens_radius,
      part = (1 - smooth({{lens_wide}}, {{lens_aside}}, x)) * smooth({{lens_behind}}, {{lens_front}}, forth),
      rise = {{lens_taller}} * (up < {{lens_full}} ? up : {{lens_full}} * (1 - smooth({{lens_full}}, {{lens_end}}, up))),
      near = part * (1 - smooth({{lens_wide}}, {{lens_far}}, up)))
    x >= {{lens_aside}} || forth <= {{lens_behind}} || up >= {{lens_end}} ? p
    : [p[0], p[1] + lens_radius * {{lens_flat}} * max(0, forth - {{lens_forth}}) * near,
       p[2] + sign(p[2] - lens_middle[2]) * lens_radius * rise * part];

