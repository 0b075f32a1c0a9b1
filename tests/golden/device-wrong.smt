# Errors that are reported before the board is contacted.
args device
args device lst --port=nowhere
args device telephone --port=nowhere
args device list
args device list more --port=nowhere
args device list --port=nowhere
args device list --confirm
args device set --port=nowhere
args device set limit --port=nowhere
args device set limit=3 --port=nowhere
args device parameters limit=3 --port=nowhere

-- stderr --
smc: device requires an action: info, list, parameters, set, confirm, erase or log
Try 'smc device --help'.
smc: 'lst' is not an action of smc device; did you mean 'list'?
Try 'smc device --help'.
smc: 'telephone' is not an action of smc device: they are info, list, parameters, set, confirm, erase and log
Try 'smc device --help'.
smc: device requires --port, the serial line to the board, as in --port=/dev/ttyACM0
Try 'smc device --help'.
smc: device list accepts nothing but --port
Try 'smc device --help'.
smc: cannot open 'nowhere': No such file or directory
smc: device list does not accept --confirm and --dry-run, device set does
Try 'smc device --help'.
smc: device set requires parameters and their values, as in 'smc device set limit=40 --port=/dev/ttyACM0'
Try 'smc device --help'.
smc: expected the name of a parameter and its value, as in limit=40, not 'limit'
Try 'smc device --help'.
smc: cannot open 'nowhere': No such file or directory
smc: device parameters accepts nothing but --port
Try 'smc device --help'.
-- exit --
2 2 2 2 2 3 2 2 2 3 2
