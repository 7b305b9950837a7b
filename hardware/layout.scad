// Positions that follow from the dimensions, in the robot's frame at pan 0 and tilt 0: x right, y forward, z up,
// the origin on the ground below the pan axis. The bracket's frame has its origin on the tilt axis.
include <dimensions.scad>

function camera_named(name) = name == "D435" ? camera_D435 : name == "D435i" ? camera_D435i
                            : name == "D405" ? camera_D405 : name == "D455" ? camera_D455 : undef;
cam = camera_named(camera);
assert(cam != undef, "camera must be D435, D435i, D405 or D455");
side = cam[5];  // the plug's side: there is more room there
half = cam[0] / 2;
tilt_axis_z = servo1_z + tilt_z;

// Foot and column.
foot_z = foot_clearance;
column_z = foot_z + foot_thickness;

supports = [for (x = [-support_at, support_at], y = [-support_at, support_at]) [x, y]];

// Pan joint, from the yoke's floor downwards.
ring_z = servo1_z - gap - ring_thickness;  // lower face of the retaining ring, upper face of the upper bearing
bearings_z = [ring_z - 2 * pan_bearing[2] - pan_bearing_distance, ring_z - pan_bearing[2]];
hub_z = bearings_z[0] - floor_thickness;  // the hub's lower face lies on the servo's horn
servo_z = hub_z - servo_horn_top;  // face of the pan servo, lower face of the housing, top of the column
post_x = column_x - post_inset;
posts = [for (x = [-post_x, post_x], y = [column_front - post_inset, -column_rear + post_inset]) [x, y]];
ring_screws = [[-post_x, -20], [post_x, -20]];
hub_screws = [for (a = [45 : 90 : 315]) hub_screw_radius * [cos(a), sin(a)]];
horn_screws = [for (a = [45 : 90 : 315]) servo_horn_screws / 2 * [cos(a), sin(a)]];
cradle_screws = [for (x = [-17, 17], y = [6, -28]) [x, y]];  // beside the servo, in its frame

// Tilt joint along x; the servo is on the left for all cameras, so that a positive turn of it is up.
servo_ear_x = -half - (side < 0 ? plug_length : side_gap);  // inner face of the servo's ear
servo_arm_x = servo_ear_x - ear - gap;  // inner face of the servo's arm
tilt_servo_x = servo_arm_x - floor_thickness;
pivot_ear_x = half + (side > 0 ? plug_length : side_gap);
pivot_arm_x = pivot_ear_x + pivot_ear + gap;
arm_screws = [-13, 0, 13];
clamp_screws = [for (x = [-20, 0, 20]) [x, clamp_y]];

// Bracket's frame.
camera_back_y = imager_y + cam[3] - cam[2];
camera_hole = cam[10] == 4 ? m4_hole : m3_hole;
plate_y = bracket_back + bracket_thickness;  // the bracket's front
frame_y = camera_back_y + cam[2] + 2 - led_frame_y;  // rear face of the LED frame, 2 in front of the camera
plug_front_y = imager_y - cam[11] + cam[12] / 2 + 0.2;
led_row = cam[1] / 2 + led_opening + led_bar / 2;  // from the imager's height
led_column = half + led_opening + led_bar / 2;
leds_in_row = floor((half + led_bar / 2) / led_pitch);
post_at = led_pitch * floor(half / led_pitch) + led_pitch / 2;
post_row = led_row + post_outwards;
led_posts = [for (x = [-post_at, post_at], z = [-post_row, post_row]) [x, imager_z + z]];
leds = concat([for (i = [-leds_in_row : leds_in_row], z = [-led_row, led_row]) [i * led_pitch, imager_z + z]],
              [for (x = [-led_column, led_column], z = [-cam[1] / 2, cam[1] / 2]) [x, imager_z + z]]);
plate_z = post_row + post_diameter / 2 + 1;  // half height of the bracket's plate, from the imager's height

module on_tilt_axis() { translate([0, 0, tilt_axis_z]) children(); }
// Servo's frame to the tilt servo's: the shaft points along +x, the case downwards.
module as_tilt_servo() {
  translate([tilt_servo_x, 0, tilt_axis_z])
    multmatrix([[0, 0, 1, 0], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]]) children();
}
