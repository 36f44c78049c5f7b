; {project}, {immersion}: job {job}
; For Marlin 2.1 with up to three linear and three rotary axes. F is in mm of the linear axes per minute, or
; in degrees per minute if only rotary axes move.
; X to the right, Y to the film's upper edge, Z up, mm from the film's centre on the water: the place of the
; part's pivot. A, B, C turn the part about X, Y, Z, in this order and about fixed axes, degrees; 0 is the
; rotation at the end of the dip. Axes that do not move are left out.
G21 ; mm
G90 ; absolute
{moves_per_minute}
M0 ; part out of the water
