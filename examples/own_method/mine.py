import numpy as np

stretch, nu, young, side = 0.9, 0.25, 10e3, 0.05              # uniaxial, pressed by 10 %
text = open("cube.inp").read().split("*NODE, NSET=Nall\n")[1].split("*ELEMENT")[0]
nodes = np.array([line.split(",") for line in text.splitlines()], float)  # number, x, y, z
across = stretch**-nu                                         # Hencky's law, stress along z
u = nodes[:, 1:] * [across - 1, across - 1, stretch - 1]      # displacements [m]
np.savetxt("mine.csv", np.c_[nodes[:, 0], u], delimiter=",", fmt="%.17g",
           header="node,ux,uy,uz", comments="")
top = nodes[nodes[:, 3] == side, 0]                           # nodes of the moved plate
force = young * np.log(stretch) / stretch * side**2           # of the plate on the body [N]
f = np.outer(np.full(len(top), force / len(top)), [0, 0, 1])
np.savetxt("forces.csv", np.c_[top, f], delimiter=",", fmt="%.17g",
           header="node,fx,fy,fz", comments="")
