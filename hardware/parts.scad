// Printed parts, each in the robot's frame at pan 0 and tilt 0.
include <layout.scad>
$fn = 64;

module rounded(x0, x1, y0, y1, r) {
  translate([x0 + r, y0 + r]) offset(r) square([x1 - x0 - 2 * r, y1 - y0 - 2 * r]);
}
module at(points) { for (p = points) translate(p) children(); }
// Sheets in the y-z plane, extruded along x.
module along_x(x, length) {
  translate([x, 0, 0]) multmatrix([[0, 0, 1, 0], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
    linear_extrude(length) children();
}
module along_y(y, length) {  // 2D x, y becomes x, z
  translate([0, y + length, 0]) rotate([90, 0, 0]) linear_extrude(length) children();
}
// A hole for a sunk M3 screw along -z, its head flush with z = 0, and open above it.
module sunk_m3(length, above = 1) {
  rotate_extrude($fn = 24) polygon([[0, -length], [m3_hole / 2, -length], [m3_hole / 2, (m3_hole - m3_sunk) / 2],
                                    [m3_sunk / 2, 0], [m3_sunk / 2, above], [0, above]]);
}
module window(width, z0, z1) {  // with a roof of 45 degrees
  polygon([[-width / 2, z0], [width / 2, z0], [width / 2, z1], [0, z1 + width / 2], [-width / 2, z1]]);
}

module foot() {
  slot = lever_width / 2 + 0.75;
  difference() {
    union() {
      translate([0, 0, foot_z]) linear_extrude(foot_thickness) difference() {
        rounded(-foot_side / 2, foot_side / 2, -foot_side / 2, foot_side / 2, foot_corner);
        for (x = [-cup_at, cup_at], y = [-cup_at, cup_at]) translate([x, y]) circle(d = m5_hole, $fn = 24);
        at(supports) circle(d = m5_hole, $fn = 24);
        translate([-slot, -foot_side / 2 - 1]) square([2 * slot, foot_side / 2 + 1 + lever_pivot.x + 7]);
      }
      for (x = [-slot - 6, slot]) along_x(x, 6) hull() {
        translate(lever_pivot) circle(6);
        translate([lever_pivot.x - 6, column_z - 1]) square([12, 1]);
      }
      translate([0, 0, column_z - 0.01]) linear_extrude(clamp_z + 0.01) clamp_outline();
    }
    at(posts) translate([0, 0, foot_z]) rotate([180, 0, 0]) sunk_m3(foot_thickness + 1);
    along_x(-20, 40) translate(lever_pivot) circle(d = m3_hole, $fn = 24);
    clamp_grooves();
    at(clamp_screws) translate([0, 0, column_z + clamp_z - m3_insert.y - 3]) cylinder(d = m3_insert.x, h = 20, $fn = 24);
  }
}

module clamp_outline() { rounded(-clamp_screws[2].x - 4, clamp_screws[2].x + 4, clamp_y - 6, clamp_y + 6, 2); }
module clamp_grooves() {
  for (s = [-1, 1]) along_y(clamp_y - 10, 20) translate([s * clamp_x, column_z + clamp_z])
    circle(d = s > 0 ? usb_cable : power_cable, $fn = 48);
}

module tether_clamp() {
  difference() {
    translate([0, 0, column_z + clamp_z + 0.5]) linear_extrude(8) difference() {
      clamp_outline();
      at(clamp_screws) circle(d = m3_hole, $fn = 24);
    }
    clamp_grooves();
  }
}

module release_lever() {
  along_x(-lever_width / 2, lever_width) translate(lever_pivot) difference() {
    union() {
      hull() { circle(7); translate([0, lever_arm]) circle(5); }
      hull() { circle(7); translate(lever_nose) circle(lever_tip); }
    }
    circle(d = m3_hole, $fn = 24);
    translate([0, lever_arm]) circle(d = 4, $fn = 24);
  }
}

module column_outline(inset = 0) {
  rounded(-column_x + inset, column_x - inset, -column_rear + inset, column_front - inset, column_corner);
}

module column() {
  height = servo_z - column_z;
  difference() {
    translate([0, 0, column_z]) linear_extrude(height) difference() {
      union() {
        difference() { column_outline(); column_outline(wall); }
        intersection() { column_outline(); at(posts) square(2 * post_inset, center = true); }
      }
      at(posts) circle(d = m3_insert.x, $fn = 24);
    }
    along_y(-column_rear - 1, wall + 2) {
      window(cable_window.x, column_z + 4, column_z + 4 + cable_window.y);
      window(24, column_z + 85, column_z + 97);
      for (x = [-16, 16], z = [78, 90]) translate([x, column_z + z]) square([3, 5], center = true);
    }
  }
}

module pan_housing() {
  difference() {
    translate([0, 0, servo_z]) linear_extrude(ring_z - preload - servo_z) difference() {
      column_outline();
      circle(d = servo_horn_diameter + 4);
      at(posts) circle(d = m3_hole, $fn = 24);
    }
    translate([0, 0, servo_z + floor_thickness]) cylinder(d = pan_bearing_shoulders[1], h = 60);
    translate([0, 0, bearings_z[0]]) cylinder(d = pan_bearing[1] + fit, h = 60, $fn = 96);
    at(cradle_screws) translate([0, 0, servo_z + floor_thickness]) {
      sunk_m3(floor_thickness + 1);
      cylinder(d = driver.x + 0.6, h = 60);
    }
    at(ring_screws) translate([0, 0, ring_z - preload - m3_insert.y - 1]) cylinder(d = m3_insert.x, h = 20, $fn = 24);
  }
}

module outer_spacer() {
  translate([0, 0, bearings_z[0] + pan_bearing[2]]) linear_extrude(pan_bearing_distance) difference() {
    circle(d = pan_bearing[1] - 0.2, $fn = 96);
    circle(d = pan_bearing_shoulders[1]);
  }
}

module retaining_ring() {
  difference() {
    translate([0, 0, ring_z]) linear_extrude(ring_thickness) difference() {
      column_outline();
      circle(d = pan_bearing_shoulders[1]);
    }
    at(concat(posts, ring_screws)) translate([0, 0, ring_z + ring_thickness]) sunk_m3(ring_thickness + 1);
  }
}

module hub() {
  top = ring_z - 2 * preload;
  difference() {
    union() {
      translate([0, 0, hub_z]) cylinder(d = pan_bearing_shoulders[0], h = floor_thickness, $fn = 96);
      translate([0, 0, hub_z + 1]) cylinder(d = pan_bearing[0] - fit, h = top - hub_z - 1, $fn = 96);
    }
    translate([0, 0, hub_z + floor_thickness]) cylinder(d = hub_bore, h = 60);
    translate([0, 0, hub_z - 1]) {
      cylinder(d = 7, h = 10, $fn = 24);
      at(horn_screws) cylinder(d = m2_hole, h = 10, $fn = 16);
    }
    at(hub_screws) translate([0, 0, top - m3_insert.y - 6]) cylinder(d = m3_insert.x, h = 20, $fn = 24);
  }
}

// In the servo's frame.
module servo_cradle() {
  inside = servo_clearance;
  module pocket(grown) {
    x = servo_size.x / 2 + grown;
    translate([-x, servo_axis_to_end + grown - servo_size.y - 2 * grown]) square([2 * x, servo_size.y + 2 * grown]);
  }
  difference() {
    union() {
      translate([0, 0, -servo_size.z - wall]) linear_extrude(servo_size.z + wall) {
        offset(1) offset(-1) pocket(inside + wall);
        at(cradle_screws) circle(4.5);
      }
    }
    translate([0, 0, -servo_size.z]) linear_extrude(servo_size.z + 1) difference() {
      pocket(inside);
      for (y = [5, -26], s = [-1, 1]) translate([s * (servo_size.x / 2 + inside), y]) square([2 * inside, 2], center = true);
    }
    translate([0, 0, -servo_size.z - wall - 1]) linear_extrude(wall + 2) rounded(-9, 9, -30, 9, 3);
    at(cradle_screws) translate([0, 0, -m3_insert.y - 3]) cylinder(d = m3_insert.x, h = 20, $fn = 24);
  }
}

module yoke_floor() {
  length = pivot_arm_x - servo_arm_x;
  difference() {
    union() {
      translate([0, 0, servo1_z]) linear_extrude(yoke_thickness) translate([servo_arm_x, -yoke_y]) square([length, 2 * yoke_y]);
      translate([0, 0, ring_z]) cylinder(d = pan_bearing_shoulders[0], h = servo1_z - ring_z + 1, $fn = 96);
    }
    translate([0, 0, ring_z - 1]) cylinder(d = 20, h = 30);
    at(hub_screws) translate([0, 0, servo1_z + yoke_thickness]) sunk_m3(yoke_thickness + 6);
    for (y = arm_screws, x = [servo_arm_x - 1, pivot_arm_x - 12]) translate([x, y, servo1_z + yoke_thickness / 2])
      rotate([0, 90, 0]) cylinder(d = m3_insert.x, h = 13, $fn = 24);
    for (x = [-30, -24, 24, 30]) translate([x, -yoke_y + 3.5, servo1_z - 1]) linear_extrude(20) square([3, 3], center = true);
  }
}

module servo_arm() {
  difference() {
    along_x(tilt_servo_x, floor_thickness) difference() {
      hull() {
        rounded(-yoke_y, yoke_y, servo1_z, servo1_z + yoke_thickness, 2);
        rounded(-arm_y, arm_y, tilt_axis_z - 33, tilt_axis_z + 14, 4);
      }
      translate([0, tilt_axis_z]) circle(d = servo_horn_diameter + 4);
      for (y = arm_screws) translate([y, servo1_z + yoke_thickness / 2]) circle(d = m3_hole, $fn = 24);
    }
    as_tilt_servo() translate([0, 0, floor_thickness]) at(cradle_screws) sunk_m3(floor_thickness + 1);
  }
}

module pivot_arm() {
  difference() {
    along_x(pivot_arm_x, pivot_arm) difference() {
      hull() {
        rounded(-yoke_y, yoke_y, servo1_z, servo1_z + yoke_thickness, 2);
        translate([0, tilt_axis_z]) circle(14);
      }
      translate([0, tilt_axis_z]) circle(d = tilt_bearing_lip);
      for (y = arm_screws) translate([y, servo1_z + yoke_thickness / 2]) circle(d = m3_hole, $fn = 24);
    }
    along_x(pivot_arm_x + pivot_arm - tilt_bearing[2], 10) translate([0, tilt_axis_z]) circle(d = tilt_bearing[1] + fit);
  }
}

module camera_bracket() {
  z0 = imager_z - plate_z;
  z1 = imager_z + plate_z;
  sunk = camera_back_y - bracket_back - camera_screw_seat;
  module ear(x, thickness) along_x(x, thickness) intersection() {
    hull() {
      circle(ear_radius);
      translate([bracket_back, -ear_radius]) square([bracket_thickness, ear_radius + 24]);
    }
    translate([bracket_back, -50]) square(100);
  }
  module slots(hole) for (x = [-cam[6] / 2, cam[6] / 2]) translate([x, imager_z]) hull()
    for (d = [-1, 1]) translate([d, 0]) circle(d = hole, $fn = 24);
  // The driver of the horn's upper screws passes below the stand beside the servo. Where that stand is too thick, it
  // is open below from there to the camera.
  stand_height = stand.y + camera_hole;
  driver_at = servo_horn_screws / 2 * sin(45);
  driver_room = driver_m2[0] / 2;
  module driver_passage() if (imager_z - stand_height / 2 < driver_at + driver_room)
    along_y(-driver_at - driver_room - 0.2, camera_back_y + driver_at + driver_room + 1.2)
      translate([-cam[6] / 2, imager_z - stand_height / 4 - 0.5]) square([stand.x + 1, stand_height / 2 + 1], center = true);
  on_tilt_axis() difference() {
    union() {
      along_y(bracket_back, bracket_thickness) difference() {
        rounded(servo_ear_x - ear, pivot_ear_x + pivot_ear, z0, z1, 3);
        if (cam[6] > 30) rounded(-cam[6] / 2 + 9, cam[6] / 2 - 9, imager_z - 9, imager_z + 9, 3);
        for (x = [half + 5, half + 13]) translate([side * x, -8]) square(3, center = true);
      }
      for (x = [-cam[6] / 2, cam[6] / 2]) along_y(plate_y - 0.01, camera_back_y - plate_y + 0.01)
        translate([x, imager_z]) square([stand.x, stand.y + camera_hole], center = true);
      ear(servo_ear_x - ear, ear);
      ear(pivot_ear_x, pivot_ear);
      for (p = led_posts) along_y(plate_y - 0.01, frame_y - plate_y + 0.01) translate(p) circle(d = post_diameter + 0.1);
    }
    driver_passage();
    along_y(bracket_back - 1, 100) slots(camera_hole);
    if (sunk > 0) along_y(bracket_back - 1, sunk + 1) slots(2 * camera_hole + 0.5);
    for (p = led_posts) along_y(frame_y - m3_insert.y - 3, 20) translate(p) circle(d = m3_insert.x, $fn = 24);
    along_x(servo_ear_x - ear - 1, ear + 2) {
      circle(d = 7, $fn = 24);
      at(horn_screws) circle(d = m2_hole, $fn = 16);
    }
    along_x(pivot_ear_x + pivot_ear - m5_insert.y, 20) circle(d = m5_insert.x);
    // A narrow camera's ears are closer than a driver is long: it passes the ear of the pivot.
    along_x(pivot_ear_x - 1, pivot_ear + 2) at(horn_screws) circle(d = driver_m2[0] + 0.7, $fn = 16);
  }
}

module led_frame() {
  on_tilt_axis() difference() {
    along_y(frame_y, led_frame_y) difference() {
      rounded(-half - led_opening - led_bar, half + led_opening + led_bar, imager_z - led_row - led_bar / 2,
              imager_z + led_row + led_bar / 2, 5);
      rounded(-half - led_opening, half + led_opening, imager_z - cam[1] / 2 - led_opening,
              imager_z + cam[1] / 2 + led_opening, 3);
      at(leds) circle(d = led_hole, $fn = 24);
    }
    for (p = led_posts) translate([p.x, frame_y + led_frame_y, p.y]) rotate([-90, 0, 0]) sunk_m3(led_frame_y + 1);
    if (plug_front_y > frame_y) along_y(frame_y - 1, plug_front_y > frame_y + led_frame_y - wall ? 20 : plug_front_y - frame_y + 1)
      translate([side > 0 ? half : -half - plug_length - 20, imager_z - cam[13] / 2 - 0.5]) square([plug_length + 20, cam[13] + 1]);
  }
}
