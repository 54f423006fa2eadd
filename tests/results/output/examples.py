# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every session of python/examples runs, and what it asserts holds; skipped (127) without matplotlib.
usage: examples.py PROGRAM ROOT"""
import glob
import os
import subprocess
import sys

program, root = map(os.path.realpath, sys.argv[1:3])
try:
    import matplotlib as _
except ImportError:  # the python3 found first may be another one than Debian's, which has the package
    if os.path.exists("/usr/bin/python3") and sys.executable != "/usr/bin/python3":
        os.execv("/usr/bin/python3", ["/usr/bin/python3", *sys.argv])
    print("SKIP there is no matplotlib (package python3-matplotlib)")
    sys.exit(127)

environment = {**os.environ, "SIGNORINI": program, "PYTHONPATH": os.path.join(root, "python"), "PYTHONDONTWRITEBYTECODE": "1",
               "MPLBACKEND": "Agg"}
files = sorted(glob.glob(os.path.join(root, "python/examples/*.py")))
failures = 0 if files else 1
for file in files:
    done = subprocess.run([sys.executable, file], env=environment, capture_output=True, text=True, check=False)
    failures += done.returncode != 0
    print(f"{os.path.basename(file)}: {'ok' if done.returncode == 0 else 'FAILED'}\n{done.stdout}{done.stderr}")
print(f"{failures} failures")
sys.exit(failures > 0)
