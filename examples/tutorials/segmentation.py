# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# # From a segmentation to a folded brain
# docs/guide/segmentation.md with an image in memory. The labels are those of the phantom; take yours from nibabel.

# %%
from pathlib import Path

import nibabel
import numpy as np

import corticle

if not Path("labels.nii.gz").exists():
    corticle.phantom("labels.nii.gz", voxel_mm=2.0)
image = nibabel.load("labels.nii.gz")
print(image.shape, np.unique(np.asarray(image.dataobj)))

# %% [markdown]
# What the labels measure, and the body made of them. `notes` says what was done to the image.

# %%
before = corticle.measure("labels.nii.gz", labels=[2, 3, 5, 7])
print(f"{before['volume_mm3'] / 1000.0:.1f} cm³, {before['area_mm2'] / 100.0:.1f} cm²")
body = corticle.prepare(image, labels=[2, 3, 5, 7], particles=2000, end=0.02)
print(*body.notes, sep="\n")

# %% [markdown]
# Labels that are not there are refused, with the list of those that are.

# %%
try:
    corticle.prepare(image, labels=[2, 42], particles=2000)
except corticle.InputError as error:
    print(error)

# %%
simulation = corticle.Simulation(body)
simulation.run()
print(simulation)
print({name: round(value, 3) for name, value in simulation.energies.items()})
