# Errors that are reported before the application is contacted.
args swap
args swap a.sm
args swap a.sm --to=nowhere
args swap a.sm --to=nowhere --continue --restart
args swap a.sv --to=nowhere --continue
args swap a.sm a=a.sm --to=nowhere --continue
args swap wrong.sm --to=nowhere --continue
args swap missing.smb --to=nowhere --restart=Idle
args swap a.sm --to=nowhere --continue -w
args swap a.sm --to=a.sm --restart -w
args swap a.sm --to=:99999 --restart -w
args swap --help

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle] @swap
.step
    open = true
-- wrong.sm --
[state_vector]
U64 G
[Idle]
.step
    open = true
-- a.sv --
[A]
U64 G
-- stdout --
Usage: smc swap FILE...|NAME=FILE...|NAME=built-in... --to=WHERE --restart[=STATE]|--continue
  replace machines of an application that runs, without stopping it

Options:
  --help                   print help and exit
  --version                print the version and exit
  --sv=FILE                the application's state vector
  --bind=NAME=ELEMENT      the machine's element NAME is ELEMENT of the state vector; several
                           between commas
  --app=FILE               the application, for its state vector and its machines' bindings
  -OLEVEL                  how hard to optimise: 0, 1 or 2 (default 2)
  --to=WHERE               where the application listens: the path of its socket, HOST:PORT, or a
                           serial line as /dev/ttyS1
  --restart[=STATE]        the new machines start, in this state or in their first one
  --continue               the new machines continue in the state of the same name, with locals and
                           windows that both have
  --wait                   end when the trial has ended; an error if the old machines have returned
  --speed=N                bits a second on it (default 115200)
  --confirm                keep what was sent once it runs, without a trial
  --key=FILE               the key to sign with
  --message-format=FORMAT  the form of messages: text (default), json, or sarif if the command reads
                           sources
  --color=WHEN             auto (default), always or never
  -w                       no warnings
  -WNAME                   -Wextra, -Wflight, -Weverything, -Wname, -Wno-name, -Werror, -Werror=name
-- stderr --
smc: swap requires the machines to send, as in 'smc swap tank.sm --to=stand.sock --continue'
Try 'smc swap --help'.
smc: swap requires --to, the place where the application listens, as in --to=stand.sock, --to=10.0.0.5:4711 or --to=/dev/ttyS1
Try 'smc swap --help'.
smc: swap requires --continue or --restart: with --continue a new machine continues in the state of the same name, and keeps the locals and windows that both have; with --restart it starts as if it had never run, in its first state or in that of --restart=STATE
Try 'smc swap --help'.
smc: --continue and --restart exclude each other
Try 'smc swap --help'.
smc: 'a.sv' is not a machine: swap accepts .sm and .smb files, as in 'smc swap tank.sm' or 'smc swap tank=other.smb', and 'tank=built-in'
Try 'smc swap --help'.
smc: 'a' is named twice: a swap replaces each machine once
Try 'smc swap --help'.
wrong.sm:1:1: error: the machine has no element 'S' for the state; list U32 S, or mark the element that is to hold the state with @alias S [E0209]
    1 | [state_vector]
      | ^~~~~~~~~~~~~~
wrong.sm:5:5: error: unknown element 'open' [E0204]
    5 |     open = true
      |     ^~~~
2 errors
smc: cannot read 'missing.smb': No such file or directory
smc: cannot open 'nowhere': No such file or directory
smc: cannot open 'a.sm': it is no serial line
smc: cannot open ':99999': it is no HOST:PORT with a port from 1 to 65535
-- exit --
2 2 2 2 2 2 1 3 3 3 3 0
