; {project}, {immersion}: job {job}
; For Marlin, GRBL and LinuxCNC: of G-code only what means the same on all three. M0 must wait for
; the operator; on RepRapFirmware it ends the job and Klipper knows none: take a template of your own.
; One linear axis, Z up, mm: Z0 is where the body's lowest point meets the water.
; Begins {start_mm} mm above the water, ends {depth_mm} mm under it, at {speed_mm_s} mm/s.
G21 ; mm
G90 ; absolute
G1 Z{park_mm} F{approach_mm_min} ; over the film
M0 ; film swollen, activator sprayed: go on
G1 Z{start_mm} F{approach_mm_min}
G1 Z-{depth_mm} F{speed_mm_min} ; the dip: {dip_s} s
; Held under water for {hold_s} s, by slow moves: G4 P counts ms on Marlin and s on GRBL and LinuxCNC.
G1 Z-{hold_depth_mm} F{hold_mm_min}
G1 Z-{depth_mm} F{hold_mm_min}
M0 ; film round the body cleared from the water: go on
G1 Z{park_mm} F{speed_mm_min} ; out
M2
