; {project}, {immersion}: job {job}
; For Marlin, GRBL and LinuxCNC: uses only commands that mean the same on all three. M0 must wait for
; the operator. On RepRapFirmware M0 ends the job, and Klipper has no M0: use your own template there.
; One linear axis, Z up, mm. At Z0 the lowest point of the part meets the water.
; The dip starts {start_mm} mm above the water and ends {depth_mm} mm below it, at {speed_mm_s} mm/s.
G21 ; mm
G90 ; absolute
G1 Z{park_mm} F{approach_mm_min} ; over the film
M0 ; continue when the film has swollen and the activator is sprayed
G1 Z{start_mm} F{approach_mm_min}
G1 Z-{depth_mm} F{speed_mm_min} ; the dip: {dip_s} s
; Slow moves hold the part under water for {hold_s} s. G4 P is not used: it counts ms on Marlin and s
; on GRBL and LinuxCNC.
G1 Z-{hold_depth_mm} F{hold_mm_min}
G1 Z-{depth_mm} F{hold_mm_min}
M0 ; continue when the film around the part is cleared from the water
G1 Z{park_mm} F{speed_mm_min} ; out
M2
