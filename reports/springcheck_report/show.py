# Shows a case in ParaView: pvpython 3d/show.py 3d/CASE.vtu
import sys

from paraview.simple import *

source = OpenDataFile(sys.argv[-1])
# Of a case that ended without an equilibrium, the last state.
names = source.PointData.keys()
name = next(name for name in ("displacement [m]", "partial_displacement [m]") if name in names)
warped = WarpByVector(Input=source)
warped.Vectors = ["POINTS", name]
display = Show(warped)
display.Representation = "Surface With Edges"
ColorBy(display, ("POINTS", name, "Magnitude"))
display.SetScalarBarVisibility(GetActiveViewOrCreate("RenderView"), True)
camera = GetActiveCamera()
camera.SetPosition(1.3, -1.9, 0.8)
camera.SetFocalPoint(0, 0, 0)
camera.SetViewUp(0, 0, 1)
ResetCamera()
Render()
Interact()
