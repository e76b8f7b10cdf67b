import os

# As the program does: threads of the linear algebra library only wait, and burn time doing so; before numpy is loaded
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from hypothesis import settings

# Compiling a kernel at its first call is not a slow test; the same examples every time, so that CI does not flicker
settings.register_profile("trackworthy", deadline=None, derandomize=True)
settings.load_profile("trackworthy")
