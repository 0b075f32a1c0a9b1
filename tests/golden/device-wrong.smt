# What is said before a board is asked.
args device
args device lst --port=nowhere
args device telephone --port=nowhere
args device list
args device list more --port=nowhere
args device list --port=nowhere
args device list --confirm

-- stderr --
smc: device wants to know what: info, list, confirm, erase or log
Try 'smc device --help'.
smc: 'lst' is nothing to ask a device; did you mean 'list'?
Try 'smc device --help'.
smc: 'telephone' is nothing to ask a device: info, list, confirm, erase or log is
Try 'smc device --help'.
smc: device wants --port, the serial line to the board, as in --port=/dev/ttyACM0
Try 'smc device --help'.
smc: device list takes nothing more than --port
Try 'smc device --help'.
smc: cannot open 'nowhere': No such file or directory
smc: option '--confirm' does not go with 'smc device'
Try 'smc device --help'.
-- exit --
2 2 2 2 2 3 2
