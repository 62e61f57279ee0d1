# Shows a case in ParaView: paraview --script=3d/show.py 3d/CASE.vtu
import sys

from paraview.simple import *

source = OpenDataFile(sys.argv[-1])
warped = WarpByVector(Input=source)
warped.Vectors = ["POINTS", "displacement"]
display = Show(warped)
display.Representation = "Surface With Edges"
ColorBy(display, ("POINTS", "displacement", "Magnitude"))
display.SetScalarBarVisibility(GetActiveViewOrCreate("RenderView"), True)
ResetCamera()
Render()
