"""From a body to a film: a table-tennis bat, thrown so that it spins about its intermediate axis.

The bat is built from two homogeneous solids, a disc and a grip (lengths in cm, densities in
g/cm^3). The exact motion gives the times at which it turns over, and the film shows it. The film is
small, so that it takes seconds; size=(1920, 1080) and fps=60 make a presentable one.
"""

import twrench

bat = twrench.Body(
    [
        twrench.Cylinder(radius=7.5, length=0.8, density=0.5, position=[0, 0, 0], axis=[0, 0, 1]),
        twrench.Box(size=[10, 2.8, 2.2], density=0.6, position=[-12, 0, 0]),
    ]
)
print(f"mass {bat.mass:.1f} g, principal moments {bat.principal_moments.round(1)} g cm^2")

omega = [0.02, 6, 0]  # rad/s, in body axes; the grip lies along x
motion = twrench.exact(bat, omega)
print(f"turns over first at {motion.first_flip:.3f} s, then every {motion.flip_interval:.3f} s")

scene = twrench.Scene(body=bat, omega=omega, method="exact", title="A table-tennis bat")
scene.size, scene.fps, scene.speed, scene.duration = (320, 180), 12, 1, 4
film = scene.render("bat.mp4", overwrite=True)
print(f"{film.path}: {film.frame_count} frames")
