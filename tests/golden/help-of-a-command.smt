# --help behind a command lists its options.
args test --help

-- stdout --
Usage: smc test M.sm|X.app SCRIPT.ss... [R.rq...] [--sv V.sv] [--engine=ENGINE]
  run state scripts and judge requirements; run .smt cases and folders of them

Options:
  --help                   print help and exit
  --version                print the version and exit
  --force                  replace an existing file that smc did not write; never a source or an
                           input
  --sv=FILE                the application's state vector
  --bind=NAME=ELEMENT      the machine's element NAME is ELEMENT of the state vector; several
                           between commas
  -OLEVEL                  how hard to optimise: 0, 1 or 2 (default 2)
  --step=N                 how much time advances from step to step, for what analyses find
                           (default: the step of the machine, or delta_t of the scripts if all have
                           the same)
  --engine=ENGINE          what runs the machine: vm (default), vm-soft, ref, c, c-soft, several
                           between commas, or all (but c-soft)
  --trace=FILE             write the values after every step as CSV: script, step, G, state,
                           elements; - is standard output, and the result goes to standard error
  --trace-elements=NAMES   the columns of the trace after the state, as a,b,c (default: all that can
                           change)
  --trace-format=FORMAT    csv (default), or exact: lines 'step element value' with every bit of
                           every element
  -v                       print the final state vector of failed scripts too, and of each of
                           several
  --set=NAME=VALUE         set a parameter of the machine, in place of its default and of what a
                           script sets; can be repeated
  --max-steps=N            give up on a script after N steps (default 1000000)
  --seed=N                 the seed of the scripts' random numbers, from 0 (default: that of each
                           script, else 0)
  --junit=FILE             write the results as JUnit XML
  --tap                    print the results in the Test Anything Protocol
  --coverage               measure which transitions, statements, guards, conditions, windows,
                           states and parameters the scripts test
  --coverage-data=FILE     write the counts to FILE, as .cov; later calls accept such files as
                           arguments and add them
  --coverage-json=FILE     write each place with its count as JSON
  --coverage-lcov=FILE     write lines and branches for genhtml and CI servers, as lcov does
  --traceability=FILE      write where each requirement is implemented and tested, and which
                           requirements each part of the machine has: as CSV, or as JSON if FILE
                           ends in .json
  --min-coverage=LIST      fail below a percentage, as in transitions:100,conditions:90, and list
                           what is missing
  --prove                  with --traceability: also decide whether any run can violate a
                           requirement, as smc prove does
  --message-format=FORMAT  the form of messages: text (default), json, or sarif if the command reads
                           sources
  --message-file=FILE      write the messages to FILE in that form, else as its name ends (.json,
                           .sarif); standard error then has text
  --color=WHEN             auto (default), always or never
  -w                       no warnings
  -WNAME                   -Wextra, -Wflight, -Weverything, -Wname, -Wno-name, -Werror, -Werror=name
