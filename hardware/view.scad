// Pictures of the exported parts: openscad -D 'folder="..."' -D 'show=[...]' view.scad
include <robot.scad>
part = "none";
folder = "";
pan_deg = 0;
tilt_deg = 0;
show = [for (p = parts) p[0]];
shown_screws = [];
apart = [];  // name and shift of parts that are drawn apart
cut = "";  // "x": without what is right of the pan axis; "y": without what is in front of the tilt axis
uncut = [];  // parts that stay whole
bright = [];  // parts in their colours, the other printed ones grey; all in colours if empty

function colour(p) = p[2] == "printed" ? (p[1] == "fixed" ? [0.35, 0.45, 0.6] : p[1] == "pan" ? [0.85, 0.6, 0.25] : [0.45, 0.65, 0.4])
  : p[0] == "camera" ? [0.75, 0.76, 0.78] : p[0] == "leds" ? [1, 1, 0.8]
  : p[0] == "pan_bearings" || p[0] == "tilt_bearing" ? [0.8, 0.8, 0.85] : [0.2, 0.2, 0.22];
function listed(name, names) = len([for (n = names) if (n == name) n]) > 0;
function shift_of(name) = let (found = [for (a = apart) if (a[0] == name) a[1]]) len(found) > 0 ? found[0] : [0, 0, 0];

module moved(group) {
  if (group == "fixed") children();
  else rotate([0, 0, pan_deg]) {
    if (group == "pan") children();
    else on_tilt_axis() rotate([tilt_deg, 0, 0]) translate([0, 0, -tilt_axis_z]) children();
  }
}

// The camera's cable at pan 0 and tilt 0: from the plug in front of the bracket down, over the yoke's rear edge, in a
// loop to the column, and through its lower window to the clamp.
module camera_cable() {
  path = [[half + 9, 14, tilt_axis_z + 4], [half + 9, 8, tilt_axis_z - 16], [half + 4, -12, tilt_axis_z - 22],
          [half - 8, -34, 208], [30, -30, 198], [27, -22, 194], [22, -34, 186], [12, -56, 160], [4, -62, 138], [0, -54, 124],
          [0, -44, 114], [0, -37, 100], [4, -37, 60], [clamp_x, -40, column_z + clamp_z], [clamp_x, clamp_y, column_z + clamp_z]];
  for (i = [0 : len(path) - 2]) hull() for (p = [path[i], path[i + 1]]) translate(p) sphere(d = usb_cable, $fn = 16);
}

function shade(c, i) = cut == "" ? c : [for (v = c) min(1, v * (0.65 + 0.25 * (i % 4)))];  // adjacent cut parts differ

for (i = [0 : len(parts) - 1]) let (p = parts[i], at = 0.01 + 0.02 * i) if (listed(p[0], show))
  color(p[2] == "printed" && len(bright) > 0 && !listed(p[0], bright) ? [0.82, 0.84, 0.86] : shade(colour(p), i))
    moved(p[1]) translate(shift_of(p[0])) difference() {
      import(str(folder, "/", p[0], ".stl"), convexity = 10);
      // The viewer must be outside of the box; faces in one plane would all get the colour of the last part.
      if (cut != "" && !listed(p[0], uncut)) translate(cut == "x" ? [at, -150, -10] : [-150, at, -10])
        cube(cut == "x" ? [150, 300, 320] : [300, 150, 320]);
    }
for (s = screws) if (listed(s[0], shown_screws)) color([0.75, 0.1, 0.1]) translate(shift_of(s[0])) at_screw(s) screw(s[1], s[2], s[3]);
if (listed("camera", show) && cut == "") color([0.1, 0.1, 0.12]) on_tilt_axis() translate(shift_of("camera"))
  for (x = [0, cam[14]]) translate([x - cam[4], imager_y + cam[3] - 0.5, imager_z]) rotate([-90, 0, 0]) cylinder(d = 9, h = 1, $fn = 32);
if (listed("camera_cable", show)) color([0.2, 0.2, 0.22]) camera_cable();
