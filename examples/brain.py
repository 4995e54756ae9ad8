# SPDX-License-Identifier: GPL-3.0-or-later
"""From tissue labels to a run folder, and from there to GIFTI files and a table. The labels are those of a phantom."""

from pathlib import Path

import corticle

labels = Path("brain.nii.gz")
if not labels.exists():
    corticle.phantom(labels, voxel_mm=2.0)

case = corticle.Case.brain(labels, labels=[2, 3, 5, 7], particles=2000)
case.update(clock="wang", start_week=23.0, end_week=23.3, applies_to="body", pictures="off")
case.size.law = "quadratic"
case.output.weeks = [23.1, 23.2]
case.tissue.layer = "smooth"
case.tissue.thickness_mm = 2.5

run = corticle.run(case, "runs/brain", overwrite=True)
for frame in run.frames:
    surface = frame.surface
    print(f"week {frame.week:.1f}: deepest sulcus {surface.sulcal_depth.max():.2f} mm")

end = run.frames.nearest(week=23.3).surface
end.save("week23.surf.gii")
end.save_shape("sulcal_depth", "week23.sulcal_depth.shape.gii")
print(run.measures)
