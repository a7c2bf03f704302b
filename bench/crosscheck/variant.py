"""Which of Mitsuba's variants to use. Import it, and call use_variant(), before what imports mitsuba's types."""

import subprocess
import sys

import mitsuba as mi

VARIANTS = ("llvm_ad_rgb", "scalar_rgb")

# LLVM 15 aborts the process on what Mitsuba 3.9 gives it: found out in a process of its own.
_PROBE = "import mitsuba as mi, drjit as dr; mi.set_variant('llvm_ad_rgb'); dr.eval(dr.maximum(dr.arange(mi.Float, 16), 1))"


def use_variant(name=None):
    """`name`, one of VARIANTS; without one llvm_ad_rgb where LLVM is installed and recent enough, else scalar_rgb, which needs
    nothing and uses one core."""
    if name is None:
        probe = subprocess.run([sys.executable, "-c", _PROBE], capture_output=True, check=False)
        name = "llvm_ad_rgb" if probe.returncode == 0 else "scalar_rgb"
    mi.set_variant(name)
