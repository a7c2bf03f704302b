"""Which machine this is. Its name is what makes two measurements comparable."""

import os
import platform
import re
from pathlib import Path


def cpu_name():
    """As the kernel says it; /proc/cpuinfo has no model name on every architecture."""
    found = re.search(r"^model name\s*:\s*(.+)$", Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.MULTILINE)
    return found.group(1) if found else platform.machine()


def this_machine():
    """cpu, cores, memory_gib (rounded: kernels differ by some MiB in what they leave) and a name made of them."""
    cpu, cores = cpu_name(), os.cpu_count()
    memory_gib = round(os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / 2**30)
    slug = re.sub(r"[^a-z0-9]+", "-", cpu.lower()).strip("-")
    return {"name": f"{slug}-{cores}-cores-{memory_gib}-gib", "cpu": cpu, "cores": cores, "memory_gib": memory_gib}
