# Errors that are reported before the board is contacted.
args device
args device lst --port=nowhere
args device telephone --port=nowhere
args device list
args device list more --port=nowhere
args device list --port=nowhere
args device list --confirm

-- stderr --
smc: device requires an action: info, list, confirm, erase or log
Try 'smc device --help'.
smc: 'lst' is not an action of smc device; did you mean 'list'?
Try 'smc device --help'.
smc: 'telephone' is not an action of smc device: they are info, list, confirm, erase and log
Try 'smc device --help'.
smc: device requires --port, the serial line to the board, as in --port=/dev/ttyACM0
Try 'smc device --help'.
smc: device list accepts nothing but --port
Try 'smc device --help'.
smc: cannot open 'nowhere': No such file or directory
smc: option '--confirm' is not an option of 'smc device'
Try 'smc device --help'.
-- exit --
2 2 2 2 2 3 2
