// A print in plaster on a table, as it is: flat facets, one colour. Millimetres; z up, the face toward -y.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare Height = {{height_mm}};
#declare Width = max({{width_mm}}, Height * {{aspect}} * 0.7);
camera {
  location <-1.4 * Height, -3.4 * Height, 0.72 * Height>
  sky <0, 0, 1>
  up <0, 0, 1>
  right <-{{aspect}}, 0, 0>  // x to the right in a left-handed program: mirrored, to be right-handed
  angle degrees(2 * atan2(0.56 * max(Height * {{aspect}}, Width), 3.7 * Height))
  look_at <0, 0, 0.5 * Height>
}
light_source { <-3, -4, 5> * Height rgb 0.95 area_light <0.8, 0, 0> * Height, <0, 0, 0.8> * Height, 5, 5 adaptive 1 jitter }
light_source { <4, -3, 1.5> * Height rgb 0.22 shadowless }
// A table that fades into the room.
#declare Room = color rgb <0.24, 0.25, 0.27>;
background { Room }
fog { fog_type 1 distance 11 * Height Room }
plane { z, 0 pigment { rgb <0.36, 0.37, 0.39> } finish { diffuse 0.8 ambient 0.05 } }
mesh2 {
  vertex_vectors { {{vertex_count}}, {{vertices}} }
  face_indices { {{face_count}}, {{faces}} }
  pigment { rgb <0.74, 0.73, 0.71> }
  finish { diffuse 0.78 ambient 0.06 }
}
