# SPDX-License-Identifier: Apache-2.0
# The package as it is installed below the folder of an environment: its library and its header are its own.      installed.py FOLDER
import sys
from pathlib import Path

import smc

assert sys.argv[1] in smc.__file__, smc.__file__
assert {"libsmc.so", "smc.h", "py.typed"} <= {path.name for path in Path(smc.__file__).parent.iterdir()}
machine = smc.compile({"a.sm": "[state_vector]\nU64 G\nU32 S\nF64 p\nbool v\n[A]\n.step\n    v = p > 3\n"}, warnings=["no-all"]).machine()
assert machine.step(p=4).v is True and machine.run({"p": [1.0, 5.0]})["v"].tolist() == [False, True]
