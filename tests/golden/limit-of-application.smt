# The limits of an application apply to the images that it contains: with names, where locals can be observed, or with --strip.
args check r.app --max-ram=120
args build r.app -o out --max-ram=120
args build r.app -o out --max-ram=120 --strip

-- r.sv --
[A]
U64 time
U32 s
F64 x
-- m.sm --
[state_vector]
U64 time @alias G
U32 s @alias S
F64 x
[local]
F64 a = 1
F64 b = 2
F64 c = 3
F64 d = 4
[A] @safe
.step
    a = x
    b = a + 1
    c = b + 1
    d = c + 1
    x = a + b + c + d
-- r.app --
[options]
state_vector "r.sv"
time         time 1 ms
[main]
every 10 ms:
    machine m "m.sm" @bytecode
-- stderr --
m.sm:1:1: error: machine 'm' needs 128 bytes of RAM on a 64-bit computer, but --max-ram allows 120 [E0860]
    1 | [state_vector]
      | ^
note: 0 bytes are for windows, 32 for locals, 96 for the VM itself
1 error
m.sm:1:1: error: machine 'm' needs 128 bytes of RAM on a 64-bit computer, but --max-ram allows 120 [E0860]
    1 | [state_vector]
      | ^
note: 0 bytes are for windows, 32 for locals, 96 for the VM itself
1 error
-- exit --
1 1 0
