# SPDX-License-Identifier: Apache-2.0
# Reads the header of the machine `far` with cffi, which evaluates neither sizeof nor conditional expressions, and runs the machine in a shared
# library.  The layouts must agree.     foreign.py PREPROCESSED-HEADER LIBRARY
import sys

try:
    import cffi
except ImportError:
    sys.exit(77)

ffi = cffi.FFI()
ffi.cdef(open(sys.argv[1]).read())
lib = ffi.dlopen(sys.argv[2])
assert ffi.sizeof("Far") == lib.far_size(), (ffi.sizeof("Far"), lib.far_size())
assert ffi.sizeof("FarSv") == lib.far_sv_size(), (ffi.sizeof("FarSv"), lib.far_sv_size())
m, sv = ffi.new("Far *"), ffi.new("FarSv *")
assert lib.far_init(m, sv, lib.FAR_INITIAL_STATE) == lib.FAR_OK
for sv.G in range(1, 41):
    sv.x = sv.G
    assert lib.far_step(m, sv) == lib.FAR_OK
assert (sv.least, m.steps) == (1, 40)
