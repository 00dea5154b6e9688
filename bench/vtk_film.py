#!/usr/bin/python3
"""vtk_film.py FRAMES DIR: draws the T-wrench with VTK, physically based, 4 samples per pixel, 1920x1080,
each frame to a PNG file in DIR. Prints the milliseconds per frame. Run it under xvfb-run."""
import sys
import time

import vtk

frames, folder = int(sys.argv[1]), sys.argv[2]


def cylinder(length, turn, place):
    source = vtk.vtkCylinderSource()
    source.SetRadius(1)
    source.SetHeight(length)
    source.SetResolution(96)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.RotateZ(turn)
    actor.SetPosition(*place)
    look = actor.GetProperty()
    look.SetInterpolationToPBR()
    look.SetMetallic(0.9)
    look.SetRoughness(0.3)
    return actor


body = vtk.vtkAssembly()
body.AddPart(cylinder(8, 0, (-1, 0, 0)))
body.AddPart(cylinder(4, 90, (2, 0, 0)))
scene = vtk.vtkRenderer()
scene.SetBackground(0.1, 0.1, 0.12)
scene.AddActor(body)
scene.GetActiveCamera().SetPosition(0, 0, 20)
window = vtk.vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(4)
window.SetSize(1920, 1080)
window.AddRenderer(scene)
window.Render()
picture = vtk.vtkWindowToImageFilter()
picture.SetInput(window)
picture.ReadFrontBufferOff()
writer = vtk.vtkPNGWriter()
writer.SetInputConnection(picture.GetOutputPort())

start = time.perf_counter()
for i in range(frames):
    body.RotateX(3)
    window.Render()
    picture.Modified()
    writer.SetFileName(f"{folder}/frame_{i:06d}.png")
    writer.Write()
print(f"{1e3 * (time.perf_counter() - start) / frames:.1f}")
