// A sheet's page without its pictures: paper, rules and words. One unit is a pixel, y up from the page's lower edge.
#version 3.7;
global_settings { assumed_gamma 1 charset utf8 }
#declare Page_width = {{width}};
#declare Page_height = {{height}};
camera {
  orthographic
  location <Page_width / 2, Page_height / 2, -100>
  direction z
  right x * Page_width
  up y * Page_height
}
background { srgb <243, 240, 233> / 255 }

#macro plate_ink(Strength)  // 1 black on the paper, 0 the paper itself
  pigment { srgb <243, 240, 233> / 255 * (1 - Strength) + <38, 34, 31> / 255 * Strength }
  finish { ambient 0 diffuse 0 emission 1 }
#end
// Align 0: X is the words' left end, .5 their middle, 1 their right end. Words wider than Room are made smaller.
#macro plate_words(Font, Words, X, Y, Size, Align, Room, Strength)
  #local Set = text { internal Font Words 1, 0 }
  #local Width = max_extent(Set).x;  // from the first letter's origin
  #local Scale = min(Size, Room / max(Width, .001));
  object { Set scale <Scale, Scale, 1> translate <X - Align * Width * Scale, Page_height - Y, 0> plate_ink(Strength) }
#end
#macro plate_rule(X, Y, Width, Thickness, Strength)
  box { <X, Page_height - Y - Thickness, 0>, <X + Width, Page_height - Y, 1> plate_ink(Strength) }
#end
#macro plate_line(X, Y, To_x, To_y, Thickness, Strength)
  #local From = <X, Page_height - Y, 0>;
  #local To = <To_x, Page_height - To_y, 0>;
  union {
    sphere { From, Thickness / 2 }
    sphere { To, Thickness / 2 }
    #if (vlength(To - From) > Thickness / 100) cylinder { From, To, Thickness / 2 } #end
    plate_ink(Strength)
  }
#end
// A line whose end is the point of its tip: 5 thicknesses long, on a short arrow two thirds of it.
#macro plate_arrow(X, Y, To_x, To_y, Thickness, Strength)
  #local From = <X, Page_height - Y, 0>;
  #local To = <To_x, Page_height - To_y, 0>;
  #local Way = vlength(To - From);
  #if (Way > Thickness / 100)
    #local Tip = min(5 * Thickness, Way * 2 / 3);
    #local Neck = To - (To - From) * Tip / Way;
    union {
      sphere { From, Thickness / 2 }
      cylinder { From, Neck, Thickness / 2 }
      cone { Neck, Tip * .42, To, 0 }
      plate_ink(Strength)
    }
  #end
#end
// Paper under all: a page without a word is no empty scene.
box { <-1, -1, 2>, <Page_width + 1, Page_height + 1, 3> plate_ink(0) }
{{marks}}
