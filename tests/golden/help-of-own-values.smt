# The help of a command names its own values and defaults of an option that others have too.
args sweep --help

-- stdout --
Usage: smc sweep M.sm|X.app SCRIPT.ss... [R.rq...] --set NAME=LO:HI:N [--set NAME=LO:HI:N] [--sv V.sv]
  run the scripts with one or two parameters at many values, and show where asserts and requirements begin to fail

Options:
  --help                   print help and exit
  --version                print the version and exit
  -o FILE                  where the output goes; - is standard output
  --force                  replace an existing file that smc did not write; never a source or an
                           input
  --sv=FILE                the application's state vector
  --bind=NAME=ELEMENT      the machine's element NAME is ELEMENT of the state vector; several
                           between commas
  --step=N                 how much time advances from step to step, for what analyses find
                           (default: the step of the machine, or delta_t of the scripts if all have
                           the same)
  -MD                      write a make rule of what the output depends on
  -MF FILE                 where -MD writes; else the output's name ending in .d
  -MT TARGET               the target of that rule; else the output
  -MP                      an empty rule for each input, so that a removed one is no error
  --set=NAME=LO:HI:N       run with N values from LO to HI of this parameter; twice for a table of
                           two parameters
  --max-steps=N            give up on a script after N steps (default 1000000)
  --seed=N                 the seed of the scripts' random numbers, from 0 (default: that of each
                           script, else 0)
  --format=FORMAT          text, csv, json or svg (a plot or a heat map); else as FILE of -o ends;
                           else text
  --message-format=FORMAT  the form of messages: text (default), json, or sarif if the command reads
                           sources
  --message-file=FILE      write the messages to FILE in that form, else as its name ends (.json,
                           .sarif); standard error then has text
  --color=WHEN             auto (default), always or never
  -w                       no warnings
  -WNAME                   -Wextra, -Wflight, -Weverything, -Wname, -Wno-name, -Werror, -Werror=name
