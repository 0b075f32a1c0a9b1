# A limit cannot judge a machine that an application compiles to C: an error, and no file, whatever its bytecode machines need.
args check r.app --max-ram=100000
args build r.app -o out --max-step=1000 --max-cycles=1000000
args build r.app -o out

-- r.sv --
[A]
U64 time
U32 s
U32 t
-- m.sm --
[state_vector]
U64 time @alias G
U32 s @alias S
[A] @safe
-- n.sm --
[state_vector]
U64 time @alias G
U32 t @alias S
[A] @safe
-- r.app --
[options]
state_vector "r.sv"
time         time 1 ms
[main]
every 10 ms:
    machine m "m.sm" @bytecode
    machine n "n.sm"
-- stderr --
n.sm:1:1: error: machine 'n' becomes C in this application, but --mcu, --max-ram, --max-step and --max-cycles judge only bytecode [E0863]
    1 | [state_vector]
      | ^
1 error
n.sm:1:1: error: machine 'n' becomes C in this application, but --mcu, --max-ram, --max-step and --max-cycles judge only bytecode [E0863]
    1 | [state_vector]
      | ^
1 error
-- exit --
1 1 0
