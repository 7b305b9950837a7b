// Pictures of the exported parts: openscad -D 'folder="..."' -D 'show=[...]' view.scad
include <robot.scad>
part = "none";
folder = "";
pan_deg = 0;
tilt_deg = 0;
show = [for (p = parts) p[0]];
shown_screws = [];
apart = [];  // name and shift of parts that are drawn apart
cut = 0;  // 1: without the half to the right of the pan axis, 2: without what is in front of the tilt axis

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

module kept() {
  if (cut == 0) children();
  else difference() {
    children();
    if (cut == 1) translate([0, -500, -1]) cube(1000);
    else translate([-500, 0, -1]) cube(1000);
  }
}

for (p = parts) if (listed(p[0], show))
  color(colour(p)) kept() moved(p[1]) translate(shift_of(p[0])) import(str(folder, "/", p[0], ".stl"));
for (s = screws) if (listed(s[0], shown_screws))
  color([0.6, 0.1, 0.1]) kept() translate(shift_of(s[0])) at_screw(s) screw(s[1], s[2], s[3]);
