; {project}, {immersion}: job {job}
; One linear axis, Z up, mm: Z0 is where the body's lowest point meets the water.
; Begins {start_mm} mm above the water, ends {depth_mm} mm under it, at {speed_mm_s} mm/s.
G21 ; mm
G90 ; absolute
G1 Z{park_mm} F{approach_mm_min} ; over the film
M0 ; film swollen, activator sprayed: go on
G1 Z{start_mm} F{approach_mm_min}
G1 Z-{depth_mm} F{speed_mm_min} ; the dip: {dip_s} s
G4 P{hold_ms} ; held under water
M0 ; film round the body cleared from the water: go on
G1 Z{park_mm} F{speed_mm_min} ; out
M2
