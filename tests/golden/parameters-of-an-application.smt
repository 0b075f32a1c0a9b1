# A machine of an application has the values of its bindings: in the image, where the default stays; in C; and on the page. The words of a
# refusal are those of 'smc set'.
args build -w channel.sm --sv rocket.sv --bind burn=50 --bind gain=0.5 -o bound.smb
args set bound.smb
args build -w channel.sm --sv rocket.sv -o plain.smb
args set plain.smb
args set plain.smb burn=50 gain=0.5 -o set.smb && cmp set.smb bound.smb
args build -w channel.sm --sv rocket.sv --bind burn=5001 -o wrong.smb
args build -w channel.sm --sv rocket.sv --bind burn=50 --emit=c -o channel.c && grep 'm->burn = 50;' channel.c
args report channel.sm --sv rocket.sv --bind burn=50 --format=text -o page.txt && sed -n '/^Parameters that can be set/,/^  gain/p' page.txt

-- channel.sm --
[options]
time_unit ms
[state_vector]
U64  time  @alias G
U32  state @alias S
bool fire
[local]
U32 burn = 1000 @parameter @range 0 5000
F32 gain = 2 @parameter @range -1 10
[Fire]
.entry
    fire = true
.step
    T >= burn and gain > 0: -> Done
.exit
    fire = false
[Done] @safe
-- rocket.sv --
[A]
U64  time
U32  state
bool fire
-- stdout --
logic 51c38cc72556950d, settings 1990f5b7f5436647
burn = 50 (U32, 0 to 5000, default 1000)
gain = 0.5 (F32, -1 to 10, default 2)
logic 51c38cc72556950d, settings 546c682eed139ba3
burn = 1000 (U32, 0 to 5000, default 1000)
gain = 2 (F32, -1 to 10, default 2)
    m->burn = 50;
Parameters that can be set
Values that are set before the machine starts, without compiling it again. The findings are true of
every value in the range.

  Parameter  Type  Range      Default  Value  Read in  Line
  burn       U32   0 to 5000  1000     50     Fire        8
  gain       F32   -1 to 10   2        2      Fire        9
-- stderr --
--bind:1:6: error: cannot set parameter 'burn' to 5001: the value is above the range [E0424]
    1 | burn=5001
      |      ^~~~ its range is 0 to 5000
channel.sm:8:5: note: 'burn' is declared here
1 error
-- exit --
0 0 0 0 0 1 0 0
