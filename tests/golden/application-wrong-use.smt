# An application names its files itself, and becomes C.
args build a.app --sv a.sv
args build a.app b.app
args build a.sm a.app
args build a.app --emit=bytecode
args build a.app --prefix=x
args build a.app -o -
args check a.app a.sv
args check a.sv a.app
args a.app
args build nosuch.app
args check a.app --message-format=json
args build a.app
args mutate a.app a.ss
args cover a.app -o made
args prove a.app a.rq
args faults a.app a.ss
args sweep a.app a.ss --set x=1:2:3
args diff a.app b.app
args report a.app
args graph nosuch.app
args build a.app --emit=ast

-- a.sv --
[A]
U64 time
-- a.sm --
[A]
-- a.app --
[options]
state_vector "a.sv"
[flight]
every 25 ms:
    task a @mode tim
every 10 ms:
    machine m "missing.sm"
-- stdout --
# Syntax tree of a.app, printed by smc
options
  state_vector "a.sv"
executor flight
  every 25 ms
    task a @mode tim
  every 10 ms
    machine m "missing.sm"
-- stderr --
smc: 'a.app' names its state vector itself: remove --sv
Try 'smc build --help'.
smc: an application is built alone: it names its files itself
Try 'smc build --help'.
smc: an application is built alone: it names its files itself
Try 'smc build --help'.
smc: an application becomes C, not bytecode
Try 'smc build --help'.
smc: the names in an application's C come from its files: remove --prefix
Try 'smc build --help'.
smc: an application becomes several files: name the folder for them with -o
Try 'smc build --help'.
smc: an application is checked alone or with its scripts and requirements: it names its other files itself
Try 'smc check --help'.
smc: an application is checked alone or with its scripts and requirements: it names its other files itself
Try 'smc check --help'.
smc: a command precedes the file, as in 'smc check a.app'
Try 'smc --help'.
smc: cannot read 'nosuch.app': No such file or directory
{"severity":"error","code":"E1035","message":"25 ms is not a multiple of 10 ms, the tick of [flight]","file":"a.app","line":4,"column":1,"endLine":4,"endColumn":13,"label":"20 ms or 30 ms would be","notes":[],"edits":[],"flag":null,"group":null}
{"severity":"error","code":"E0204","message":"unknown element 'tim'","file":"a.app","line":5,"column":18,"endLine":5,"endColumn":21,"label":"did you mean 'time'?","notes":[{"message":"'time' is declared here","file":"a.sv","line":2,"column":5,"endLine":2,"endColumn":9,"step":null}],"edits":[],"flag":null,"group":null}
{"severity":"error","code":"E1030","message":"machine 'm' needs the time: in [options], time ELEMENT 1 ms","file":"a.app","line":7,"column":13,"endLine":7,"endColumn":14,"label":null,"notes":[],"edits":[],"flag":null,"group":null}
{"severity":"error","code":"E1031","message":"cannot read 'missing.sm': No such file or directory","file":"a.app","line":7,"column":15,"endLine":7,"endColumn":27,"label":null,"notes":[],"edits":[],"flag":null,"group":null}
a.app:4:1: error: 25 ms is not a multiple of 10 ms, the tick of [flight] [E1035]
    4 | every 25 ms:
      | ^~~~~~~~~~~~ 20 ms or 30 ms would be
a.app:5:18: error: unknown element 'tim' [E0204]
    5 |     task a @mode tim
      |                  ^~~ did you mean 'time'?
a.sv:2:5: note: 'time' is declared here
a.app:7:13: error: machine 'm' needs the time: in [options], time ELEMENT 1 ms [E1030]
    7 |     machine m "missing.sm"
      |             ^
a.app:7:15: error: cannot read 'missing.sm': No such file or directory [E1031]
    7 |     machine m "missing.sm"
      |               ^~~~~~~~~~~~
4 errors
smc: cannot read 'a.ss': No such file or directory
a.app:4:1: error: 25 ms is not a multiple of 10 ms, the tick of [flight] [E1035]
    4 | every 25 ms:
      | ^~~~~~~~~~~~ 20 ms or 30 ms would be
a.app:5:18: error: unknown element 'tim' [E0204]
    5 |     task a @mode tim
      |                  ^~~ did you mean 'time'?
a.sv:2:5: note: 'time' is declared here
a.app:7:13: error: machine 'm' needs the time: in [options], time ELEMENT 1 ms [E1030]
    7 |     machine m "missing.sm"
      |             ^
a.app:7:15: error: cannot read 'missing.sm': No such file or directory [E1031]
    7 |     machine m "missing.sm"
      |               ^~~~~~~~~~~~
4 errors
smc: cannot read 'a.rq': No such file or directory
smc: cannot read 'a.ss': No such file or directory
smc: cannot read 'a.ss': No such file or directory
smc: 'a.app' is an application, and smc diff is for one machine, with scripts of that machine. Its machines:
  m: smc diff OLD.sm missing.sm --sv a.sv
a.app:4:1: error: 25 ms is not a multiple of 10 ms, the tick of [flight] [E1035]
    4 | every 25 ms:
      | ^~~~~~~~~~~~ 20 ms or 30 ms would be
a.app:5:18: error: unknown element 'tim' [E0204]
    5 |     task a @mode tim
      |                  ^~~ did you mean 'time'?
a.sv:2:5: note: 'time' is declared here
a.app:7:13: error: machine 'm' needs the time: in [options], time ELEMENT 1 ms [E1030]
    7 |     machine m "missing.sm"
      |             ^
a.app:7:15: error: cannot read 'missing.sm': No such file or directory [E1031]
    7 |     machine m "missing.sm"
      |               ^~~~~~~~~~~~
4 errors
smc: cannot read 'nosuch.app': No such file or directory
-- exit --
2 2 2 2 2 2 2 2 2 3 1 1 3 1 3 3 3 2 1 3 0
