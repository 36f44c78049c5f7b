; {project}, {immersion}: job {job}
; For LinuxCNC with up to three linear and three rotary axes. From G93 on, F is inverse time:
; one divided by the minutes of the move, whatever axes it moves.
; X to the right, Y to the film's upper edge, Z up, mm from the film's centre on the water: the place of the
; part's pivot. A, B, C turn the part about X, Y, Z, in this order and about fixed axes, degrees; 0 is the
; rotation at the end of the dip. Axes that do not move are left out.
G21 ; mm
G90 ; absolute
{moves}
M2
