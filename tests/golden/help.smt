# --help lists the commands, on standard output.
args --help

-- stdout --
smc - state machines for rockets: checks them, tests them, compiles them to C and bytecode

Usage:
  smc build M.sm...|X.app [--sv V.sv] [--emit=KIND] [-o OUT]
      compile machines to bytecode, or to C with --emit=c; an application (.app) to C in a folder
  smc check FILE...|X.app [SCRIPT.ss...]
      report everything that can be found without running
  smc test M.sm|X.app SCRIPT.ss... [R.rq...] [--sv V.sv] [--engine=ENGINE]
      run state scripts and judge requirements; run .smt cases and folders of them
  smc report M.sm|X.app [SCRIPT.ss...] [R.rq...] [--sv V.sv] [--net X.net] [-o FILE.html]
      write one page about a machine, or an application with its machines, for a design review
  smc graph M.sm [SCRIPT.ss...] [--sv V.sv] [--format=FORMAT] [-o OUT]
      draw the state diagram, and where scripts have been in it, as SVG, for Graphviz or for Mermaid
  smc prove M.sm|X.app R.rq... [SCRIPT.ss...] [--sv V.sv] [--format=FORMAT] [-o OUT]
      decide for each requirement whether any run of the machine can violate it
  smc mutate M.sm|X.app SCRIPT.ss... [R.rq...] [--sv V.sv] [--min-score=PERCENT]
      change one number, operator, target or statement at a time, and list the changes that no script and no requirement notices
  smc diff OLD.sm NEW.sm [SCRIPT.ss...] [--sv V.sv] [--format=FORMAT] [-o OUT]
      compare what two machines do: states, transitions, outputs, costs and findings, and in scripts
  smc cover M.sm|X.app [SCRIPT.ss...] [--sv V.sv] -o FOLDER
      find inputs that reach what no script has tested, and write them as scripts into a folder
  smc faults M.sm|X.app SCRIPT.ss... [R.rq...] [--sv V.sv] [--pairs] [--scripts=DIR]
      make each input faulty in each way, beginning in each state and at each transition, and list what that does to the runs of scripts
  smc sweep M.sm|X.app SCRIPT.ss... [R.rq...] --set NAME=LO:HI:N [--set NAME=LO:HI:N] [--sv V.sv]
      run the scripts with one or two parameters at many values, and show where asserts and requirements begin to fail
  smc why M.sm|X.app SCRIPT.ss [R.rq...] [--at TIME] [--to STATE | --of NAME]
      explain a step of a script: its guards and their values, how the machine got there, and what would have changed it
  smc disasm IMAGE
      print the instructions of an image
  smc verify IMAGE
      run the device's own checks on an image
  smc set IMAGE [NAME=VALUE... -o OUT]
      list the parameters of an image, or set some of them
  smc sign IMAGE --key=FILE [--number=N] [-o OUT]
      put the code of a key and a number into an image, for boards that take no others
  smc key FILE
      make a new key, for smc sign and for the firmware of boards
  smc log FILE [ELEMENT...] [--format=FORMAT] [-o OUT]
      show what a flight log holds, in words, as a table or as a plot
  smc flash IMAGE --port=PORT [--confirm]
      put an image on a running board, over a serial line
  smc swap FILE...|NAME=FILE...|NAME=built-in... --to=WHERE --restart[=STATE]|--continue
      replace machines of an application that runs, without stopping it
  smc device info|list|parameters|set|confirm|erase|log --port=PORT
      ask a board or an application what it runs and what happened; set parameters; keep or erase its images
  smc emit-dictionary X.net --sv V.sv [--format=FORMAT] [-o OUT]
      write the bytes of every message as JSON, a C header, a Python module or XTCE, for programs on other computers
  smc fix FILE... [--sv V.sv]
      make the edits that the findings of check propose with certainty
  smc explain CODE...
      print the page of a diagnostic, by its code (E0204) or a warning's name (dead-code)

'smc COMMAND --help' lists a command's options.
