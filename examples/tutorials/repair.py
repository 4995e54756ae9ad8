# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# # Surfaces that are not sound
# docs/guide/repair.md in Python: a hole is closed on demand, and what was done is said.

# %%
import corticle

ball = corticle.prepare(corticle.Case.sphere(particles=2000)).surface
holed = ball.triangles[5:]

# %%
try:
    corticle.prepare(ball.vertices, holed, particles=1500)
except corticle.InputError as error:
    print("refused:", error)

# %%
body = corticle.prepare(ball.vertices, holed, particles=1500, repair="auto")
for note in body.notes:
    print(note)
assert abs(body.volumes.sum() / 8000.0 - 1.0) < 0.1
